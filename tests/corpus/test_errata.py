"""Each counterexample refutes the sentence that it is there for, and keeps every guarantee."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from bern_exact import triangulate
from bern_exact.checkers.lemma_6 import check_lemma_6_as_printed
from bern_exact.corpus.draws import hpoints
from bern_exact.corpus.errata import BY_NAME, ERRATA, Erratum
from bern_exact.corpus.families import FAMILIES, drawn
from bern_exact.exact.angles import ANGLE_135, largest_angle
from bern_exact.exact.points import hpoint
from bern_exact.interior.subdivided.halving import halving
from bern_exact.plane.validation import polygon_from_rings
from tests.interior.regions import unit_region
from tests.plane.by_definition import encloses


@pytest.mark.parametrize("erratum", [e for e in ERRATA if e.claims], ids=lambda e: e.name)
def test_the_sentence_is_false_and_the_guarantees_hold(erratum: Erratum) -> None:
    polygon = polygon_from_rings(hpoints(erratum.rings))
    claims = triangulate(polygon, theorem=erratum.theorem, as_printed=True).certificate.claims
    assert all(claim.holds for claim in claims if claim.role == "guarantee")
    false = {claim.claim for claim in claims if not claim.holds}
    assert set(erratum.claims) <= false


def test_the_notched_rectangle_refutes_lemma_6_as_a_region() -> None:
    ring = BY_NAME["notched-rectangle"].rings[0]
    cells = frozenset(
        (i, j)
        for i in range(6)
        for j in range(4)
        if encloses(hpoints([ring])[0], hpoint(mpq(2 * i + 1, 2), mpq(2 * j + 1, 2)))
    )
    assert len(cells) == 23
    partition = halving(unit_region(cells, every_line=True), as_printed=True)
    (printed,) = check_lemma_6_as_printed(partition)
    assert not printed.holds


def test_the_rectangle_that_refutes_lemma_7() -> None:
    """Both triangles beside the Steiner point (2, 1) have an angle of more than 135 degrees."""
    (ring,) = hpoints(BY_NAME["subdivided-rectangle"].rings)
    corner, top, right, steiner = ring[4], ring[3], hpoint(10, 1), hpoint(2, 1)
    for far in (top, right):
        assert not largest_angle(corner, steiner, far)[0].is_at_most(ANGLE_135)


def test_each_says_what_it_refutes() -> None:
    for which, erratum in enumerate(ERRATA):
        assert erratum.says.startswith("Refutes ")
        assert drawn(FAMILIES["errata"], "s", {"which": which}).comment == erratum.says


def test_each_has_its_own_name() -> None:
    assert len(BY_NAME) == len(ERRATA)
