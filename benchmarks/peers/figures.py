"""Measured values in a few characters, for tables and captions.  Nothing here decides anything."""

from __future__ import annotations

from gmpy2 import mpq

from benchmarks.peers.judging import OFF, Judged
from benchmarks.peers.runs import Record
from bern_exact.exact.angles import ANGLE_150, Angle
from bern_exact.exact.enclosures import degrees_enclosure, sqrt_enclosure
from bern_exact.exact.numbers import parse_rational
from bern_exact.figures import digits_of

OUTCOMES = {"time-out": "time-out", "out of memory": "memory", "crash": "crash", "error": "error"}
"""Outcomes without a mesh, as tables tell them."""

NOTHING = "-"


def degrees(angle: Angle) -> str:
    """An angle's degrees, two digits after the point, none of them rounded up.

    >>> degrees(ANGLE_150), degrees(Angle(0, mpq(0)))
    ('150.00', '90.00')
    """
    hundredths = int(parse_rational(degrees_enclosure(angle)[0]) * 100)
    return f"{hundredths // 100}.{hundredths % 100:02}"


def root(squared: mpq, digits: int = 3) -> str:
    """The first digits of a square root.

    >>> root(mpq(1, 4)), root(mpq(2))
    ('0.5', '1.41')
    """
    lower = parse_rational(sqrt_enclosure(squared)[0])
    return digits_of(lower, digits).replace("...", "")


def short_seconds(seconds: float | None) -> str:
    """Seconds, to about three digits.

    >>> short_seconds(0.00042), short_seconds(0.0124), short_seconds(3.456), short_seconds(123.4)
    ('< 0.001', '0.012', '3.46', '123')
    """
    if seconds is None:
        return NOTHING
    if seconds < 0.001:
        return "< 0.001"
    places = 3 if seconds < 1 else 2 if seconds < 10 else 1 if seconds < 100 else 0
    return f"{seconds:.{places}f}"


def triangles(record: Record) -> str:
    """The number of triangles, or why there is none."""
    if record.triangles is None:
        return OUTCOMES[record.outcome]
    return f"{record.triangles:,}"


def angle(record: Record) -> str:
    """The largest angle, bold if it is above 150 degrees."""
    if record.judged is None or record.judged.max_angle is None:
        return NOTHING
    found = record.judged.max_angle
    return degrees(found) if found.is_at_most(ANGLE_150) else f"**{degrees(found)}**"


def height(record: Record) -> str:
    """The least height to the feature size."""
    ratio = record.judged.height_ratio_squared if record.judged else None
    return NOTHING if ratio is None else root(ratio)


def seconds(record: Record) -> str:
    """The time, of our meshes also that with checks."""
    shown = short_seconds(record.seconds)
    if record.checked_seconds is not None:
        shown += f" / {short_seconds(record.checked_seconds)}"
    return shown


def boundary(record: Record) -> str:
    """Whether the mesh is exactly a triangulation of the polygon, or what is wrong."""
    return NOTHING if record.judged is None else standing(record.judged)


def standing(judged: Judged) -> str:
    """A verdict in a few words."""
    if judged.valid:
        return "exact"
    off = f"{judged.off:,} off" if judged.off else ""
    return ", ".join(filter(None, [off, *(kind for kind in judged.defects if kind != OFF)]))
