// The oracle's work on CGAL's exact kernel, for comparison: `cgal_judge MESH.txt`.
//
// MESH.txt: "V T", then V lines "x y" (decimals are read as doubles, integers and p/q exactly), then
// T lines "a b c", 0-based.  Orientation of every triangle, directed edges without a reverse, the
// first triangle with the largest angle and the first with the least height, all exactly: a verdict
// on a mesh, but for the comparison of its boundary with a polygon.  Prints one line of JSON.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Exact = Kernel::Exact_kernel::FT;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;

static double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

static Number number(const std::string& text) {
    if (text.find('/') == std::string::npos) return Number(std::stod(text));
    std::istringstream stream(text);
    Exact value;
    stream >> value;
    return Number(value);
}

// The most memory that this process has had, in MiB; 0 where /proc does not tell.
static double peak() {
    std::ifstream status("/proc/self/status");
    std::string line;
    while (std::getline(status, line))
        if (line.rfind("VmHWM:", 0) == 0) return std::stod(line.substr(6)) / 1024;
    return 0;
}

struct Triangle {
    std::int64_t corner[3];
};

static std::size_t count_sides(const std::vector<Triangle>& triangles, std::int64_t size,
                               std::size_t& twice) {
    std::vector<std::int64_t> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& t : triangles)
        for (int k = 0; k < 3; ++k) edges.push_back(t.corner[k] * size + t.corner[(k + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    twice = 0;
    for (std::size_t i = 1; i < edges.size(); ++i) twice += edges[i] == edges[i - 1];
    std::size_t sides = 0;
    for (std::int64_t edge : edges) {
        const std::int64_t reverse = edge % size * size + edge / size;
        sides += !std::binary_search(edges.begin(), edges.end(), reverse);
    }
    return sides;
}

int main(int, char** arguments) {
    std::ios::sync_with_stdio(false);
    const double started = seconds();
    std::ifstream file(arguments[1]);
    std::int64_t size = 0, count = 0;
    file >> size >> count;
    std::vector<Point> points;
    points.reserve(size);
    std::string x, y;
    for (std::int64_t v = 0; v < size; ++v) {
        file >> x >> y;
        points.emplace_back(number(x), number(y));
    }
    std::vector<Triangle> triangles(count);
    for (Triangle& t : triangles) file >> t.corner[0] >> t.corner[1] >> t.corner[2];
    const double read = seconds();

    std::size_t twice = 0, clockwise = 0;
    const std::size_t sides = count_sides(triangles, size, twice);
    std::int64_t worst = -1, flattest = -1;
    Number dot = 0, cross = 1, square = 0, longest = 1;
    for (std::int64_t t = 0; t < count; ++t) {
        const std::int64_t* corner = triangles[t].corner;
        const Point &p = points[corner[0]], &q = points[corner[1]], &r = points[corner[2]];
        const CGAL::Orientation turn = CGAL::orientation(p, q, r);
        clockwise += turn != CGAL::COUNTERCLOCKWISE;
        if (turn == CGAL::COLLINEAR) continue;
        const Vector u = q - p, v = r - p, w = r - q;
        const Number at_p = u * v, at_q = -(u * w), at_r = v * w;
        const Number least = (std::min)({at_p, at_q, at_r});
        const Number area = CGAL::abs(CGAL::determinant(u, v));
        if (worst < 0 || least * cross < dot * area) worst = t, dot = least, cross = area;
        const Number edge = (std::max)({u.squared_length(), v.squared_length(), w.squared_length()});
        const Number height = area * area;
        if (flattest < 0 || height * longest < square * edge)
            flattest = t, square = height, longest = edge;
    }
    std::printf(
        "{\"read\": %.3f, \"judged\": %.3f, \"mib\": %.0f, \"clockwise\": %zu, \"twice\": %zu, "
        "\"sides\": %zu, \"worst\": %lld, \"flattest\": %lld}\n",
        read - started, seconds() - read, peak(), clockwise, twice, sides,
        static_cast<long long>(worst), static_cast<long long>(flattest));
    return 0;
}
