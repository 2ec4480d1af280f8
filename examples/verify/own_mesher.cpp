// A mesher of one's own, and its verdict by exit code.
//
//     g++ -std=c++17 own_mesher.cpp -o own_mesher && ./own_mesher

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>

int main() {
  const double ring[][2] = {{0, 0}, {0.3, -0.1}, {1, 0}, {1.2, 0.7}, {0.5, 1.1}};
  const int n = 5;
  std::ofstream off("own.off"), wkt("own.wkt");
  off << std::setprecision(17) << "OFF\n" << n << ' ' << n - 2 << " 0\n";
  wkt << std::setprecision(17) << "POLYGON ((";
  for (auto& p : ring) off << p[0] << ' ' << p[1] << " 0\n";
  for (auto& p : ring) wkt << p[0] << ' ' << p[1] << ", ";
  wkt << ring[0][0] << ' ' << ring[0][1] << "))\n";
  for (int i = 1; i + 1 < n; ++i) off << "3 0 " << i << ' ' << i + 1 << '\n';
  off.close();
  wkt.close();
  const char* command =
      "bern-exact verify own.off --polygon own.wkt --numbers binary64 --max-angle 150";
  return std::system(command) == 0 ? 0 : 1;  // 0: valid; 1: not; 3: unreadable
}
