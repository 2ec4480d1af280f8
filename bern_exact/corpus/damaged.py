"""The damaged meshes of a case: with what a correct verifier says of each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from hashlib import sha256
from itertools import islice
from typing import Any

from bern_exact.api import Result
from bern_exact.corpus.files import File
from bern_exact.formats import safe_json
from bern_exact.formats.mesh_json import mesh_document
from bern_exact.oracle.defects import DAMAGES, Damaged, damage
from bern_exact.plane.polygon import Polygon

EACH, LARGE, OF_LARGE = 4, 60, 2
"""How many damaged meshes a mesh gives; and one of more triangles than that."""


def damaged_meshes(
    header: Mapping[str, Any], polygon: Polygon, meshes: Mapping[str, Result]
) -> Iterator[File]:
    """The damaged meshes as files, and `defects.json`, which says what is wrong with which.

    Parameters
    ----------
    header : mapping
        The first members of `defects.json`, the case's id among them.
    polygon : Polygon
        What the meshes triangulate.
    meshes : mapping
        Each theorem's mesh by its name.

    Notes
    -----
    Which ways a mesh is damaged in rotates with the case: a hundred cases have all of them.
    """
    entries = []
    for name, result in meshes.items():
        start = _number(f"{header['seed']} {header['case']} {name}")
        each = EACH if len(result.mesh.triangles) <= LARGE else OF_LARGE
        for damaged in islice(_in_turn(result, polygon, start), each):
            title = f"{name}-{damaged.damage.name}"
            path = f"defects/{title}.mesh.json"
            yield File(path, safe_json.dumps(mesh_document(damaged.mesh, damaged.polygon)))
            entries.append(_entry(title, name, path, damaged))
    yield File("defects/defects.json", safe_json.dumps({**header, "defects": entries}))


def _entry(title: str, mesh: str, path: str, damaged: Damaged) -> dict[str, Any]:
    """What `defects.json` says of a damaged mesh."""
    record = damaged.to_json()
    way = record.pop("name")
    return {"name": title, "mesh": mesh, "file": path, "damage": way, **record}


def _number(text: str) -> int:
    """A number that a text decides, the same everywhere."""
    return int.from_bytes(sha256(text.encode("utf-8")).digest()[:6], "big")


def _in_turn(result: Result, polygon: Polygon, start: int) -> Iterator[Damaged]:
    """Every damage that the mesh can take, in an order that a number decides."""
    names = sorted(DAMAGES, key=lambda name: (_number(f"{start} {name}"), name))
    for name in names:
        damaged = damage(result.mesh, polygon, name, start)
        if damaged is not None:
            yield damaged
