"""Write the tables of the block program for `search.cpp`: one text file for each class of f.

Usage: python -m proofs.lemma_2.search.tables DIRECTORY [crowded]
"""

from __future__ import annotations

import sys
from pathlib import Path

from proofs.lemma_2.block import CORNERS, block
from proofs.lemma_2.rays import ray_types
from proofs.lemma_2.warping import Point, crowded, outcomes

CODES = {"v": 0, "g": 1, "row": 2, "column": 3, "slid": 4}


def code(point: Point) -> list[int]:
    """A symbolic point as integers."""
    if point[0] == "slid":
        return [4, *code(point[1]), *code(point[2]), *point[3]]
    return [CODES[point[0]], *point[1:]]


def table(cls: int, only_crowded: bool) -> str:
    """The table of a class: types, rings, plans (by corner, outcomes of rings) and pairs.

    `only_crowded`: of crowded blocks alone, with the one corner that may then be taken.
    """
    types = ray_types()
    rings: dict[tuple[Point, ...], int] = {}
    plans: dict[tuple[tuple[tuple[int, ...], ...], ...], int] = {}
    pairs = []
    for i, kind_e in enumerate(types):
        for j, kind_f in enumerate(types):
            made = block(cls, kind_e, kind_f)
            if made is None:
                continue
            own = crowded(made)
            if only_crowded and own is None:
                continue
            plan = tuple(
                tuple(
                    sorted(
                        tuple(sorted(rings.setdefault(ring, len(rings)) for ring in found.rings))
                        for found in outcomes(made, own if only_crowded and own else corner)
                    )
                )
                for corner in CORNERS
            )
            pairs.append((i, j, plans.setdefault(plan, len(plans))))
    lines = [f"{len(types)}"]
    lines += [" ".join(map(str, kind)) for kind in types]
    lines.append(f"{len(rings)}")
    for ring in rings:
        lines.append(" ".join(map(str, [len(ring), *(n for point in ring for n in code(point))])))
    lines.append(f"{len(plans)}")
    for plan in plans:
        words = []
        for found in plan:
            words.append(len(found))
            for ids in found:
                words += [len(ids), *ids]
        lines.append(" ".join(map(str, words)))
    lines.append(f"{len(pairs)}")
    lines += [f"{i} {j} {k}" for i, j, k in pairs]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    for number in range(4):
        Path(sys.argv[1], f"table_{number}.txt").write_text(table(number, len(sys.argv) > 2))
