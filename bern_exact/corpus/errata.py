"""Polygons that refute sentences of the paper, each as small as was found.

They are valid input, and every guarantee holds on them: what fails is the sentence as printed,
which `triangulate(..., as_printed=True)` evaluates beside the repaired one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from gmpy2 import mpq

from bern_exact.boundary.rotation import SMALL
from bern_exact.corpus import convex
from bern_exact.corpus.draws import Rings, hpoints, nth, places
from bern_exact.corpus.family import Family, without_random
from bern_exact.exact.similarity import Similarity

_TURN = Similarity.rotation(mpq(1, 1024)).then(Similarity.rotation(mpq(1, SMALL)).inverse())
"""Between the two rotations that frames begin with: some polygons were found over the other."""


@dataclass(frozen=True)
class Erratum:
    """A counterexample.

    Parameters
    ----------
    name : str
        Short, its own.
    claims : tuple of str
        The claims of role "as-printed" that do not hold on it; none if it refutes a sentence about
        regions inside the grid, being such a region itself.
    theorem : int
        The theorem on whose way they are evaluated.
    says : str
        The sentence that it refutes, and how.
    given : Rings
        The polygon as it is written here.
    turned : bool
        Whether it is to be turned by `_TURN`: its place over the grid matters.
    """

    name: str
    claims: tuple[str, ...]
    theorem: int
    says: str
    given: Rings
    turned: bool = False

    @cached_property
    def rings(self) -> Rings:
        """The polygon."""
        if not self.turned:
            return self.given
        return places([[_TURN.apply(p) for p in ring] for ring in hpoints(self.given)])


def _of_fractions(text: str) -> Rings:
    """One ring from the texts of x, y, x, y, ..."""
    numbers = [mpq(number) for number in text.split()]
    return [list(zip(numbers[::2], numbers[1::2], strict=True))]


ERRATA = (
    Erratum(
        "cutting-line",
        ("lemma-1.printed-feature-size",),
        1,
        "Refutes Lemma 1, s' >= s/3, with the paper's cutting line across vw at a third: here "
        "s'/s is 0.192, for the legs of the cut reach sqrt(2)/3 |vw|.",
        [[(0, 0), (1, 0), (mpq(99, 100), 3), (mpq(1, 2), mpq(86, 100)), (mpq(1, 100), 3)]],
    ),
    Erratum(
        "slit",
        ("dicing.printed-different-squares",),
        2,
        'Refutes "each vertex falls into a different square", which is true on each sheet only: '
        "across the exterior slit two vertices share a square of the plane.",
        [[(0, 0), (9, 0), (9, 9), (5, 9), (5, 4), (mpq(499, 100), 9), (0, 9)]],
    ),
    Erratum(
        "needle",
        ("dicing.printed-unit",),
        1,
        "Refutes that the grid unit s/8 keeps blocks apart: with s' >= s/3 only, s' may be less "
        "than 2 sqrt(2) of it, and two blocks overlap.",
        [[(0, 0), (10**6, 0), (10**6, 1)]],
    ),
    Erratum(
        "close-call",
        ("lemma-2.printed-closest-corner", "lemma-2.printed-block-angle"),
        2,
        "Refutes Lemma 2's 135 degrees in blocks where each vertex takes the closest corner of its "
        "square: an edge passes a grid point just within tau.",
        _of_fractions(
            "565780149317910359/2555292500255529250 "
            "-113517036496418748977883/1022117000102211700000000 "
            "2519117521813194389041/418659123241865912320 "
            "905331649363718789796771023/167463649296746364928000000 "
            "250712348722184801236281521/83731824648373182464000000 "
            "144262780260385716856239577313/8373182464837318246400000000 "
            "-13094597332090497830480159/1308309760130830976000000 "
            "122679218537773761227228817669/8373182464837318246400000000 "
            "-347244218387674506561594163/41865912324186591232000000 "
            "2351133457599164037427350329/837318246483731824640000000"
        ),
    ),
    Erratum(
        "low-triangle",
        ("lemma-2.printed-height",),
        1,
        'Refutes "height almost b/8" near the boundary: tau/sqrt(2) is the natural bound.',
        [[(0, 0), (10, 0), (3, 7)]],
    ),
    Erratum(
        "three-corners",
        ("lemma-2.printed-moved",),
        1,
        "Refutes that at most two vertices of a face move when it warps: the corridor 45 b wide is "
        "1 b high there, and both its walls pass within tau of corners, one of them twice.",
        _of_fractions(
            "-6027/100 -10567/100 4623/100 83/100 9973/100 74939/100 9973/100 75739/100 "
            "4712/100 75939/100 -177/100 -2285/100 -9027/100 -2261/100 -10627/100 -6061/100"
        ),
    ),
    Erratum(
        "unit-square",
        ("lemma-3.printed-height", "lemma-3.printed-zig-zag"),
        1,
        "Refutes Lemma 3's height b, for the diagonal of a unit square leaves b/sqrt(2) only, and "
        "the zig-zag, which meets a late subdivision point too early.",
        [[(0, 0), (1, 0), (1, 1), (0, 1)]],
    ),
    Erratum(
        "obtuse-end-face",
        ("lemma-5.printed-end-angle",),
        2,
        "Refutes that end faces have a maximum angle of 150 degrees, so that either diagonal "
        "triangulates them: where a row ends on an edge of slope above 1/2, up to 153.43.",
        [[(3, 2), (9, 9), (0, 4)]],
    ),
    Erratum(
        "slender",
        ("lemma-5.printed-end-height",),
        2,
        'Refutes Lemma 5\'s "height comes for free" at end faces: with all staircase vertices '
        "projected one of them has a height of about 0.0005 b.",
        [[(26, 31), (32, 12), (40, 13)]],
        turned=True,
    ),
    Erratum(
        "thin-end-face",
        ("lemma-5.printed-end-height",),
        2,
        "Refutes the same even more: a projection next to the end of an edge leaves 0.00015 b.",
        [[(17, 15), (15, 19), (0, 3)]],
        turned=True,
    ),
    Erratum(
        "low-corner",
        ("lemma-2.printed-height",),
        1,
        "Refutes that Lemma 5's pieces keep the height tau/sqrt(2): a long row ends above an edge "
        "of almost 31 degrees, with a height of 0.6263 tau.",
        [[(0, 0), (mpq(150097, 250), mpq(44606, 125)), (500, 900), (-50, 900), (-2, 3)]],
        turned=True,
    ),
    Erratum(
        "notched-rectangle",
        (),
        2,
        "Refutes Lemma 6's boundary of length O(n) under a fixed parity, as a region of unit "
        "cells: cutting off squares so that corners become even lengthens it from 22 to 24.",
        [[(0, 0), (6, 0), (6, 4), (3, 4), (3, 3), (2, 3), (2, 4), (0, 4)]],
    ),
    Erratum(
        "subdivided-rectangle",
        (),
        2,
        "Refutes the placement of Steiner points in Lemma 7, as a rectangle with subdivisions at "
        "least 1 apart: (2, 1) is allowed, and either diagonal beside it leaves 146 degrees.",
        [[(0, 0), (20, 0), (20, 2), (10, 2), (0, 2), (0, 1)]],
    ),
    Erratum(
        "spiral-that-turns",
        ("bounce.printed-return",),
        4,
        "Refutes that once those in the middle have been bounced all subdivision points return to "
        "their own sides (Section 5): some paths turn later.",
        convex.occupied_spiral(6, 2),
    ),
    Erratum(
        "spiral-of-bounces",
        ("bounce.printed-order",),
        4,
        "Refutes that the triangle may be chosen freely (Section 5): always the farthest first "
        "takes 34 half-steps, the repaired order 29.",
        convex.occupied_spiral(16, 2),
    ),
    Erratum(
        "hexagon",
        ("lemma-10.printed-width", "lemma-12.printed-strips", "lemma-12.printed-separation"),
        4,
        'Refutes the strict "a > max(c, d)" of Lemma 10, by which no line of a uniform grid could '
        'go, and "m triangles" for each of the columns l and r: 2 m - e.',
        convex.regular(6, 2),
    ),
    Erratum(
        "tiny-edges",
        ("lemma-12.printed-aspect",),
        4,
        "Refutes m' < k' for all seven parts (Section 5.2).",
        convex.tiny_edges(16, 2),
    ),
)
"""Every counterexample, in the order of the paper."""

BY_NAME: Mapping[str, Erratum] = {each.name: each for each in ERRATA}
"""The same."""


def erratum(which: int) -> Rings:
    """The counterexample of this number."""
    return nth(ERRATA, which).rings


def _says(parameters: Mapping[str, int]) -> str:
    return ERRATA[parameters["which"]].says


FAMILIES = (
    Family(
        "errata",
        "constructions that follow the paper to the letter: each refutes a sentence as printed",
        ("erratum", "listed"),
        {"which": (0, len(ERRATA) - 1)},
        without_random(erratum),
        says=_says,
    ),
)
