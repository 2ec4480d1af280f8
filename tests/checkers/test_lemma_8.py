"""What the checker of Lemma 8 alone decides; `test_lemma_6` damages the rest for both."""

from __future__ import annotations

from bern_exact.checkers.lemma_8 import check_lemma_8
from bern_exact.interior.records import Rectilinear
from bern_exact.interior.subdivided.records import Partition, SubdividedRectangle

UNIT = ((0, 0), (1, 0), (1, 1), (0, 1))


def apart(count: int) -> Partition:
    """Unit squares apart from each other, said to fill one unit square (N = 4, bound 16)."""
    squares = (SubdividedRectangle(2 * k, 2 * k + 1, 0, 1, (), (), (), ()) for k in range(count))
    return Partition(Rectilinear((UNIT,)), tuple(squares), (0,) * count)


def holds(partition: Partition) -> bool:
    (finding,) = [f for f in check_lemma_8(partition) if f.claim == "lemma-8.vertices"]
    return finding.holds


def test_the_bound_is_exact() -> None:
    assert holds(apart(4))
    assert not holds(apart(5))
