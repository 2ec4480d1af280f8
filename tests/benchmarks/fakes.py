"""Meshers that stand in for real ones, good and bad."""

from __future__ import annotations

import os
import signal

from benchmarks.peers.floats import mesh_of_floats
from benchmarks.peers.meshers import Clock
from bern_exact.plane.mesh import Mesh
from bern_exact.plane.polygon import Polygon

SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]


def good(polygon: Polygon, clock: Clock) -> Mesh:
    """The unit square by a diagonal, whatever is asked for."""
    with clock:
        return mesh_of_floats(SQUARE, [(0, 1, 2), (0, 2, 3)])


def looping(polygon: Polygon, clock: Clock) -> Mesh:
    """Never ends."""
    with clock:
        while True:
            pass


def crashing(polygon: Polygon, clock: Clock) -> Mesh:
    """Ends as compiled code does that reads where nothing is."""
    os.kill(os.getpid(), signal.SIGSEGV)
    raise SystemExit


def greedy(polygon: Polygon, clock: Clock) -> Mesh:
    """Wants more memory than there may be."""
    with clock:
        bytearray(1 << 40)
    raise SystemExit


def failing(polygon: Polygon, clock: Clock) -> Mesh:
    """Says that it cannot do it; and much besides, as libraries do."""
    print("a banner\n" * 3)
    raise ValueError("no mesh for this one")


def chatty(polygon: Polygon, clock: Clock) -> Mesh:
    """Prints, and is good."""
    print("a banner without an end of line", end="")
    return good(polygon, clock)
