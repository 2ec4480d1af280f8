"""From exact points to SVG paths: fixed-point coordinates, windows on the plane, path data.

Everything is integer arithmetic.  A `Plane` rounds each point once to a grid
fine enough for the smallest thing to be shown; a `Window` maps a rectangle of
that grid to a rectangle of the page, in a whole number of units a pixel.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from gmpy2 import mpq, mpz

from bern_exact.exact.points import HPoint

XY = tuple[int, int]
"""A rounded point: fixed-point integers of a `Plane`, or units of a `Window`."""

DETAIL = 1000
"""Units a pixel in path data, unless a picture would grow too large."""

PLANE_BITS = 40
"""Fixed-point resolution: the larger extent is at least 2^PLANE_BITS units."""


@dataclass(frozen=True)
class Plane:
    """A bounding box and the unit to which points are rounded.

    Parameters
    ----------
    left, bottom : mpq
        The lower left corner of the box.
    scale : mpq
        Units a unit of length.
    width, height : int
        The box in units, at least 1 each.
    """

    left: mpq
    bottom: mpq
    scale: mpq
    width: int
    height: int

    @staticmethod
    def around(points: Sequence[HPoint], bits: int = PLANE_BITS) -> Plane:
        """The plane with these points' bounding box, the larger side 2^bits units; of none, a dot.

        >>> from bern_exact.exact.points import hpoint
        >>> plane = Plane.around([hpoint(0, 0), hpoint(2, 1)], bits=3)
        >>> plane.width, plane.height, plane.at(hpoint(1, mpq(1, 2)))
        (8, 4, (4, 2))
        """
        xs = [mpq(x, w) for x, _, w in points]
        ys = [mpq(y, w) for _, y, w in points]
        zero = mpq(0)
        left, bottom = min(xs, default=zero), min(ys, default=zero)
        width, height = max(xs, default=zero) - left, max(ys, default=zero) - bottom
        scale = mpq(mpz(1) << bits) / (max(width, height) or mpq(1))
        return Plane(left, bottom, scale, max(1, int(width * scale)), max(1, int(height * scale)))

    def at(self, point: HPoint) -> XY:
        """The rounded point, y upwards."""
        x, y, w = point
        return int((mpq(x, w) - self.left) * self.scale), int(
            (mpq(y, w) - self.bottom) * self.scale
        )

    def all(self, points: Iterable[HPoint]) -> list[XY]:
        """The rounded points, in order."""
        return [self.at(p) for p in points]


@dataclass(frozen=True)
class Window:
    """A rectangle of the plane shown in a rectangle of the page, equal aspect, y turned down.

    Parameters
    ----------
    left, bottom, width, height : int
        The rectangle of the plane, in its units.
    pixels : int
        How many pixels wide it is shown.
    detail : int
        Units a pixel in path data.
    """

    left: int
    bottom: int
    width: int
    height: int
    pixels: int
    detail: int = DETAIL

    @staticmethod
    def fitting(plane: Plane, across: int, down: int, detail: int = DETAIL) -> Window:
        """The whole of a plane, as large as fits a box of `across` by `down` pixels."""
        pixels = max(1, min(across, down * plane.width // plane.height))
        return Window(0, 0, plane.width, plane.height, pixels, detail)

    @staticmethod
    def centred(centre: XY, side: int, pixels: int) -> Window:
        """A square of the plane about a point."""
        side = max(side, 2)
        return Window(centre[0] - side // 2, centre[1] - side // 2, side, side, pixels)

    @property
    def pixels_down(self) -> int:
        """How many pixels high it is shown."""
        return max(1, self.pixels * self.height // self.width)

    def at(self, point: XY) -> XY:
        """Where a point is shown, in units from the upper left corner."""
        right, down = point[0] - self.left, self.bottom + self.height - point[1]
        return self._rounded(right), self._rounded(down)

    def _rounded(self, length: int) -> int:
        """The nearest whole number of units."""
        return (2 * length * self.pixels * self.detail + self.width) // (2 * self.width)

    def sees(self, ring: Sequence[XY]) -> bool:
        """Does the bounding box of these points meet the window?"""
        xs, ys = [x for x, _ in ring], [y for _, y in ring]
        return (
            min(xs) <= self.left + self.width
            and max(xs) >= self.left
            and min(ys) <= self.bottom + self.height
            and max(ys) >= self.bottom
        )

    def clipped(self, ring: Sequence[XY]) -> list[XY]:
        """A ring cut off well outside the window (Sutherland and Hodgman), rounded.

        Numbers that are large to a renderer's short floats then never reach it; what
        the cut itself draws lies outside the window.
        """
        low, high = self.left - self.width, self.left + 2 * self.width
        kept = _cut(_cut(ring, 0, low, 1), 0, high, -1)
        low, high = self.bottom - self.height, self.bottom + 2 * self.height
        return _cut(_cut(kept, 1, low, 1), 1, high, -1)


def _cut(ring: Sequence[XY], axis: int, bound: int, sign: int) -> list[XY]:
    """The part of a ring on one side of an axis-parallel line."""
    kept: list[XY] = []
    for i, q in enumerate(ring):
        p = ring[i - 1]
        before, here = sign * (p[axis] - bound), sign * (q[axis] - bound)
        if (before < 0 < here) or (here < 0 < before):
            across = p[1 - axis] + (q[1 - axis] - p[1 - axis]) * before // (before - here)
            kept.append((bound, across) if axis == 0 else (across, bound))
        if here >= 0:
            kept.append(q)
    return kept


def path_data(window: Window, rings: Iterable[Sequence[XY]], *, closed: bool = True) -> str:
    """SVG path data of rings (or open lines), in the window's units, relative after the start.

    A ring that rounds to a single point leaves nothing.

    >>> path_data(Window(0, 0, 10, 10, 1), [[(0, 0), (10, 0), (0, 10)]])
    'M0 1000l1000 0-1000-1000z'
    """
    parts = []
    for ring in rings:
        points = [window.at(p) for p in ring]
        steps = [
            (x - u, y - v)
            for (u, v), (x, y) in zip(points, points[1:], strict=False)
            if (x, y) != (u, v)
        ]
        if steps:
            parts.append(f"M{points[0][0]} {points[0][1]}l{_joined(steps)}{'z' if closed else ''}")
    return "".join(parts)


def _joined(steps: Sequence[XY]) -> str:
    """Numbers with a space between them only where no minus sign separates them."""
    text = " ".join(f"{x} {y}" for x, y in steps)
    return text.replace(" -", "-")


def text_of(value: str) -> str:
    """Text as it may stand in XML: escaped, characters that XML forbids replaced.

    >>> text_of("a<b" + chr(0)) == "a&lt;b" + chr(0xFFFD)
    True
    """
    allowed = "".join(c if _is_xml(ord(c)) else "\ufffd" for c in value)
    return allowed.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def _is_xml(code: int) -> bool:
    """Does XML 1.0 allow this character?"""
    return code in (9, 10, 13) or 32 <= code < 0xD800 or 0xDFFF < code < 0xFFFE or code > 0xFFFF
