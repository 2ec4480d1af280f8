"""The polygons of the comparison, by the family."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from bern_exact.corpus import shapes, slits
from bern_exact.corpus.paper import regular_polygon
from bern_exact.exact.points import grid_point
from bern_exact.plane.polygon import Polygon
from bern_exact.plane.validation import polygon_from_rings

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parent.parent / "examples"
STAR_400 = HERE.parent / "data" / "star400.json"

SIZES = (100, 300, 1000, 3000, 10_000)
ASPECTS = tuple(10**k for k in range(1, 7))
TEETH = 10

FAMILIES = {
    "outline": "real outlines (`examples/`)",
    "star": "random stars of n vertices; `star400` is a fixed one (`benchmarks/data/`)",
    "bar": "the rectangle of 1 by A",
    "slit": "two square holes with a slit of width 1/A between them",
    "spike": "a square with a spike on it, 2 wide and A high",
    "comb": f"a comb of {TEETH} teeth, 1 wide and A long",
    "holes": "a square with tilted square holes, n vertices in all",
    "regular": "the regular n-gon",
}
"""Family -> what it is, in the order of the tables."""

Rings = Callable[[int], list[shapes.Ring]]

THIN: Mapping[str, Rings] = {
    "bar": slits.bar,
    "slit": slits.slit,
    "spike": slits.spike,
    "comb": lambda aspect: slits.comb(TEETH, aspect),
}
ROUND: Mapping[str, Rings] = {
    "holes": lambda n: shapes.plate(n, seed=1),
    "regular": regular_polygon,
}


@dataclass(frozen=True)
class Case:
    """One polygon, made when it is wanted.

    Parameters
    ----------
    name : str
        For tables and files.
    family : str
        A key of `FAMILIES`.
    size : int
        n, or A; of a real outline 0.
    make : callable
        Makes the polygon.
    """

    name: str
    family: str
    size: int
    make: Callable[[], Polygon]


def every_case() -> list[Case]:
    """All of them."""
    return [
        *_outlines(),
        *_stars(SIZES),
        *_thin("bar", ASPECTS),
        *_thin("slit", ASPECTS),
        *_thin("spike", ASPECTS[::2]),
        *_thin("comb", (10, 100, 10_000)),
        *_round("holes", (100, 1000)),
        *_round("regular", (100, 1000)),
    ]


def quick_cases() -> list[Case]:
    """Few and small ones."""
    return [
        *(case for case in _outlines() if case.name == "us_county_51015_augusta"),
        *(case for case in _stars(SIZES) if case.size == SIZES[0]),
        *_thin("bar", (100,)),
        *_thin("slit", (100,)),
    ]


def _outlines() -> Iterator[Case]:
    for path in sorted(EXAMPLES.glob("*.json")):
        yield Case(path.stem, "outline", 0, partial(Polygon.load, path))


def _stars(sizes: Sequence[int]) -> Iterator[Case]:
    yield Case("star400", "star", 400, lambda: Polygon.load(STAR_400))
    for n in sizes:
        yield Case(f"star {n}", "star", n, partial(_made, _star, n))


def _thin(family: str, aspects: Sequence[int]) -> Iterator[Case]:
    """Few vertices, any aspect ratio."""
    rings = THIN[family]
    for a in aspects:
        name = f"{family} 10^{len(str(a)) - 1}"
        yield Case(name, family, a, partial(_made, rings, a))


def _round(family: str, sizes: Sequence[int]) -> Iterator[Case]:
    """Many vertices, no thin place."""
    rings = ROUND[family]
    for n in sizes:
        yield Case(f"{family} {n}", family, n, partial(_made, rings, n))


def _star(n: int) -> list[shapes.Ring]:
    return shapes.star(n, seed=1)


def _made(rings: Rings, size: int) -> Polygon:
    """A member of a family, validated."""
    return polygon_from_rings([[grid_point(x, y) for x, y in ring] for ring in rings(size)])
