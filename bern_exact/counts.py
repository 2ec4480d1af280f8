"""How much each stage made, for the certificate."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from bern_exact.boundary.records import BoundaryMesh, Diced, Lopped, MergedMesh, Traced, Warped
from bern_exact.convex.block_records import Blocks, Reduced
from bern_exact.convex.records import Bounced, Gridded
from bern_exact.interior.records import Rectilinear, Swept
from bern_exact.interior.subdivided.records import Partition, Tiled
from bern_exact.theorems.assemble import Assembled
from bern_exact.thinning.records import Thinned


def stage_counts(records: Mapping[str, object]) -> dict[str, dict[str, int]]:
    """For each stage whose record has something to count, the numbers.

    Parameters
    ----------
    records : mapping
        Stage records by name, in order.
    """
    counted = {name: _COUNTS.get(type(record)) for name, record in records.items()}
    return {name: count(records[name]) for name, count in counted.items() if count is not None}


def _lopped(record: Lopped) -> dict[str, int]:
    return {"vertices": record.lopped.n, "cuts": len(record.cuts)}


def _diced(record: Diced) -> dict[str, int]:
    return {
        "intervals": len(record.vertical) + len(record.horizontal),
        "crossings": len(record.crossings),
        "lines": len(record.xs) + len(record.ys),
    }


def _traced(record: Traced) -> dict[str, int]:
    return {"faces": len(record.faces)}


def _warped(record: Warped) -> dict[str, int]:
    # A block of four squares has no other corner to take: there 135 degrees were given up.
    square = record.traced.diced.framed.blocks == "square"
    return {
        "moved_grid_vertices": len(record.moved),
        "moved_instances": len(record.instances),
        "corners_not_closest" if square else "blocks_above_135": sum(
            rank > 0 for rank in record.rank
        ),
    }


def _boundary(record: BoundaryMesh) -> dict[str, int]:
    return {
        "faces": len(record.faces),
        "triangles": sum(len(face.triangles) for face in record.faces),
    }


def _interior(record: Rectilinear) -> dict[str, int]:
    return {"loops": len(record.loops), "edges": record.edges}


def _swept(record: Swept) -> dict[str, int]:
    return {
        "columns": len(record.columns),
        "added": len(record.added),
        "triangles": sum(len(column.triangles) for column in record.columns),
    }


def _merged(record: MergedMesh) -> dict[str, int]:
    pieces = [triangles for face in record.projected for _, triangles in face.pieces]
    return {
        "merged_faces": len(record.projected),
        "projections": len(record.projections),
        "other_faces": len(record.faces),
        "triangles": sum(map(len, pieces)) + sum(len(face.triangles) for face in record.faces),
    }


def _partition(record: Partition) -> dict[str, int]:
    return {"rectangles": len(record.rectangles)}


def _tiled(record: Tiled) -> dict[str, int]:
    return {
        "added": sum(len(tiling.steiner) for tiling in record.tilings),
        "triangles": sum(len(tiling.triangles) for tiling in record.tilings),
    }


def _bounced(record: Bounced) -> dict[str, int]:
    return {
        "verticals": len(record.verticals),
        "subdivisions": len(record.first),
        "half_steps": len(record.steps),
        "turned": sum(step.stays is None for step in record.steps),
        "closed_paths": len(record.closed),
        "bits": record.bits,
    }


def _gridded(record: Gridded) -> dict[str, int]:
    return {
        "columns": len(record.cells.low),
        "rows": len(record.cells.ys) - 1,
        "cells": record.cells.number,
        "rim_triangles": sum(len(leg.triangles) for leg in record.legs),
        "baseline_triangles": 2 * record.cells.number
        + sum(len(leg.triangles) for leg in record.legs),
    }


def _blocks(record: Blocks) -> dict[str, int]:
    return {"blocks": len(record.blocks)}


def _reduced(record: Reduced) -> dict[str, int]:
    nodes = [node for block in record.blocks for node in block.nodes]
    return {
        "nodes": len(nodes),
        "removed": sum(len(node.removed) for node in nodes),
        "triangles": record.number,
    }


def _mesh(record: Assembled) -> dict[str, int]:
    return {"vertices": len(record.mesh.vertices), "triangles": len(record.mesh.triangles)}


def _thinned(record: Thinned) -> dict[str, int]:
    return {"removed": record.removed, "triangles": len(record.mesh.triangles)}


_COUNTS: dict[type, Callable[[Any], dict[str, int]]] = {
    Lopped: _lopped,
    Diced: _diced,
    Traced: _traced,
    Warped: _warped,
    BoundaryMesh: _boundary,
    MergedMesh: _merged,
    Partition: _partition,
    Tiled: _tiled,
    Rectilinear: _interior,
    Swept: _swept,
    Bounced: _bounced,
    Gridded: _gridded,
    Blocks: _blocks,
    Reduced: _reduced,
    Assembled: _mesh,
    Thinned: _thinned,
}
