"""What Theorems 2 and 3 share: the faces along the boundary, and the rectangles inside."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from gmpy2 import mpq

from bern_exact.boundary.merge import Objective, merge_boundary, nodes_on_edge
from bern_exact.boundary.records import MergedMesh, Node
from bern_exact.checkers.definition_2 import check_definition_2
from bern_exact.checkers.findings import Finding
from bern_exact.checkers.lemma_4 import check_lemma_4
from bern_exact.checkers.lemma_5 import check_lemma_5
from bern_exact.checkers.lemma_7 import check_lemma_7
from bern_exact.checkers.printed_ends import check_merged_as_printed
from bern_exact.checkers.warping import check_faces
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.rectilinear import interior
from bern_exact.interior.subdivided.records import Partition, Tiled
from bern_exact.interior.subdivided.rectangle import tile
from bern_exact.oracle.fast import verify_mesh
from bern_exact.plane.polygon import Polygon
from bern_exact.theorems.assemble import (
    MERGED,
    RECTANGLE,
    Assembled,
    Place,
    Tagged,
    assemble,
    boundary_triangles,
)
from bern_exact.theorems.prepare import Prepared
from bern_exact.theorems.stages import Log

InteriorTriangle = tuple[int, Sequence[Place]]
"""(class, triangle) of Q, in grid units."""


def treat_boundary(
    prepared: Prepared, log: Log, tau: mpq, objective: Objective
) -> tuple[MergedMesh, Rectilinear]:
    """Merge and project along the boundary (Lemmas 4 and 5); Q is what is left."""
    merged = merge_boundary(prepared.warped, prepared.warping, prepared.tracer, tau, objective)
    log.done("merged", merged)
    region = interior(face.ring for face in merged.touched)
    log.done("interior", region)
    if log.every_stage:
        log.demand(check_lemma_4(merged, tau=tau))
        log.demand(check_lemma_5(merged, tau=tau))
        log.demand(check_faces(merged, region, tau=tau))
        log.demand(check_definition_2(region))
    if log.as_printed:
        log.demand(check_merged_as_printed(merged, tau=tau))
    return merged, region


def tile_rectangles(partition: Partition, log: Log) -> Tiled:
    """Triangulate every rectangle of the partition (Lemma 7)."""
    tiled = tile(partition)
    log.done("tiled", tiled)
    if log.every_stage:
        log.demand(check_lemma_7(tiled))
    return tiled


def put_together(
    prepared: Prepared, merged: MergedMesh, interior: Iterable[InteriorTriangle], log: Log
) -> Assembled:
    """The mesh in the input's coordinates."""
    assembled = assemble(
        prepared.warped,
        [*boundary_triangles(merged.faces), *_projected_triangles(merged)],
        interior,
        _nodes_on_cuts(merged),
        merged.projections,
    )
    log.done("mesh", assembled)
    return assembled


def judged(
    check_theorem: Callable[..., list[Finding]],
    polygon: Polygon,
    prepared: Prepared,
    merged: MergedMesh,
    assembled: Assembled,
    tau: mpq,
    max_angle: AngleBound,
) -> list[Finding]:
    """The theorem's own claims on the finished mesh, with the judge's verdict on it."""
    return check_theorem(
        polygon,
        assembled.mesh,
        prepared.framed,
        prepared.feature,
        verify_mesh(assembled.mesh, polygon),
        merged,
        tau=tau,
        angle_bound=max_angle,
    )


def _projected_triangles(merged: MergedMesh) -> Iterator[Tagged]:
    """The triangles of merged faces."""
    for face in merged.projected:
        for _, triangles in face.pieces:
            for triangle in triangles:
                yield MERGED, triangle


def rectangle_triangles(tiled: Tiled) -> Iterator[InteriorTriangle]:
    """The triangles of all rectangles, in grid units."""
    for tiling in tiled.tilings:
        for triangle in tiling.triangles:
            yield RECTANGLE, tuple((_half(x), _half(y)) for x, y in triangle)


def _half(doubled: int) -> int | mpq:
    """Half of an integer, as an integer where it is one: grid vertices are pairs of int."""
    return mpq(doubled, 2) if doubled % 2 else doubled // 2


def _nodes_on_cuts(merged: MergedMesh) -> Mapping[int, list[Node]]:
    """For each cut edge of P' its final nodes: merged faces have traded some for projections."""
    cuts = merged.warped.traced.diced.framed.lopped.cuts
    on_cuts = {cut.before: nodes_on_edge(merged.warped, cut.before) for cut in cuts}
    for face in merged.projected:
        nodes = on_cuts.get(face.merged.edge)
        if nodes is not None:
            base = face.merged.base
            start, end = nodes.index(base[0]), nodes.index(base[-1])
            nodes[start + 1 : end] = [projection for _, projection in face.cuts]
    return on_cuts
