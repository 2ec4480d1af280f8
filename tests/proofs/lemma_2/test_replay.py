"""The replay passes what is true and finely divided, and nothing else."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest
from gmpy2 import mpq

from proofs.lemma_2.block import DOWN, LEFT, RIGHT, UP, block
from proofs.lemma_2.exact import Configuration, configuration, kappas, type_of
from proofs.lemma_2.forms import ONE
from proofs.lemma_2.points import Bounds
from proofs.lemma_2.rays import E, F
from proofs.lemma_2.replay import crowded_plan_of, replay, scaled
from proofs.lemma_2.statements import CERTIFICATES, statement
from proofs.lemma_2.tree import leaves, stored
from proofs.lemma_2.warping import crowded
from tests.proofs.lemma_2.configurations import TAU, box_round, some_configuration

CLASSES = (UP, LEFT, DOWN, RIGHT)
KAPPA_132, KAPPA_135 = Bounds((9, 10), scaled(1, 8)), Bounds((1, 1), scaled(1, 8))

HAIR = mpq(1, 10**5)


def passes(c: Configuration, bounds: Bounds, nearest: bool = False) -> bool:
    """Does the small box round a configuration pass?"""
    return not replay(*box_round(c), c.cls, bounds, nearest).failed


def sharp() -> Configuration:
    """v just beyond (9/16, 1/2), its rays in directions (-7/8, 1) and (-7/8, -1)."""
    v = (mpq(9, 16) + HAIR, mpq(1, 2) + HAIR / 7)
    return configuration(v, (HAIR - mpq(7, 8), mpq(1)), (HAIR - mpq(7, 8), mpq(-1)))


def as_printed() -> Configuration:
    """Where the closest corner leaves 135 degrees + arctan(1/10)."""
    v, delta = (mpq(1, 2) - HAIR, mpq(1, 2) + HAIR), mpq(1, 10)
    return configuration(v, (mpq(-1), mpq(-3)), (1 + delta - v[0], 2 - v[1]))


def test_no_corner_is_better_than_131_degrees() -> None:
    assert abs(min(kappas(sharp(), TAU).values()) - mpq(7, 8)) < 10 * HAIR
    assert passes(sharp(), KAPPA_132)
    assert not passes(sharp(), Bounds((13, 15), scaled(1, 8)))
    assert not passes(sharp(), Bounds((2, 3), scaled(1, 8)))


def test_the_closest_corner_fails() -> None:
    found = kappas(as_printed(), TAU)
    assert max(found.values()) > mpq(6, 5) and min(found.values()) < mpq(9, 10)
    assert passes(as_printed(), KAPPA_135)
    assert not passes(as_printed(), KAPPA_135, nearest=True)
    assert passes(as_printed(), Bounds((13, 10), scaled(1, 8)), nearest=True)


@pytest.mark.parametrize("cls", CLASSES)
def test_small_boxes_pass_just_where_some_corner_does(cls: int) -> None:
    random = Random(f"replay {cls}")
    for _ in range(12):
        c = some_configuration(random, cls)
        needed = min(kappas(c, TAU).values())
        for num, den in ((3, 5), (7, 10), (4, 5)):
            if needed > mpq(num, den):  # the other way round, a hair may be open in the box
                assert not passes(c, Bounds((num, den), scaled(1, 8)))
        assert passes(c, KAPPA_132)


def test_a_box_that_is_too_large_fails() -> None:
    assert not replay(*box_round(sharp(), ONE >> 12), DOWN, KAPPA_132).failed
    assert replay(*box_round(sharp(), ONE >> 4), DOWN, KAPPA_132).failed


def test_low_triangles_fail() -> None:
    c, (low, high) = as_printed(), box_round(as_printed())
    for height, fails in (((1, 5), False), ((1, 1), True)):
        bounds = Bounds((1, 1), scaled(1, 8), height)
        assert bool(replay(low, high, c.cls, bounds).failed) == fails


@pytest.mark.parametrize(
    "bounds",
    [Bounds((2, 3), scaled(1, 8)), Bounds((9, 10), scaled(1, 4)), Bounds((9, 10), scaled(1, 16))],
    ids=["kappa 2/3", "tau 1/4", "tau 1/16"],
)
def test_the_certificate_fits_its_claim_alone(bounds: Bounds) -> None:
    # For other tau its leaves are too large somewhere, whether or not 132 degrees hold.
    found = leaves(stored("angle-132", RIGHT), RIGHT)
    chosen = np.arange(0, found.low.shape[1], 400)
    done = replay(found.low[:, chosen], found.high[:, chosen], RIGHT, bounds)
    assert done.failed and len(done.failed) < len(chosen)


def test_only_the_closest_corner_does_not_do() -> None:
    found = leaves(stored("angle-132", LEFT), LEFT)
    chosen = np.arange(0, found.low.shape[1], 1500)
    done = replay(found.low[:, chosen], found.high[:, chosen], LEFT, KAPPA_135, nearest=True)
    assert done.failed


def crowd() -> Configuration:
    """Three q-vertices near (0, 0): e beside it on a row and on a column, f on a row."""
    v = (mpq(1, 20), mpq(1, 20))
    return configuration(v, (mpq(-1), mpq(-30, 100)), (mpq(32, 100), mpq(-1)))


@pytest.mark.parametrize("crowds", [False, True])
def test_more_than_two_would_choose_a_grid_vertex_only_if_v_takes_it(crowds: bool) -> None:
    c = crowd() if crowds else as_printed()
    made = block(c.cls, type_of(c, E, TAU), type_of(c, F, TAU))
    assert made is not None and (crowded(made) is not None) == crowds
    (low, high), claim = box_round(c), Bounds((1, 1), scaled(1, 8), (91, 10), edges=True)
    assert not replay(low, high, c.cls, claim, plans=crowded_plan_of).failed
    higher = claim._replace(height=(1, 0))  # asked of crowded blocks alone
    assert bool(replay(low, high, c.cls, higher, plans=crowded_plan_of).failed) == crowds


def test_a_sample_is_not_called_a_proof() -> None:
    found = statement(CERTIFICATES[0], full=False)
    assert found.status == "open" and "--full" in found.evidence
