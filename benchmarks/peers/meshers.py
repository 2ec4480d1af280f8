"""The meshers that are compared."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable
from dataclasses import dataclass

from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon


class Clock:
    """Measures a block in processor seconds, and ends the process when they pass the cap.

    The end is a signal (SIGPROF), which also reaches a loop in somebody's compiled code.
    """

    def __init__(self, cap: float) -> None:
        self.cap = cap
        self.seconds: float | None = None
        self._started = 0.0

    def __enter__(self) -> None:
        signal.setitimer(signal.ITIMER_PROF, self.cap)
        self._started = time.process_time()

    def __exit__(self, *_: object) -> None:
        self.seconds = time.process_time() - self._started
        signal.setitimer(signal.ITIMER_PROF, 0)


Meshing = Callable[[Polygon, Clock], Mesh]
"""Meshes a polygon, its own work (no conversions) within `with clock:`."""


@dataclass(frozen=True)
class Mesher:
    """One mesher with one setting.

    Parameters
    ----------
    name : str
        For records and the command line.
    title : str
        For tables.
    entry : str
        `module:function` of its `Meshing`; imported in a process of its own.
    package : str
        The PyPI package and the module that must import, as `package:module`; "" if it is ours.
    setting : str
        What is asked of it, in words.
    """

    name: str
    title: str
    entry: str
    package: str = ""
    setting: str = ""

    @property
    def is_ours(self) -> bool:
        """Is it this package?  Then it is given the exact polygon, and a cap of its own."""
        return not self.package


OURS = (
    Mesher(
        "raw",
        "ours raw",
        "benchmarks.peers.with_ours:raw",
        setting="Theorem 2's mesh, or 3's if there are holes",
    ),
    Mesher(
        "thin", "ours thinned", "benchmarks.peers.with_ours:thin", setting="the same with `--thin`"
    ),
)
"""Judged; their time is without checks."""

CHECKED = {
    "raw": Mesher("raw-checked", "ours raw", "benchmarks.peers.with_ours:raw_checked"),
    "thin": Mesher("thin-checked", "ours thinned", "benchmarks.peers.with_ours:thin_checked"),
}
"""The same with every check, for the time alone."""

PEERS = (
    Mesher(
        "triangle-15",
        "Triangle -pq15",
        "benchmarks.peers.with_triangle:pq15",
        "triangle:triangle",
        "asked for no angle below 15 degrees, which would mean none above 150",
    ),
    Mesher(
        "triangle-20",
        "Triangle -pq20",
        "benchmarks.peers.with_triangle:pq20",
        "triangle:triangle",
        "asked for no angle below 20 degrees, which would mean none above 140",
    ),
    Mesher(
        "cgal-15",
        "CGAL 15",
        "benchmarks.peers.with_cgal:least_15",
        "cgal:CGAL.CGAL_Mesh_2",
        "`refine_Delaunay_mesh_2` with aspect bound sin^2 15 degrees, which asks for the same",
    ),
    Mesher(
        "cgal-20",
        "CGAL 20.7",
        "benchmarks.peers.with_cgal:least_20",
        "cgal:CGAL.CGAL_Mesh_2",
        "with its default, 1/8, for no angle below 20.7, which would mean none above 138.6",
    ),
    Mesher(
        "gmsh-coarse",
        "Gmsh coarse",
        "benchmarks.peers.with_gmsh:coarse",
        "gmsh:gmsh",
        "2-D Delaunay as coarse as can be, no size asked for anywhere; no angle bound",
    ),
    Mesher(
        "gmsh-graded",
        "Gmsh graded",
        "benchmarks.peers.with_gmsh:graded",
        "gmsh:gmsh",
        "2-D Delaunay, sizes inside extended from the boundary, its default; no angle bound",
    ),
)
