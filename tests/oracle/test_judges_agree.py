"""The two judges, which share no code, say the same, word for word."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest

from bern_exact.oracle import judge as lone
from bern_exact.oracle import verdict
from tests.oracle.agreement import SCHEMA, VALIDATOR, both
from tests.oracle.meshes import damage, garbage, good


def random_bounds(rng: random.Random) -> dict[str, Any]:
    bounds: dict[str, Any] = {}
    if rng.random() < 0.3:
        angles = ["60", "89.5", "90", "120.25", "135", "cos:-1:9/25", "cos:1:1/5", "150", "170.001"]
        bounds["max_angle"] = rng.choice(angles)
    if rng.random() < 0.2:
        bounds["min_height_squared"] = rng.choice(["0", "1/2", "1/50", "0.3"])
    if rng.random() < 0.2:
        bounds["max_triangles"] = rng.randint(0, 20)
    if rng.random() < 0.2:
        bounds["limit"] = rng.randint(0, 3)
    return bounds


@pytest.mark.parametrize("seed", range(10))
def test_on_good_meshes_that_both_accept(seed: int) -> None:
    rng = random.Random(seed)
    for _ in range(10):
        case = good(rng)
        assert both(case)["valid"]
        case.rings = []
        assert both(case)["valid"]


@pytest.mark.parametrize("seed", range(10))
def test_on_damaged_meshes(seed: int) -> None:
    rng = random.Random(1000 + seed)
    for _ in range(15):
        case = good(rng)
        for _ in range(rng.randint(1, 3)):
            damage(case, rng)
        VALIDATOR.validate(both(case, **random_bounds(rng)))
        case.rings = []
        both(case, **random_bounds(rng))


@pytest.mark.parametrize("seed", range(10))
def test_on_garbage(seed: int) -> None:
    rng = random.Random(2000 + seed)
    for _ in range(40):
        both(garbage(rng), **random_bounds(rng))


def test_in_their_kinds() -> None:
    """Every kind is in the schema, has its sentence, and is named by the lone judge's source."""
    kinds = SCHEMA["$defs"]["defect"]["properties"]["kind"]["enum"]
    assert sorted(kinds) == sorted(verdict.DEFECTS)
    source = Path(lone.__file__).read_text()
    assert all(f'"{kind}"' in source for kind in kinds)


def test_in_their_classes_of_angles() -> None:
    assert (*lone.CLASSES, "above") == verdict.ANGLE_CLASSES
