"""Real outlines: letters, icons, a county and a country with their holes.

They ship in `outlines/`, each with its source and licence; its README says more.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import resources

from bern_exact.corpus.draws import Rings, nth, places
from bern_exact.corpus.family import Family, without_random
from bern_exact.formats import safe_json
from bern_exact.formats.polygon_json import read_polygon

NAMES = (
    "glyph_dejavusans_A",
    "us_county_51015_augusta",
    "mdi_chip",
    "mdi_grid",
    "mdi_raspberry-pi",
    "glyph_dejavuserif-italic_g",
    "mdi_steering",
    "glyph_dejavusans_B",
    "ne_united_arab_emirates_50m",
    "mdi_puzzle",
)
"""By size, from 11 to 160 vertices."""

SMALL = 3
"""So many of them are drawn unless others are asked for: a case should take a second."""


def outline(which: int) -> Rings:
    """The outline of this number."""
    document = _document(nth(NAMES, which))
    polygon = read_polygon(document)
    return places([polygon.input_ring(ring) for ring in range(len(polygon.rings))])


@cache
def _document(name: str) -> dict[str, object]:
    """What the file of an outline holds."""
    file = resources.files("bern_exact.corpus") / "outlines" / f"{name}.json"
    with file.open("rb") as stream:
        document: dict[str, object] = safe_json.load(stream)
    return document


def _says(parameters: Mapping[str, int]) -> str:
    name = NAMES[parameters["which"]]
    return f"{name}: {_document(name)['source']}."


FAMILIES = (
    Family(
        "outline",
        "what made-up polygons never have: the proportions, the noise and the near-collinear runs "
        "of real data",
        ("real", "listed"),
        {"which": (0, SMALL - 1)},
        without_random(outline),
        says=_says,
    ),
)
