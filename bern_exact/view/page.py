"""The page of a picture: title, the whole, a legend and enlargements, as SVG elements."""

from __future__ import annotations

from collections.abc import Sequence

from bern_exact.view.canvas import Window, text_of

Path = tuple[str, str]
"""The class of a path and its data."""

SCALES = {1000: ".001", 20: ".05"}
"""1 / detail as text, for the details in use."""

COLOURS = {
    "interior": ("#eef3f6", "#b6c5cf"),
    "rectangle": ("#e9eef8", "#a9b7d6"),
    "boundary": ("#f8e8c4", "#c9a657"),
    "merged": ("#f6efc9", "#bfae55"),
    "block": ("#f3cda5", "#bf7f45"),
    "fan": ("#d5e8d0", "#7fa876"),
    "cell": ("#e9eef8", "#a9b7d6"),
    "rim": ("#f8e8c4", "#c9a657"),
    "mesh": ("#eef3f6", "#b6c5cf"),
    "bounced": ("none", "#b3261e"),
    "closed": ("none", "#1d7a3e"),
    "halved": ("#f3cda5", "#bf7f45"),
    "removed": ("none", "#b3261e"),
    "strip": ("#f8e8c4", "#c9a657"),
    "outer": ("#d5e8d0", "#7fa876"),
    "halfway": ("#cfe3ea", "#6f9fb0"),
    "between": ("#e6dcf1", "#9d86bd"),
}
"""Fill and stroke of each class of triangles."""

LABELS = {
    "interior": "inside: two sweeps (Lemma 3)",
    "rectangle": "inside: rectangles (Lemmas 6 to 8)",
    "boundary": "faces along the boundary (Lemma 2)",
    "merged": "merged along an edge (Lemma 5)",
    "block": "faces round a vertex (Lemma 2)",
    "fan": "lopped corners (Lemma 1)",
    "cell": "inside: rectangles (Section 5)",
    "rim": "along the boundary (Lemma 9)",
    "mesh": "triangles",
    "bounced": "bounced paths (Figure 9)",
    "closed": "closed paths",
    "halved": "where a line ends (Lemma 10)",
    "removed": "lines removed (Lemma 11)",
    "strip": "strips l and r, t and b",
    "outer": "outer parts, all lines",
    "halfway": "outer parts, half the columns",
    "between": "between l and r, fewer lines",
}

MARGIN = 28
HEADING = 86
COLUMN = 290
INSET = 250
LEGEND_LINE = 24
CAPTION = 58

STROKES = {
    "outline": 1100,
    "line": 500,
    "removed": 500,
    "bounced": 700,
    "closed": 700,
    "markA": 1600,
    "markB": 1600,
}
"""Stroke widths in 1/1000 pixel, of paths; 350 for all others.

`vector-effect` would keep strokes thin at any zoom, but not every viewer knows it.
"""

MARK_COLOURS = {"A": "#b3261e", "B": "#1d5fa8"}

STYLE = (
    "text{font-family:Helvetica,Arial,sans-serif;fill:#27323a}"
    ".title{font-size:24px;font-weight:600}.note{font-size:14px;fill:#5a6872}"
    ".strong{font-size:14px;font-weight:600}"
    "path{stroke-linejoin:round}"
    ".paper{fill:#fff}.frame{fill:none;stroke:#c3ccd2;stroke-width:1}"
    ".outline{fill:none;stroke:#27323a}.line{fill:none;stroke:#8496a3}"
    + "".join(f".{name}{{fill:{fill};stroke:{stroke}}}" for name, (fill, stroke) in COLOURS.items())
    + "".join(
        f".mark{letter}{{fill:{colour};fill-opacity:.28;stroke:{colour}}}"
        f".ring{letter}{{fill:none;stroke:{colour};stroke-width:1.8}}"
        f".text{letter}{{fill:{colour};font-size:15px;font-weight:700}}"
        for letter, colour in MARK_COLOURS.items()
    )
)


class Page:
    """A page with room for a whole of some size and, at its right, a column.

    Parameters
    ----------
    window : Window
        What the whole shows.
    legend : sequence of str
        The classes that the legend names.
    insets : int
        How many enlargements will follow.
    """

    def __init__(self, window: Window, legend: Sequence[str], insets: int) -> None:
        self._window = window
        self._column = MARGIN + window.pixels + MARGIN
        self._below_legend = HEADING + LEGEND_LINE * len(legend) + MARGIN // 2
        column = self._below_legend + insets * (INSET + CAPTION)
        self.width = self._column + COLUMN + MARGIN
        self.height = max(HEADING + window.pixels_down, column) + MARGIN
        self._elements: list[str] = []
        for number, name in enumerate(legend):
            self._legend_line(HEADING + LEGEND_LINE * number, name)

    def heading(self, title: str, subtitle: str) -> None:
        """The two lines at the top."""
        self._text(MARGIN, 42, "title", title)
        self._text(MARGIN, 66, "note", subtitle)

    def whole(self, paths: Sequence[Path]) -> None:
        """The paths of the whole, in its window's units."""
        self._group(MARGIN, HEADING, self._window, paths)

    def inset(
        self, letter: str, window: Window, paths: Sequence[Path], lines: tuple[str, str]
    ) -> None:
        """An enlargement: framed, cut off at its frame, with two lines above it."""
        top = self._below_legend + "AB".index(letter) * (INSET + CAPTION) + CAPTION - 10
        left = self._column
        self._text(left, top - 27, f"text{letter}", letter)
        self._text(left + 18, top - 27, "strong", lines[0])
        self._text(left, top - 8, "note", lines[1])
        box = f'x="{left}" y="{top}" width="{INSET}" height="{INSET}"'
        self._elements.append(f'<clipPath id="cut{letter}"><rect {box}/></clipPath>')
        self._elements.append(f'<g clip-path="url(#cut{letter})">')
        self._group(left, top, window, paths)
        self._elements.append(f'</g><rect class="frame" {box}/>')

    def ring(self, letter: str, at: tuple[int, int]) -> None:
        """A ring round a place of the whole (in its window's units), with its letter."""
        x, y = MARGIN + at[0] // self._window.detail, HEADING + at[1] // self._window.detail
        self._elements.append(f'<circle class="ring{letter}" cx="{x}" cy="{y}" r="9"/>')
        self._text(x + 12, y - 8, f"text{letter}", letter)

    def text(self) -> str:
        """The whole file."""
        return "\n".join(
            [
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}"'
                f' height="{self.height}" viewBox="0 0 {self.width} {self.height}">',
                f"<style>{STYLE}</style>",
                f'<rect class="paper" width="{self.width}" height="{self.height}"/>',
                *self._elements,
                "</svg>\n",
            ]
        )

    def _legend_line(self, top: int, name: str) -> None:
        box = f'x="{self._column}" y="{top}" width="22" height="14" stroke-width="1"'
        self._elements.append(f'<rect class="{name}" {box}/>')
        self._text(self._column + 32, top + 12, "note", LABELS[name])

    def _group(self, left: int, top: int, window: Window, paths: Sequence[Path]) -> None:
        scale = SCALES[window.detail]
        self._elements.append(f'<g transform="translate({left} {top}) scale({scale})">')
        for name, data in paths:
            width = STROKES.get(name, 350) * window.detail // 1000
            self._elements.append(f'<path class="{name}" stroke-width="{width}" d="{data}"/>')
        self._elements.append("</g>")

    def _text(self, x: int, y: int, kind: str, value: str) -> None:
        if value:
            self._elements.append(f'<text class="{kind}" x="{x}" y="{y}">{text_of(value)}</text>')
