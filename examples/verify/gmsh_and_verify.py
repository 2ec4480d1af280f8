"""Mesh Chile with Gmsh and write chile.msh, for `bern-exact verify chile.msh --polygon ...`.

pip install bern_exact gmsh
python gmsh_and_verify.py ../ne_chile_50m.json
"""

import sys

import gmsh

from bern_exact import Polygon

(exact,) = Polygon.load(sys.argv[1]).coordinates
ring = [(float(x), float(y)) for x, y in exact]
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
points = [gmsh.model.geo.addPoint(x, y, 0) for x, y in ring]
lines = [gmsh.model.geo.addLine(points[i - 1], points[i]) for i in range(len(points))]
loop = gmsh.model.geo.addCurveLoop(lines)
gmsh.model.geo.addPlaneSurface([loop])
gmsh.model.geo.synchronize()
gmsh.model.mesh.generate(2)
gmsh.write("chile.msh")
gmsh.finalize()
