// A constrained Delaunay triangulation by CGAL, as an OFF file for `bern-exact verify`.
//
//     g++ -O2 cgal_cdt.cpp -o cgal_cdt -lgmp -lmpfr
//     tr -d 'A-Z()' < ring.wkt | tr ',' '\n' | ./cgal_cdt > ring.off    # a simple polygon as WKT

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

// The faces that cannot be reached from outside without crossing a constraint.
std::vector<Mesh::Face_handle> inside(const Mesh& mesh) {
  std::set<Mesh::Face_handle> outside{mesh.infinite_face()};
  std::vector<Mesh::Face_handle> stack(outside.begin(), outside.end()), found;
  while (!stack.empty()) {
    auto face = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i)
      if (!face->is_constrained(i) && outside.insert(face->neighbor(i)).second)
        stack.push_back(face->neighbor(i));
  }
  for (auto face : mesh.finite_face_handles())
    if (!outside.count(face)) found.push_back(face);
  return found;
}

int main() {
  std::vector<Kernel::Point_2> ring;
  for (double x, y; std::cin >> x >> y;) ring.emplace_back(x, y);
  Mesh mesh;
  if (!(ring.size() > 1 && ring.front() == ring.back())) ring.push_back(ring.front());
  mesh.insert_constraint(ring.begin(), ring.end());
  const auto faces = inside(mesh);

  std::map<Mesh::Vertex_handle, int> number;
  std::cout << "OFF\n" << mesh.number_of_vertices() << ' ' << faces.size() << " 0\n"
            << std::setprecision(17);
  for (auto vertex : mesh.finite_vertex_handles()) {
    number.emplace(vertex, int(number.size()));
    std::cout << vertex->point() << " 0\n";
  }
  for (auto face : faces)
    std::cout << "3 " << number[face->vertex(0)] << ' ' << number[face->vertex(1)] << ' '
              << number[face->vertex(2)] << '\n';
}
