"""The table of the paper's Introduction, with explicit constants."""

from __future__ import annotations

from collections.abc import Sequence

ROWS: Sequence[Sequence[str]] = (
    ("", "convex", "simple polygon", "polygon with holes", "PSLG"),
    (
        "max-min height",
        "<= 4850 n triangles, height >= s/272.7 [1]",
        "the same",
        "the same",
        "? (open in the paper)",
    ),
    (
        "angles <= 150",
        "<= 5148 n log2 n + 51298 n [2]",
        "the same",
        "<= 100530 n^1.5 + 9701 n [3]; a lower bound for partitions only [4]",
        "Omega(n^2), O(n^2 log n) (Mitchell 1993: 157.5 degrees)",
    ),
    (
        "both of above",
        "the same counts, height >= s/385.6 [5]",
        "the same",
        "the same counts, height >= s/385.6 [5]",
        "impossible (Figure 8)",
    ),
    (
        "angles <= 90",
        "<= 6.3 (54 n)^1.8475 + 54 n, <= 8.1 (54 n)^1.8 + 54 n [6]; <= 324 n^2 + 54 n by bouncing; "
        "O(n) later",
        "O(n^2) printed; O(n) later (Bern, Mitchell, Ruppert 1995)",
        "O(n^2) printed; O(n) later (Bern, Mitchell, Ruppert 1995)",
        "? printed; O(n^2.5) later (Bishop 2016)",
    ),
)
"""A header and the criteria."""

NOTES: Sequence[str] = (
    "[1] `theorem_1.count` and `.height`, *proved* (blocks: with `--full`).",
    "[2] `theorems_2_3.theorem_2_count` and `.largest_angle`, *proved* (blocks: with `--full`). "
    "Any bound above 135 degrees has the same counts (`section_2.general_tau`); from 141.25 on "
    "it is proved to be kept (`.any_bound`, blocks: with `--full`).",
    "[3] `theorems_2_3.theorem_3_count`, *proved*; with Lemma 8's sharper count 4 (N + N^1.5), "
    "N = 858 n.",
    "[4] `theorems_2_3.steiner_ratio`: partitions into matching rectangles, not triangulations.",
    "[5] `theorems_2_3.height`, *proved* (blocks: with `--full`).",
    "[6] `theorem_4.count`, with Lemma 12's constants of `lemma_12_rounding.constant` and "
    "`lemma_12_rounding.better_exponent` and the 9 n verticals of `bouncing.verticals`, *proved*.",
)
"""Where each entry is shown."""

LATER = """Later results as their abstracts state them, for orientation only (nothing of them is
implemented or checked here):

| result | triangles | angles |
| --- | --- | --- |
| S. Mitchell 1993, PSLG | O(n^2 log n) | at most 157.5 degrees |
| T.-S. Tan 1996, PSLG | O(n^2) | at most 132 degrees |
| Bern, Mitchell, Ruppert 1995, polygon with holes | O(n) | at most 90 degrees |
| Bishop 2016, PSLG | O(n^2.5) | at most 90 degrees |
| Bishop 2016, triangulation of a simple polygon | O(n^2) | at most 90 degrees |
| Bishop 2016, PSLG | O(n^2/epsilon^2) | at most 90 + epsilon degrees, any epsilon > 0 |

With O(n) nonobtuse triangles for every polygon, Theorems 2 to 4 are no longer the best in order of
growth; what Theorems 2 and 3 keep is the height within a constant of the best possible.
"""


def table() -> str:
    """The section of the page."""
    lines = ["## The table of the Introduction, with explicit constants\n"]
    for i, row in enumerate(ROWS):
        lines.append("| " + " | ".join(row) + " |")
        if i == 0:
            lines.append("| --- " * len(row) + "|")
    notes = [f"- {note}" for note in NOTES]
    return "\n".join([*lines, "", *notes, "", LATER])
