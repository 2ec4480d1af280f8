"""Every family draws what it says, and the same everywhere."""

from __future__ import annotations

import ast
import os
import pickle
import re
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise
from random import Random

import pytest
from gmpy2 import mpq

from bern_exact.corpus import draws
from bern_exact.corpus.draws import hpoints, reason_against
from bern_exact.corpus.families import FAMILIES, drawn
from bern_exact.corpus.flags import DECLARED, FLAGS
from bern_exact.exact.errors import INPUT_ERROR_KINDS
from bern_exact.plane.validation import polygon_from_rings
from bern_exact.theorems.stages import RefusedOption
from tests.corpus.members import (
    BAD,
    SEEDS,
    VALID,
    as_text,
    bad_families,
    digest,
    every_family,
    member,
    polygon,
    valid_families,
)
from tests.source import PACKAGE

FILE_ERRORS = {"syntax", "number", "schema", "unsupported"}
"""Kinds of error that only a file can have, not rings."""

THEOREM_ERRORS = {"not-convex", "has-holes"}
"""Kinds of error of polygons for which a theorem is not meant."""

EXACT_N = ("random", "random-grid", "grown", "star", "huge", "odd-fractions", "cocircular", "arc")
"""Families whose members have just n vertices."""

GOLDEN = "22ccfe8333cdb91fd39629885379a0f1054615930dc728da5ff5db6528fd27bd"
"""Of two draws of each family.  Another digest is another version of the generator."""


@valid_families
def test_members_are_polygons(name: str) -> None:
    for seed in SEEDS:
        assert polygon(name, seed).n >= 3


@bad_families
def test_bad_members_are_refused_for_the_reason_given(name: str) -> None:
    for seed in SEEDS:
        made = member(name, seed)
        kind = reason_against(made.rings)
        assert kind in FAMILIES[name].errors
        assert made.comment.endswith(f"Must be refused: {kind}.")


def test_every_kind_of_bad_polygon_has_a_family() -> None:
    kinds = {FAMILIES[name].errors[0] for name in BAD}
    assert kinds == set(INPUT_ERROR_KINDS) - FILE_ERRORS - THEOREM_ERRORS


@every_family
def test_coordinates_are_exact(name: str) -> None:
    for seed in SEEDS:
        for ring in member(name, seed).rings:
            assert all(type(c) in (int, type(mpq(0))) for place in ring for c in place)


@every_family
def test_families_are_documented(name: str) -> None:
    family = FAMILIES[name]
    assert family.name == name and re.fullmatch(r"[a-z]+(-[a-z]+)*", name)
    assert len(family.breaks) > 20 and not family.breaks.endswith(".")
    assert set(family.flags) <= set(FLAGS)
    assert all(0 <= least <= most for least, most in family.parameters.values())
    assert (name in BAD) == ("bad" in family.flags)


@every_family
def test_flags_are_in_order_and_those_of_the_family_among_them(name: str) -> None:
    for seed in SEEDS:
        flags = member(name, seed).flags
        assert list(flags) == [flag for flag in FLAGS if flag in flags]
        assert set(FAMILIES[name].flags) <= set(flags)
        assert set(DECLARED) & set(flags) == set(DECLARED) & set(FAMILIES[name].flags)


@every_family
def test_parameters_are_within_their_ranges(name: str) -> None:
    for seed in SEEDS:
        parameters = member(name, seed).parameters
        assert parameters.keys() == FAMILIES[name].parameters.keys()
        for key, (least, most) in FAMILIES[name].parameters.items():
            assert least <= parameters[key] <= most


@every_family
def test_given_parameters_change_nothing_else(name: str) -> None:
    """A given parameter leaves the draws of the others as they are."""
    made = member(name, 0)
    assert as_text(drawn(FAMILIES[name], f"{name} 0", made.parameters)) == as_text(made)
    for key in made.parameters:
        one = {key: made.parameters[key]}
        assert as_text(drawn(FAMILIES[name], f"{name} 0", one)) == as_text(made)


@pytest.mark.parametrize("name", EXACT_N)
def test_n_is_the_number_of_vertices(name: str) -> None:
    for n in (6, 9, 12):
        made = drawn(FAMILIES[name], "exact", {"n": n})
        assert sum(map(len, made.rings)) == n


def test_other_parameters_are_what_they_say() -> None:
    for seed in SEEDS:
        assert polygon("holes", seed).holes == member("holes", seed).parameters["holes"]
        assert polygon("plate", seed).holes == member("plate", seed).parameters["side"] ** 2
        teeth = member("comb", seed).parameters["teeth"]
        assert polygon("comb", seed).n == 4 * teeth


def test_larger_members_on_request() -> None:
    for name, n in (("grown", 120), ("maze", 200), ("random", 60), ("octilinear", 60)):
        made = drawn(FAMILIES[name], "large", {"n": n})
        assert n / 2 <= polygon_from_rings(hpoints(made.rings)).n <= 2 * n + 4


@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("star", {"m": 5}),
        ("star", {"n": 3}),
        ("errata", {"which": 1000}),
        ("random-grid", {"size": 5, "n": 26}),
    ],
)
def test_impossible_parameters_are_refused(name: str, given: dict[str, int]) -> None:
    with pytest.raises(RefusedOption):
        drawn(FAMILIES[name], "seed", given)


@pytest.mark.parametrize("flags", [("holes",), ("convex", "reflex")])
def test_no_member_lacks_a_flag_of_its_family(
    flags: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(draws, "MOST_ATTEMPTS", 20)
    with pytest.raises(RefusedOption):
        drawn(replace(FAMILIES["triangle"], flags=flags), "seed")


def test_what_is_refused_for_another_reason_is_no_member(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(draws, "MOST_ATTEMPTS", 20)
    with pytest.raises(RefusedOption):
        drawn(replace(FAMILIES["bad-zero-area"], errors=("edges-cross",)), "seed")


@every_family
def test_consecutive_seeds_draw_different_members(name: str) -> None:
    if "listed" in FAMILIES[name].flags:
        return
    texts = [repr(member(name, seed).rings) for seed in SEEDS]
    assert all(first != second for first, second in pairwise(texts))


@every_family
def test_families_can_be_sent_to_other_processes(name: str) -> None:
    again = pickle.loads(pickle.dumps(FAMILIES[name]))
    assert as_text(drawn(again, f"{name} 0")) == as_text(member(name, 0))


@every_family
def test_drawing_is_a_function_of_random_and_parameters(name: str) -> None:
    family, parameters = FAMILIES[name], member(name, 1).parameters
    assert family.draw(Random("s"), parameters) == family.draw(Random("s"), parameters)


def test_members_never_change() -> None:
    assert digest(FAMILIES, range(2)) == GOLDEN


def test_members_do_not_depend_on_hashes() -> None:
    """Nor on anything else that differs between processes."""
    program = "from tests.corpus.members import *; print(digest(FAMILIES, range(2)), end='')"
    made = subprocess.run(
        [sys.executable, "-c", program],
        cwd=PACKAGE.parent,
        env={**os.environ, "PYTHONHASHSEED": "20", "PYTHONPATH": str(PACKAGE.parent)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert made.stdout == GOLDEN


def test_only_what_no_version_of_python_changes_is_drawn() -> None:
    """Calls on a `Random` are of randrange and getrandbits alone."""
    for path in (PACKAGE / "corpus").glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            match node:
                case ast.Attribute(value=ast.Name(id="random"), attr=attribute):
                    assert attribute in {"randrange", "getrandbits"}, path.name


def test_small_families_keep_raw_meshes() -> None:
    raw = [name for name in VALID if FAMILIES[name].raw]
    assert raw
    assert all(polygon(name, seed).n <= 8 for name in raw for seed in SEEDS)
