"""The block program: what both warps make of the block of v, by the types of its rays.

It follows the rules of Section 2 as the package ships them: each q-vertex has an inner neighbour
and an anchor; v takes a corner; q-vertices nearer than tau choose grid vertices; each q-vertex
has its fate; the faces are mapped and split.  All of this depends on the types of both rays alone
but for two kinds of open questions, which are answered both ways (`Outcome`s, all of which must be
good): which of two rays' q-vertices is nearer to a grid vertex that both choose, and whether a
line just outside the block is kept for another vertex.

Points are symbols, which `points` evaluates over boxes and `exact` at one place:

- ("v",); ("g", k, l), a grid vertex;
- ("row", ray, level, part) and ("column", ray, level, column, part, clear), a q-vertex in place;
- ("slid", that, point, (k, l)): where the segment from a point to a grid vertex crosses its ray.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from proofs.lemma_2.block import CORNERS, Block
from proofs.lemma_2.rays import LOW, MIDDLE, E, F, GridNode

Point = tuple[Any, ...]
Ring = tuple[Point, ...]


class Outcome(NamedTuple):
    """The faces of the block after warping, by one answer to the open questions.

    Parameters
    ----------
    rings : tuple of Ring
        Counter-clockwise; unmoved squares are left out.
    """

    rings: tuple[Ring, ...]


class Warper:
    """Both warps for one corner and one answer to the open questions.

    Parameters
    ----------
    made : Block
        Before warping.
    corner : GridNode
        What v takes.
    answers : mapping
        (grid vertex) -> the ray whose q-vertex is nearer; ray -> is the line outside kept?
    """

    def __init__(self, made: Block, corner: GridNode, answers: dict[Any, int]) -> None:
        self.block = made
        self.corner = corner
        self.answers = answers
        self.asked: list[Any] = []
        self.wishes = [self._wish(i) for i in range(len(made.crosses))]
        self._fates: dict[int, Point] = {}

    def answer(self, question: Any) -> int:
        """The answer to an open question, which is noted."""
        if question not in self.asked:
            self.asked.append(question)
        return self.answers.get(question, 0)

    def inner(self, i: int) -> GridNode | None:
        """The inner neighbour, None if the interval ends on the other ray before any."""
        q = self.block.crosses[i]
        if q.inside and self.block.shared(i) >= 0 and q.inner not in self.block.inside:
            return None
        return q.inner

    def _wish(self, i: int) -> GridNode | tuple[int, GridNode] | None:
        q = self.block.crosses[i]
        if q.part == MIDDLE:
            return None
        near = q.segment[0] if q.part == LOW else q.segment[1]
        if near == q.anchor:
            return (q.ray, q.anchor)
        return self.inner(i)

    def is_free(self, i: int) -> bool:
        q = self.block.crosses[i]
        return self.corner != q.anchor and self.inner(i) != self.corner

    def is_kept(self, i: int) -> bool:
        """Is the q-vertex there?  Outside the block, with its inner neighbour outwards, perhaps."""
        q = self.block.crosses[i]
        if q.inside or all(-1 <= c <= 2 for c in q.inner):
            return True
        return bool(self.answer(q.ray))

    def chooser(self, place: GridNode | tuple[int, GridNode]) -> int:
        """The q-vertex that a place moves to in substep 2, or -1: the nearest free one.

        Of one ray's the one on a row of its frame is nearer, as |m| <= 1.
        """
        best = []
        for ray in (E, F):
            own = [
                i
                for i, wish in enumerate(self.wishes)
                if wish == place
                and self.block.crosses[i].ray == ray
                and self.is_free(i)
                and self.is_kept(i)
            ]
            own.sort(key=lambda i: self.block.crosses[i].kind != "row")
            best += own[:1]
        if len(best) == 2:
            return best[self.answer(place)]
        return best[0] if best else -1

    def grid_target(self, node: GridNode) -> int | GridNode:
        """v as -1, a q-vertex or the interior grid vertex itself."""
        if node == self.corner:
            return -1
        j = self.chooser(node)
        return node if j < 0 else j

    def instance_target(self, ray: int, node: GridNode) -> int | GridNode:
        """Likewise of an exterior instance."""
        if node == self.corner:
            return -1
        j = self.chooser((ray, node))
        return node if j < 0 else j

    def settled(self, target: int | GridNode) -> Point:
        """The point where a node ends that something has moved to."""
        if not isinstance(target, int):
            return ("g", *target)
        return ("v",) if target < 0 else self.fate(target)

    def in_place(self, i: int) -> Point:
        q = self.block.crosses[i]
        if q.kind == "row":
            return ("row", q.ray, q.level, q.own)
        return ("column", q.ray, q.level, q.column, q.own, q.clear)

    def fate(self, i: int) -> Point:
        """Where a q-vertex ends."""
        if i not in self._fates:
            self._fates[i] = self._fate(i)
        return self._fates[i]

    def _fate(self, i: int) -> Point:
        q, crosses = self.block.crosses[i], self.block.crosses
        g = self.inner(i)
        if not q.inside:
            return self.in_place(i)  # see the package's docstring
        if g is None:
            far = crosses[self.block.shared(i)]
            inner = self.instance_target(far.ray, far.anchor)
            if inner == -1:
                return ("v",)
        elif self.chooser(g) == i:
            return self.in_place(i)
        else:
            inner = self.grid_target(g)
            if inner == -1:
                return ("v",)
            if isinstance(inner, int) and crosses[inner].ray == q.ray:
                return self.settled(inner)
        outer = self.instance_target(q.ray, q.anchor)
        if isinstance(outer, int) and outer != i:
            return self.settled(outer)
        if isinstance(outer, int) or not isinstance(inner, int):
            return self.in_place(i)
        return ("slid", self.in_place(i), self.settled(inner), q.anchor)

    def image(self, node: int | GridNode) -> Point:
        if isinstance(node, int):
            return self.settled(node)
        return self.settled(self.grid_target(node))

    def rings(self) -> tuple[Ring, ...]:
        """The faces after warping but for unmoved squares, each from its least point on."""
        found = set()
        for face in self.block.faces:
            for ring in split([self.image(node) for node in face]):
                if not all(point[0] == "g" for point in ring):
                    least = ring.index(min(ring, key=repr))
                    found.add((*ring[least:], *ring[:least]))
        return tuple(sorted(found, key=repr))


Place = tuple[int | None, GridNode]
"""An instance of a ray, or, with None, an interior grid vertex."""


def wished(made: Block) -> dict[Place, int]:
    """How many q-vertices are near enough to a place to choose it, if they are free."""
    count: dict[Place, int] = {}
    for wish in Warper(made, CORNERS[0], {}).wishes:
        if wish is not None:
            ray, node = wish if isinstance(wish[1], tuple) else (None, wish)
            count[ray, node] = count.get((ray, node), 0) + 1
    return count


def crowded(made: Block) -> GridNode | None:
    """The interior grid vertex that more than two q-vertices would choose, if there is one."""
    found = [node for (ray, node), count in wished(made).items() if ray is None and count > 2]
    return found[0] if found else None


def split(images: list[Point]) -> Iterator[list[Point]]:
    """The rings of a mapped face: repeats dropped, split at repeated nodes, at least 3 long."""
    path: list[Point] = []
    for point in images:
        if point in path:
            start = path.index(point)
            loop = path[start:]
            del path[start + 1 :]
            if len(loop) > 2:
                yield loop
        else:
            path.append(point)
    if len(path) > 2:
        yield path


def outcomes(made: Block, corner: GridNode) -> list[Outcome]:
    """What may become of the block with this corner: one for each answer to the open questions."""
    found: dict[tuple[Ring, ...], None] = {}
    pending: list[dict[Any, int]] = [{}]
    while pending:
        answers = pending.pop()
        warper = Warper(made, corner, answers)
        found[warper.rings()] = None
        for question in warper.asked:
            if question not in answers:
                pending += [{**answers, question: 1}]
                answers = {**answers, question: 0}
    return [Outcome(rings) for rings in found]
