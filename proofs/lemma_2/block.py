"""The block of v before warping, by the types of its rays: which faces dicing leaves in it."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

from proofs.lemma_2.rays import Cross, E, F, GridNode, RayType, crossings

UP, LEFT, DOWN, RIGHT = range(4)
"""Where f goes while e goes up: also the quarters by which f's frame is turned."""

CORNERS: tuple[GridNode, ...] = ((0, 0), (0, 1), (1, 0), (1, 1))
"""The corners of the square of v."""

Segment = tuple[GridNode, GridNode]
"""A unit segment, from its lower or left end."""

Node = int | GridNode
"""-1 for v, i for the q-vertex i, or a grid vertex."""

Path = list[tuple[Cross, GridNode]]
"""The q-vertices of a ray from v outwards, each with the cell that is entered there."""

Chord = tuple[int, int]
"""The q-vertices where a ray enters and leaves a cell; -1 for v."""

SIDES: tuple[Segment, ...] = (
    ((0, 0), (1, 0)),
    ((1, 0), (1, 1)),
    ((0, 1), (1, 1)),
    ((0, 0), (0, 1)),
)
"""The sides of a cell, counter-clockwise from its lower left corner, each from its lower end."""


@dataclass(frozen=True)
class Block:
    """The block of v before warping.

    Parameters
    ----------
    crosses : list of Cross
        The q-vertices of e, then of f, each from v outwards.
    faces : list of rings of Node
        The cells within the wedge, counter-clockwise.
    inside : set of GridNode
        The grid vertices of the block in the wedge.
    """

    crosses: list[Cross]
    faces: list[list[Node]]
    inside: frozenset[GridNode]

    def shared(self, i: int) -> int:
        """The q-vertex of the other ray on the same unit segment, or -1."""
        for j, q in enumerate(self.crosses):
            if q.ray != self.crosses[i].ray and q.segment == self.crosses[i].segment:
                return j
        return -1


def before(cls: int, segment: Segment) -> int:
    """Which ray crosses a segment first, going round v counter-clockwise, if both cross it.

    e and f are on both sides of it within 180 degrees: f comes first if it is at most
    180 degrees clockwise of e.
    """
    if cls == DOWN:
        # Both can only cross a column; the left ones are passed downwards, from e to f.
        return E if segment[0][0] <= 0 else F
    return E if cls == LEFT else F


def is_upwards(segment: Segment) -> bool:
    """Is a segment passed from its lower (left) end on, going round v counter-clockwise?"""
    (k, l), (k2, _) = segment  # noqa: E741
    return k >= 1 if k == k2 else l <= 0


def block(cls: int, kind_e: RayType, kind_f: RayType) -> Block | None:
    """The block before warping, or None if no two rays of this class have these types."""
    if not _signs_agree(cls, kind_e, kind_f):
        return None
    paths = [crossings(E, 0, kind_e), crossings(F, cls, kind_f)]
    crosses = [q for path in paths for q, _ in path]
    on_side = _on_segments(cls, crosses)
    if on_side is None:
        return None
    chords = _chords(paths)
    faces: list[list[Node]] = []
    for cell in product((-1, 0, 1), repeat=2):
        if cell in chords:
            rim = _rim(cell, on_side)
            traced = _faces_of(rim, chords[cell])
            if traced is None:
                return None
            faces += traced
    inside = _inside(cls, paths, on_side, faces)
    if inside is None:
        return None
    for cell in product((-1, 0, 1), repeat=2):
        square = [(cell[0] + i, cell[1] + j) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
        if cell not in chords and square[0] in inside:
            faces.append(list(square))
    return Block(crosses, faces, inside)


def _on_segments(cls: int, crosses: list[Cross]) -> dict[Segment, list[int]] | None:
    """The q-vertices on each unit segment of the block, from its lower end on.

    None if their parts are in another order than the rays.
    """
    on_side: dict[Segment, list[int]] = {}
    for i, q in enumerate(crosses):
        if q.inside:
            on_side.setdefault(q.segment, []).append(i)
    for segment, found in on_side.items():
        if len(found) == 2:
            if (before(cls, segment) == E) != is_upwards(segment):
                found.reverse()
            if crosses[found[0]].part > crosses[found[1]].part:
                return None
    return on_side


def _signs_agree(cls: int, e: RayType, f: RayType) -> bool:
    """Left of e implies left of f (m_e < m_f) for f up; the reverse for f left (m_f <= m_e)."""
    if cls == UP:
        return (
            (e.sign <= f.sign or 0 in (e.sign, f.sign))
            and e.section_1 <= f.section_1
            and e.section_2 <= f.section_2
        )
    if cls == LEFT:
        return f.sign <= e.sign or 0 in (e.sign, f.sign)
    return True


def _chords(paths: list[Path]) -> dict[GridNode, list[tuple[int, Chord]]]:
    """For each cell of the block that rays pass through, the rays and their chords."""
    chords: dict[GridNode, list[tuple[int, Chord]]] = {}
    number = 0
    for ray, path in enumerate(paths):
        cell, at = (0, 0), -1
        for _, enters in path:
            if all(-1 <= c <= 1 for c in cell):
                chords.setdefault(cell, []).append((ray, (at, number)))
            cell, at = enters, number
            number += 1
    return chords


def _rim(cell: GridNode, on_side: dict[Segment, list[int]]) -> list[Node]:
    """The nodes of a cell's boundary, counter-clockwise from its lower left corner."""
    rim: list[Node] = []
    for number, side in enumerate(SIDES):
        (i, j), (k, m) = side
        segment = (cell[0] + i, cell[1] + j), (cell[0] + k, cell[1] + m)
        found = on_side.get(segment, [])
        if number < 2:
            rim += [segment[0], *found]
        else:
            rim += [segment[1], *found[::-1]]
    return rim


def _faces_of(rim: list[Node], chords: list[tuple[int, Chord]]) -> list[list[Node]] | None:
    """The faces within the wedge of a cell that rays pass through; None if chords cross."""
    place = {node: i for i, node in enumerate(rim)}
    through = [chord for _, chord in chords if chord[0] >= 0]
    if len(through) == 2:
        (a, b), (c, d) = (sorted(place[q] for q in chord) for chord in through)
        if (a < c < b) != (a < d < b):
            return None
    onward = _onward(dict(chords))
    faces, seen = [], set()
    for start in onward:
        if start not in seen:
            face = _face(start, rim, place, onward)
            if face is None:
                return None
            seen.update(face)
            faces.append(face)
    return faces


def _onward(chords: dict[int, Chord]) -> dict[int, list[Node]]:
    """From a q-vertex, with the interior on the left, along a ray: what comes next."""
    enter_e, leave_e = chords.get(E, (0, 0))
    if enter_e < 0:  # the square of v: along f to v, and along e from it
        return {chords[F][1]: [-1, leave_e]}
    onward: dict[int, list[Node]] = {}
    for ray, (enter, leave) in chords.items():
        first, second = (enter, leave) if ray == E else (leave, enter)
        onward[first] = [second]
    return onward


def _face(
    start: int, rim: list[Node], place: dict[Node, int], onward: dict[int, list[Node]]
) -> list[Node] | None:
    """The face from a q-vertex on; None if it meets a ray from the exterior side."""
    face: list[Node] = [start, *onward[start]]
    while True:
        node = rim[(place[face[-1]] + 1) % len(rim)]
        if node == start:
            return face
        if isinstance(node, int):
            if node not in onward or node in face:
                return None
            face += [node, *onward[node]]
        else:
            face.append(node)


def _inside(
    cls: int,
    paths: list[Path],
    on_side: dict[Segment, list[int]],
    faces: list[list[Node]],
) -> frozenset[GridNode] | None:
    """The grid vertices in the wedge: those of the central face, and on over unit segments."""
    if not _is_in_order(cls, paths[E][0][0].segment, paths[F][0][0].segment):
        return None
    corners = next({n for n in face if not isinstance(n, int)} for face in faces if -1 in face)
    known = {corner: corner in corners for corner in CORNERS}
    queue = list(CORNERS)
    for node in queue:
        for i, j in ((1, 0), (0, 1), (-1, 0), (0, -1)):
            other = (node[0] + i, node[1] + j)
            if not all(-1 <= c <= 2 for c in other):
                continue
            odd = len(on_side.get((min(node, other), max(node, other)), ())) % 2 == 1
            if other in known:
                if known[other] != (known[node] != odd):
                    return None
            else:
                known[other] = known[node] != odd
                queue.append(other)
    return frozenset(node for node, is_in in known.items() if is_in)


def _is_in_order(cls: int, side_e: Segment, side_f: Segment) -> bool:
    """Do the sides by which the rays leave the square of v agree with the class of f?"""
    if cls == DOWN:
        return True
    bottom, right, top, left = (
        ((0, 0), (1, 0)),
        ((1, 0), (1, 1)),
        ((0, 1), (1, 1)),
        ((0, 0), (0, 1)),
    )
    if cls == LEFT:
        order = [right, top, left, bottom]
        return order.index(side_e) <= order.index(side_f)
    order = [bottom, right, top, left]
    return order.index(side_f) <= order.index(side_e)
