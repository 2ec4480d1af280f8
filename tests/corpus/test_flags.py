"""Flags are true: each by its definition, in fractions and angle by angle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

import pytest
from gmpy2 import mpq

from bern_exact.corpus.draws import Rings, hpoints, is_polygon
from bern_exact.corpus.families import FAMILIES
from bern_exact.corpus.flags import DECLARED, FLAGS, in_order, number_flags, polygon_flags
from bern_exact.exact.predicates import squared_distance_to_segment
from bern_exact.plane.validation import polygon_from_rings
from tests.corpus.members import BAD, SEEDS, VALID, bad_families, member, polygon, valid_families
from tests.plane.by_definition import feature_size_by_definition

Pair = tuple[Fraction, Fraction]
NUMBERS = (
    "needs-rationals",
    "huge",
    "tiny",
    "far-away",
    "many-digits",
    "beyond-doubles",
)


def pairs(rings: Rings) -> list[list[Pair]]:
    return [[(Fraction(str(mpq(x))), Fraction(str(mpq(y)))) for x, y in ring] for ring in rings]


def double(value: Fraction) -> Fraction | None:
    """The nearest double, None beyond all of them."""
    try:
        return Fraction(float(value))
    except OverflowError:
        return None


def area(ring: list[Pair]) -> Fraction:
    return sum(
        ((ring[i - 1][0] * y - x * ring[i - 1][1]) / 2 for i, (x, y) in enumerate(ring)),
        Fraction(0),
    )


def squared(p: Pair, q: Pair) -> Fraction:
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


@dataclass(frozen=True)
class Corner:
    """A vertex: the cross and dot products of the edge after it and that before it, turned."""

    cross: Fraction
    dot: Fraction

    @property
    def tangent(self) -> Fraction | None:
        """Of the angle between the edges, whichever way round."""
        return abs(self.cross) / abs(self.dot) if self.dot else None


def corners(rings: list[list[Pair]]) -> Iterator[Corner]:
    """All vertices, the interior on the left of each ring."""
    for r, ring in enumerate(rings):
        way = 1 if (area(ring) > 0) == (r == 0) else -1
        turned = ring[::way]
        for i, (x, y) in enumerate(turned):
            (px, py), (qx, qy) = turned[i - 1], turned[(i + 1) % len(turned)]
            ax, ay, bx, by = qx - x, qy - y, px - x, py - y
            yield Corner(ax * by - ay * bx, ax * bx + ay * by)


def on_circle(a: Pair, b: Pair, c: Pair, d: Pair) -> bool:
    """The centre of the circle through three of them is as far from the fourth."""
    (ax, ay), (bx, by), (cx, cy) = a, b, c
    det = 2 * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax))
    if det == 0:
        return False
    u, v = squared(a, b), squared(a, c)
    centre = ax + ((cy - ay) * u - (by - ay) * v) / det, ay + ((bx - ax) * v - (cx - ax) * u) / det
    return d not in (a, b, c) and squared(centre, d) == squared(centre, a)


def number_flags_by_definition(rings: list[list[Pair]]) -> set[str]:
    numbers = [c for ring in rings for place in ring for c in place]
    found = set()
    if any(double(c) != c for c in numbers):
        found.add("needs-rationals")
    if any(abs(c) >= 2**53 for c in numbers):
        found.add("huge")
    if any(abs(c.numerator) >= 2**64 and c.denominator >= 2**64 for c in numbers):
        found.add("many-digits")
    if any(c != 0 and double(c) in (None, 0) for c in numbers):
        found.add("beyond-doubles")
    axes = [c for c in (numbers[::2], numbers[1::2]) if c]
    size = max((max(axis) - min(axis) for axis in axes), default=Fraction(0))
    if 0 < size <= Fraction(1, 10**6):
        found.add("tiny")
    if size and any(min(axis) > size * 10**9 or -max(axis) > size * 10**9 for axis in axes):
        found.add("far-away")
    return found


def angle_flags_by_definition(rings: list[list[Pair]]) -> set[str]:
    small, found = Fraction(1, 1000), set()
    for corner in corners(rings):
        if corner.cross < 0:
            found.add("reflex")
        if corner.cross == 0:
            found.add("flat-vertices")
        elif corner.dot < 0 and corner.tangent is not None and corner.tangent < small:
            found.add("near-flat")
        if corner.dot == 0:
            found.add("right-angles")
        elif corner.tangent is not None and corner.tangent > 1000:
            found.add("near-right")
        if corner.cross > 0 and corner.dot > 0:
            found.add("acute")
            if corner.cross / corner.dot < Fraction(1, 50):
                found.add("needle")
    if len(rings) == 1 and "reflex" not in found:
        found.add("convex")
    return found


def edge_flags_by_definition(rings: list[list[Pair]]) -> set[str]:
    edges = [(ring[i - 1], p) for ring in rings for i, p in enumerate(ring)]
    vectors = [(abs(q[0] - p[0]), abs(q[1] - p[1])) for p, q in edges]
    lengths = [squared(p, q) for p, q in edges]
    rules = {
        "axis-parallel": any(0 in vector for vector in vectors),
        "rectilinear": all(0 in vector for vector in vectors),
        "diagonal": any(x == y for x, y in vectors),
        "ties": any(a == b for a, b in combinations(lengths, 2)),
        "uneven-edges": max(lengths) > 10**6 * min(lengths),
        "collinear": any(
            (q[0] - p[0]) * (r[1] - p[1]) == (q[1] - p[1]) * (r[0] - p[0])
            for p, q in edges
            for ring in rings
            for r in ring
            if r not in (p, q)
        ),
        "cocircular": any(
            on_circle(*(ring[(i + k) % len(ring)] for k in range(4)))
            for ring in rings
            if len(ring) > 3
            for i in range(len(ring))
        ),
    }
    return {flag for flag, holds in rules.items() if holds}


def size_flags_by_definition(rings: Rings) -> set[str]:
    shape = polygon_from_rings(hpoints(rings))
    exact = pairs(rings)
    places = [p for ring in exact for p in ring]
    diameter = max(squared(p, q) for p, q in combinations(places, 2))
    whole = abs(area(exact[0])) - sum(abs(area(ring)) for ring in exact[1:])
    feature = Fraction(str(feature_size_by_definition(shape)[0]))
    rounded = [[tuple(double(c) for c in p) for p in ring] for ring in exact]
    rules = {
        "holes": len(rings) > 1,
        "many-holes": len(rings) > 6,
        "thin": feature * 10**6 < diameter,
        "slender": whole * 1000 < diameter,
        "rounds-to-invalid": any(None in p for ring in rounded for p in ring)
        or not is_polygon([[(mpq(x), mpq(y)) for x, y in ring] for ring in rounded]),
    }
    return {flag for flag, holds in rules.items() if holds}


@valid_families
def test_flags_of_polygons_are_those_of_the_definitions(name: str) -> None:
    for seed in SEEDS[:2]:
        rings = member(name, seed).rings
        exact = pairs(rings)
        expected = number_flags_by_definition(exact) | angle_flags_by_definition(exact)
        expected |= edge_flags_by_definition(exact) | size_flags_by_definition(rings)
        assert set(polygon_flags(polygon(name, seed))) == expected
        assert set(member(name, seed).flags) == expected | (
            set(DECLARED) & set(FAMILIES[name].flags)
        )


@bad_families
def test_flags_of_bad_rings_are_those_of_their_numbers(name: str) -> None:
    for seed in SEEDS:
        made = member(name, seed)
        expected = number_flags_by_definition(pairs(made.rings))
        assert set(number_flags(made.rings)) == expected
        assert set(made.flags) - set(DECLARED) == expected


def test_every_flag_is_had_by_some_and_not_by_all() -> None:
    found = [set(member(name, seed).flags) for name in FAMILIES for seed in SEEDS]
    assert set.union(*found) == set(FLAGS)
    assert not set.intersection(*found)


def test_the_vocabulary_is_documented() -> None:
    assert set(DECLARED) <= set(FLAGS)
    assert all(len(meaning) > 20 for meaning in FLAGS.values())


def test_flags_are_given_once_in_order() -> None:
    assert in_order(["tiny", "bad", "tiny"]) == ("bad", "tiny")


SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


@pytest.mark.parametrize(
    ("number", "flags"),
    [
        (mpq(1, 3), {"needs-rationals"}),
        (mpq(1, 2), set()),
        (2**53, {"huge"}),
        (2**53 - 1, set()),
        (2**53 + 1, {"huge", "needs-rationals"}),
        (10**309, {"huge", "needs-rationals", "beyond-doubles"}),
        (mpq(1, 2**1074), {"needs-rationals"} - {"needs-rationals"}),
        (mpq(1, 2**1076), {"needs-rationals", "beyond-doubles"}),
        (mpq(2**64 + 1, 2**64), {"needs-rationals", "many-digits"}),
        (mpq(2**64 - 1, 2**64), {"needs-rationals"}),
    ],
)
def test_flags_of_a_number(number: int | mpq, flags: set[str]) -> None:
    assert set(number_flags([[(number, 0), (1, 0), (1, 5), (0, 3)]])) == flags


def squared_gap(rings: Rings) -> tuple[mpq, mpq]:
    """The least squared distance of a vertex from an edge, across the exterior too; the largest."""
    points = hpoints(rings)
    edges = [(ring[i - 1], p) for ring in points for i, p in enumerate(ring)]
    distances = [
        squared_distance_to_segment(p, *edge)
        for ring in points
        for p in ring
        for edge in edges
        if p not in edge
    ]
    return min(distances), max(distances)


def test_a_near_miss_is_within_its_bound() -> None:
    for name in FAMILIES:
        for seed in SEEDS:
            if "near-miss" in member(name, seed).flags:
                gap, diameter = squared_gap(member(name, seed).rings)
                assert 0 < gap < diameter / 10**60


def test_bad_families_are_bad() -> None:
    assert all("bad" in member(name, 0).flags for name in BAD)
    assert not any("bad" in member(name, 0).flags for name in VALID)
