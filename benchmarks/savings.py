"""What each saving inside the construction saves, on the real outlines.

    python -m benchmarks.savings            # the tables on stdout, as Markdown
    python -m benchmarks.savings --write    # and put them into benchmarks/RESULTS.md

Up to the default each column has one saving more than the one before it.  What is off for an
earlier column is replaced here, as the package itself has no reason to be able to do without.
The interior is chosen by its triangles in all of them; the last table has that choice.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

from gmpy2 import mpq

from benchmarks.results import machine, write_section
from bern_exact import Polygon, Result, triangulate
from bern_exact.exact.similarity import Similarity

HERE = Path(__file__).parent
EXAMPLES = sorted((HERE.parent / "examples").glob("*.json"))
FRAME = "bern_exact.boundary.frame.rotation"
CELLS = "bern_exact.interior.subdivided.rectangle._cells_are_fewer"


def fixed_turn(polygon: Polygon, attempt: int) -> Similarity:
    """The same turn for every polygon, of about 0.1 degrees."""
    return Similarity.rotation(mpq(1, 1024 + attempt))


@contextmanager
def without(*targets: str) -> Iterator[None]:
    """The construction without some of its savings."""
    stand_ins: dict[str, Callable[..., object]] = {FRAME: fixed_turn, CELLS: lambda *_: False}
    with ExitStack() as stack:
        for target in targets:
            stack.enter_context(patch(target, stand_ins[target]))
        yield


Variant = Callable[[Polygon], Result]


def variant(*off: str, **options: Any) -> Variant:
    """A construction without some savings, by these options of `triangulate`."""

    def make(polygon: Polygon) -> Result:
        with without(*off):
            return triangulate(polygon, check="none", **options)

    return make


NO_LARGE_ANGLE = {
    # All diagonals of Lemma 5 but end ones, the fixed turn, Lemma 7 for every rectangle.
    "before": variant(FRAME, CELLS, theorem=3, objective="height"),
    "fewest diagonals": variant(FRAME, CELLS, theorem=3),
    "grid turned": variant(CELLS, theorem=3),
    "cells split (default)": variant(theorem=3),
    "`--blocks corner`": variant(theorem=3, blocks="corner"),
    "default, `--thin`": variant(theorem=3, thin=True),
}
"""Up to the default each has one saving more than the one before it."""

THEOREM_1 = {
    "before": variant(FRAME, theorem=1),
    "grid turned (default)": variant(theorem=1),
    "`--blocks corner`": variant(theorem=1, blocks="corner"),
    "default, `--thin`": variant(theorem=1, thin=True),
}


def interiors(polygon: Polygon) -> list[int]:
    """Triangles by each way to treat holes, the smallest last."""
    return [
        triangulate(polygon, theorem=3, interior=method, check="none").certificate.triangles
        for method in ("strips", "bridges", "best")
    ]


def table(variants: dict[str, Variant], polygons: Sequence[Polygon]) -> str:
    """Triangles a vertex and the least height over s, a row a polygon."""
    lines = [
        "| polygon | n | " + " | ".join(variants) + " |",
        "| --- | --: |" + " --: |" * len(variants),
    ]
    for polygon in polygons:
        entries = []
        for name, variant in variants.items():
            made = variant(polygon).certificate
            height = f"{float(made.height_ratio_squared) ** 0.5:.4f}"
            entries.append(f"{made.triangles / polygon.n:.2f} ({height})")
            print(polygon.name, name, entries[-1], file=sys.stderr, flush=True)
        lines.append(f"| {polygon.name} | {polygon.n} | {' | '.join(entries)} |")
    return "\n".join(lines)


def holes_table(polygons: Sequence[Polygon]) -> str:
    """Triangles a vertex by each way to treat holes."""
    lines = ["| polygon | n | holes | strips | bridges | best |", "| --- |" + " --: |" * 5]
    for polygon in polygons:
        if polygon.holes:
            counts = " | ".join(f"{count / polygon.n:.2f}" for count in interiors(polygon))
            lines.append(f"| {polygon.name} | {polygon.n} | {polygon.holes} | {counts} |")
    return "\n".join(lines)


def report(polygons: Sequence[Polygon]) -> str:
    """Everything."""
    return "\n\n".join(
        (
            f"{machine()}",
            "Triangles a vertex, and in brackets the least height over the feature size s. "
            "Up to the default each column has one saving more than the one before; blocks of "
            "2 x 2 squares are experimental.",
            "Theorem 2, or 3 with holes:",
            table(NO_LARGE_ANGLE, polygons),
            "Theorem 1:",
            table(THEOREM_1, polygons),
            "`--interior`: strips (Lemma 8), bridges, and for each component whichever is counted "
            "to be smallest, of Lemma 8 with five spacings and the bridges; triangles a vertex:",
            holes_table(polygons),
        )
    )


def main() -> None:
    """The command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--write", action="store_true", help="put it into benchmarks/RESULTS.md")
    parser.add_argument(
        "--to", type=int, default=10**9, help="polygons of at most so many vertices"
    )
    options = parser.parse_args()
    polygons = [polygon for path in EXAMPLES if (polygon := Polygon.load(path)).n <= options.to]
    text = report(polygons)
    print(text)
    if options.write:
        write_section(HERE / "RESULTS.md", "Savings inside the construction", text)


if __name__ == "__main__":
    main()
