"""Mesh Chile with Triangle, then ask exactly what Triangle returned.

pip install bern_exact triangle
python triangle_and_verify.py ../ne_chile_50m.json
"""

import sys

import numpy as np
import triangle

from bern_exact import Polygon, verify

(exact,) = Polygon.load(sys.argv[1]).coordinates
ring = np.array([[float(x), float(y)] for x, y in exact])
edges = [(i, (i + 1) % len(ring)) for i in range(len(ring))]
mesh = triangle.triangulate({"vertices": ring, "segments": edges}, "pq20")

verdict = verify(mesh["vertices"], mesh["triangles"], ring, tolerance=1e-9)
print(verdict)
print(f"{verdict.triangles_per_vertex} triangles a vertex; off its edges: {verdict.off_edge}")
