"""What the certificates show, as lines of `python -m proofs`."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

import numpy as np
from gmpy2 import mpq

from bern_exact.boundary.corners import block_demands
from bern_exact.checkers import bounds
from bern_exact.checkers.bounds_grid import FACTOR
from proofs.lemma_2.block import CORNERS, DOWN, LEFT, RIGHT, UP, block
from proofs.lemma_2.exact import configuration, kappas
from proofs.lemma_2.points import Bounds
from proofs.lemma_2.rays import ray_types
from proofs.lemma_2.replay import Plans, crowded_plan_of, plan_of, replay, samples, scaled
from proofs.lemma_2.tree import leaves, stored
from proofs.lemma_2.warping import wished
from proofs.section_2 import degrees_of_arctan
from proofs.statement import CERTIFICATE, ENUMERATION, Chapter, NotShown, Statement, Status, demand

CHAPTER = Chapter()

METHOD = "exact certificate: a tree of boxes, replayed in integers"

SAMPLE = 60
"""Leaves of each class that the quick run replays."""

CLASSES = {UP: "up", LEFT: "left", DOWN: "down", RIGHT: "right"}


class Certificate(NamedTuple):
    """A claim and the trees that show it.

    Parameters
    ----------
    name : str
        Of the trees.
    text : str
        The claim.
    claim : Bounds
        What is to hold for each triangle.
    nearest : bool
        Whether only the closest corner may be taken.
    plans : callable
        Which corners may be taken by types.
    """

    name: str
    text: str
    claim: Bounds
    nearest: bool = False
    plans: Plans = plan_of


TAU = scaled(1, 8)

HEIGHT = (91, 10)
"""91/1024: heights above it, or of at least tau/sqrt 2 by sections, are at least tau/sqrt 2."""

DEMANDED = Bounds((1, 1), TAU, HEIGHT, edges=True)
"""What `bern_exact.boundary.corners` demands of a corner."""

CERTIFICATES = (
    Certificate(
        "angle-132",
        "In every block some corner of the square of v can be taken so that every face has a "
        "triangulation with all angles below 132 degrees, hence 135 (interior angle at v at least "
        "90 degrees, tau = 1/8).",
        Bounds((9, 10), TAU),
    ),
    Certificate(
        "shipped-rule",
        "The shipped rule always finds a corner: in every block some corner can be taken so that "
        "every face has a triangulation with all angles at most 135 degrees and all heights at "
        "least tau/sqrt 2, and all sides of faces are at least tau long (tau = 1/8).",
        DEMANDED,
    ),
    Certificate(
        "crowded",
        "Wherever more than two q-vertices would choose one interior grid vertex, the shipped "
        "rule's demand is kept if v takes that one, the closest corner: it is taken, and none of "
        "them chooses. So in blocks, too, at most two q-vertices choose one grid vertex.",
        DEMANDED,
        plans=crowded_plan_of,
    ),
    Certificate(
        "closest-corner",
        "With the closest corner, as printed, every face of a block has a triangulation with all "
        "angles below 142.44 degrees (142.125 are reached in the limit).",
        Bounds((13, 10), TAU),
        nearest=True,
    ),
)


def statements(full: bool = False) -> Iterator[Statement]:
    """The chapter, and each certificate: proved if every leaf is replayed, open if a sample is.

    Raises
    ------
    NotShown
        If a leaf that is replayed fails.
    """
    yield from CHAPTER.statements(full)
    for certificate in CERTIFICATES:
        yield statement(certificate, full)


def statement(certificate: Certificate, full: bool) -> Statement:
    """Replay a certificate or a sample of it; that its leaves tile all boxes is checked anyway."""
    counts, looked_at, deepest = {}, 0, 0
    for cls, name in CLASSES.items():
        found = leaves(stored(certificate.name, cls), cls)
        total = found.low.shape[1]
        counts[name] = total
        deepest = max(deepest, found.deepest)
        chosen = np.arange(total) if full else np.array(list(samples(SAMPLE, total)))
        done = replay(
            found.low[:, chosen],
            found.high[:, chosen],
            cls,
            certificate.claim,
            certificate.nearest,
            certificate.plans,
        )
        looked_at += done.leaves
        demand(done.leaves == len(chosen), "every leaf chosen is looked at")
        if done.failed:
            raise NotShown(f"{certificate.name}, f {name}: leaf {chosen[done.failed[0]]}")
    each = ", ".join(f"{count} with f {name}" for name, count in counts.items())
    total = sum(counts.values())
    status: Status = "proved" if full and looked_at == total else "open"
    evidence = f"{total} leaves ({each}) to depth {deepest} tile all parameters; "
    evidence += "all replayed" if status == "proved" else f"{looked_at} replayed, --full does all"
    return Statement("Lemma 2, blocks (repaired)", certificate.text, status, METHOD, evidence)


@CHAPTER.proved(
    "Lemma 2, blocks",
    "What becomes of a block depends on v in its square and on two rays alone, of which the first "
    "goes up, and on open questions that are answered both ways; mirror images halve each class.",
    "written proof (docstring of proofs.lemma_2, steps 1 to 7); exact comparisons",
)
def reduction() -> str:
    """The lengths that the steps compare, squared, in grid units: s' is at least 8."""
    reach = 2 * (2 + bounds.TAU) ** 2
    demand(bool(reach < FACTOR**2), "step 1, 2: (2 + tau) sqrt 2 < 8")
    demand(bool(mpq(18) < FACTOR**2), "step 5: 3 sqrt 2 < 8")
    demand(bool(2 * bounds.TAU < 1), "step 4: at most one end of a unit segment is near")
    worst = 90 + degrees_of_arctan(mpq(13, 10))[1]
    demand(bool(worst < mpq(14244, 100)), "kappa 13/10: 142.44 degrees")
    demand(bool(9 * 3 > 25), "3/5 > cot 60, of the bounds kappa")
    return f"squared reach {reach} and 18 < {FACTOR**2}"


@CHAPTER.proved(
    "Lemma 2, blocks",
    "No choice of corner does with less than 131.18 degrees: 132 is nearly best.",
    CERTIFICATE,
)
def no_better_corner() -> str:
    """v just beyond (9/16, 1/2), its rays just beside (-7/8, 1) and (-7/8, -1).

    For each corner the best triangulation of each face is found exactly.  The limit is
    180 degrees - arctan(8/7).
    """
    hair = mpq(1, 10**6)
    v = (mpq(9, 16) + hair, mpq(1, 2) + hair / 7)
    c = configuration(v, (hair - mpq(7, 8), mpq(1)), (hair - mpq(7, 8), mpq(-1)))
    least = min(kappa for kappa in kappas(c, bounds.TAU).values())
    demand(bool(least > mpq(7, 8) - 2 * hair), "cotangent -7/8 in the limit")
    demand(bool(90 + degrees_of_arctan(least)[0] > mpq(13118, 100)), "131.18 degrees")
    demand(bool(90 + degrees_of_arctan(mpq(9, 10))[1] < 132), "132 degrees")
    return f"the best corner has an angle of cotangent {-least}"


@CHAPTER.proved(
    "Lemma 2, blocks (repaired)",
    "The shipped rule demands of a corner just what its certificate (see there) shows that some "
    "corner has. From that it follows that in blocks every angle is at most 135 degrees, every "
    "height at least tau/sqrt 2, every side of a face, on an edge of P' or not, at least tau.",
    "written proof",
)
def shipped_rule() -> str:
    """The demands of the package are compared with the certificate's claim.

    A corner is taken with which each face has a triangulation that keeps the demand.  The mesh
    takes a highest one within 135 degrees, which is as high at least; merging leaves block faces
    alone.  A side of a triangle is at least as long as its least altitude: diagonals, too, are at
    least tau/sqrt 2.
    """
    asked, _ = block_demands("square", bounds.TAU)  # the second is never needed, so
    k, j = HEIGHT
    demand(asked.kappa == 1 and bounds.BLOCK_COTANGENT == -1, "135 degrees")
    demand(asked.squared_floor == bounds.boundary_height_squared() == bounds.TAU**2 / 2, "height")
    demand(bool(mpq(k, 2**j) ** 2 > bounds.TAU**2 / 2), "91/1024 > tau/sqrt 2")
    demand(bounds.edge_squared() == bounds.TAU**2, "sides")
    return "kappa = 1, tau^2/2 and tau^2 in `corners`, as replayed"


@CHAPTER.proved(
    "Section 2, warping",
    "In a block at most three q-vertices are near enough to an interior grid vertex to choose it, "
    "three only if it is the closest corner of the square of v; and at most two are near enough "
    "to an instance.",
    ENUMERATION,
    full=True,
)
def wishes() -> str:
    """Over all pairs of types: near are crossings in the outer parts of their unit segments.

    If both rays pass a grid vertex within tau it is nearer to v than sqrt 2 tau < 1/2
    (`section_2.choosers`), so that no other corner is as near.
    """
    most: dict[tuple[str, bool], int] = {}
    for cls in CLASSES:
        for kind_e, kind_f in product(ray_types(), repeat=2):
            made = block(cls, kind_e, kind_f)
            for wish, count in wished(made).items() if made else ():
                key = (
                    ("instance", False)
                    if wish[0] is not None
                    else ("grid vertex", wish[1] in CORNERS)
                )
                most[key] = max(count, most.get(key, 0))
    demand(most[("grid vertex", True)] == 3, "three near a corner of the square of v")
    demand(most[("grid vertex", False)] == most[("instance", False)] == 2, "two elsewhere")
    demand(bool(2 * bounds.TAU**2 < mpq(1, 4)), "sqrt 2 tau < 1/2")
    return "3 near a corner of the square of v, 2 elsewhere; one a line and ray"


@CHAPTER.open(
    "Lemma 2, blocks (repaired)",
    "Diagonals of block faces, too, are at least tau long (`lemma-2.block-edges`).",
)
def diagonals() -> str:
    """The rule asks for sides; of the corner it takes no more is known of diagonals."""
    demand(bounds.boundary_height_squared() * 2 == bounds.edge_squared(), "tau/sqrt 2")
    return "at least tau/sqrt 2, as sides of triangles of that height; tau checked on every run"
