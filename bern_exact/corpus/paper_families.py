"""The paper's own examples as families."""

from __future__ import annotations

from bern_exact.corpus import paper
from bern_exact.corpus.draws import Rings
from bern_exact.corpus.family import Family, without_random


def thin_rectangle(digits: int) -> Rings:
    """Mitchell's rectangle of 2 k by 1 with two subdivision points, k = 10^digits."""
    return paper.thin_rectangle(10**digits)


FAMILIES = (
    Family(
        "paper-regular",
        "triangulations without a Steiner point at the centre: Mitchell's regular polygon, "
        "rounded to integers (Section 2)",
        ("convex", "listed"),
        {"n": (5, 12)},
        without_random(paper.regular_polygon),
    ),
    Family(
        "paper-rectangle",
        "heights that fall with the aspect ratio: Mitchell's thin rectangle with two subdivision "
        "points side by side (Section 2)",
        ("convex", "flat-vertices", "axis-parallel", "slender", "listed"),
        {"digits": (3, 8)},
        without_random(thin_rectangle),
    ),
    Family(
        "paper-holes",
        "matching partitions that hope for O(n): the turned grid of tiny holes that needs n^1.5 "
        "(Section 3.2)",
        ("holes", "rectilinear", "listed"),
        {"side": (1, 2)},
        without_random(paper.hole_grid),
    ),
)
