"""The processes of a comparison: one meshes, another judges.

    python -m benchmarks.peers.child probe ENTRY
    python -m benchmarks.peers.child mesh ENTRY POLYGON MESH CAP BYTES
    python -m benchmarks.peers.child judge POLYGON MESH

A mesher runs alone in its process, so that whatever it does to itself, looping, crashing or eating
all memory, is its own row.  Polygons and meshes are handed over as files of exact numbers, which
`bern-exact verify` and the lone judge read as well.  The last line on stdout is the result, JSON.
"""

from __future__ import annotations

import importlib
import json
import resource
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks.peers.judging import judged
from benchmarks.peers.meshers import Clock, Meshing
from bern_exact.formats import read_mesh_file
from bern_exact.formats.mesh_json import dumps_mesh
from bern_exact.plane.polygon import Polygon


def meshing(entry: str) -> Meshing:
    """The function that an entry `module:function` names."""
    module, _, name = entry.partition(":")
    found: Meshing = getattr(importlib.import_module(module), name)
    return found


def mesh(entry: str, polygon: Path, target: Path, cap: float, most: int) -> dict[str, Any]:
    """Mesh a polygon within `cap` processor seconds and `most` bytes; write the mesh."""
    mesher = meshing(entry)
    shape = Polygon.load(polygon)
    clock = Clock(cap)
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (most, hard))
    made = mesher(shape, clock)
    resource.setrlimit(resource.RLIMIT_AS, (hard, hard))
    target.write_text(dumps_mesh(made))
    return {
        "seconds": clock.seconds,
        "triangles": len(made.triangles),
        "mib": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024,
    }


def judge(polygon: Path, source: Path) -> dict[str, Any]:
    """Measure a mesh."""
    found, _ = read_mesh_file(source)
    return judged(found, Polygon.load(polygon)).to_json()


def main(arguments: Sequence[str]) -> None:
    """Do what the first argument says."""
    match arguments:
        case ["probe", entry]:
            meshing(entry)
            result: dict[str, Any] = {}
        case ["mesh", entry, polygon, target, cap, most]:
            result = mesh(entry, Path(polygon), Path(target), float(cap), int(most))
        case ["judge", polygon, source]:
            result = judge(Path(polygon), Path(source))
        case _:
            raise SystemExit(__doc__)
    print(f"\n{json.dumps(result)}")


if __name__ == "__main__":
    main(sys.argv[1:])
