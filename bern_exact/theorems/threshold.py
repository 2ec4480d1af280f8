"""The threshold of warping for a wanted angle bound: the paper's 150 degrees and better.

A threshold tau gives no angle above 135 degrees + arctan(2 tau); tau = 1/8 gives
149.04 and is what the paper takes.  The heights fall in proportion to tau.
"""

from __future__ import annotations

from gmpy2 import mpq

from bern_exact.boundary.corners import TAU
from bern_exact.boundary.optimal import largest_kappa
from bern_exact.exact.angle_bound import AngleBound
from bern_exact.exact.angles import ANGLE_150, Angle
from bern_exact.theorems.stages import RefusedOption

DENOMINATORS = 1000
"""Thresholds below 1/8 have denominators up to this."""


class BoundOutOfReach(RefusedOption):
    """An angle bound that no threshold gives."""


def largest_angle_for(tau: mpq) -> Angle:
    """135 degrees + arctan(2 tau), exactly.

    >>> largest_angle_for(mpq(1, 8))
    Angle(cos_sign=-1, cos_squared=mpq(25,34))
    """
    kappa = largest_kappa(tau)
    return Angle(-1, kappa * kappa / (1 + kappa * kappa))


def threshold_for(bound: AngleBound) -> mpq:
    """The largest p/q <= 1/8 with q <= 1000 for which 135 degrees + arctan(2 p/q) is admitted.

    Parameters
    ----------
    bound : AngleBound
        Above 135 degrees, at most 150.

    Raises
    ------
    BoundOutOfReach
        At 135 degrees or below, above 150, or so near 135 that no such fraction exists.

    Notes
    -----
    Descends the Stern-Brocot tree, where the fraction below a bound with the largest
    denominator allowed is found without search.
    """
    if bound.admits(ANGLE_150) and (bound.angle is None or bound.angle != ANGLE_150):
        raise BoundOutOfReach(
            f"the largest angle can be bounded by anything above 135 up to 150 degrees; "
            f"{bound.text} is above 150"
        )
    if bound.admits(largest_angle_for(TAU)):
        return TAU
    low, high = (0, 1), (1, 8)
    while low[1] + high[1] <= DENOMINATORS:
        middle = (low[0] + high[0], low[1] + high[1])
        if bound.admits(largest_angle_for(mpq(*middle))):
            low = middle
        else:
            high = middle
    if low[0] == 0:
        raise BoundOutOfReach(
            f"the largest angle can be bounded by anything above 135 degrees, in practice "
            f"from 135 + arctan(2/{DENOMINATORS}) = 135.115 on: blocks alone need 135; "
            f"{bound.text} is not within reach"
        )
    return mpq(*low)
