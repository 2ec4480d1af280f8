"""The picture of Figure 9."""

from __future__ import annotations

from bern_exact.convex.bounce import bounce
from bern_exact.convex.faces import faces
from bern_exact.convex.frame import convex_frame
from bern_exact.convex.records import Bounced
from bern_exact.exact.points import coordinates
from bern_exact.view.bounced import bounced_layers, frame_layers, grid_layers
from bern_exact.view.stages import draw_stage
from tests.convex.polygons import family, shape

BOUNCED = bounce(convex_frame(family("random-hull", 40)))


def verticals(record: Bounced, style: str) -> list[object]:
    """Where a style has verticals."""
    (layer,) = [layer for layer in bounced_layers(record) if layer.style == style]
    ends = [[coordinates(p) for p in line] for line in layer.rings]
    return [p[0] for p, q in ends if p[0] == q[0]]


def test_each_vertical_is_drawn_in_the_colour_of_what_made_it() -> None:
    closed = {x for path in BOUNCED.closed for x in path}
    assert set(verticals(BOUNCED, "bounced")) == {step.x for step in BOUNCED.steps} - closed
    assert set(verticals(BOUNCED, "closed")) == closed
    ends = {x for x, _ in BOUNCED.frame.places if 0 < x < 1}
    assert set(verticals(BOUNCED, "line")) == ends


def test_horizontals_end_on_verticals() -> None:
    for layer in bounced_layers(BOUNCED):
        for line in layer.rings if layer.style != "outline" else ():
            assert all(coordinates(p)[0] in BOUNCED.verticals for p in line)


def test_the_frame_shows_the_diameter() -> None:
    styles = [layer.style for layer in frame_layers(BOUNCED.frame)]
    assert styles == ["line", "outline"]


def test_the_grid_shows_every_triangle_along_the_boundary() -> None:
    record = faces(BOUNCED)
    rim = next(layer for layer in grid_layers(record) if layer.style == "rim")
    assert len(rim.rings) == sum(len(leg.triangles) for leg in record.legs)


def test_a_triangle_has_pictures_too() -> None:
    frame = convex_frame(shape("triangle"))
    record = bounce(frame)
    for name, stage in (("framed", frame), ("bounced", record), ("gridded", faces(record))):
        picture = draw_stage(name, stage)
        assert picture is not None and picture.startswith("<svg")
