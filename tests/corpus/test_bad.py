"""Bad polygons are bad by the definitions, in the way that their family says."""

from __future__ import annotations

import pytest

from bern_exact.corpus.draws import hpoints
from bern_exact.corpus.families import FAMILIES
from tests.corpus.members import SEEDS, bad_families, member
from tests.plane.by_definition import edge_defects, nesting_defects, vertex_defects


@bad_families
def test_the_kind_is_found_by_the_definitions(name: str) -> None:
    for seed in SEEDS:
        rings = hpoints(member(name, seed).rings)
        kinds = set(FAMILIES[name].errors)
        basic = vertex_defects(rings)
        if basic:
            assert basic[0] in kinds
        elif edges := edge_defects(rings):
            assert set(edges.values()) & kinds
        else:
            assert {kind for kind, _ in nesting_defects(rings)} & kinds


@pytest.mark.parametrize("name", ["bad-hole-outside", "bad-hole-in-hole"])
def test_holes_are_bad_by_their_place_alone(name: str) -> None:
    for seed in SEEDS:
        rings = hpoints(member(name, seed).rings)
        assert not vertex_defects(rings) and not edge_defects(rings)
