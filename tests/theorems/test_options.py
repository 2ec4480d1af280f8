"""Which options go with which theorem, from Python."""

from __future__ import annotations

from typing import Any

import pytest

from bern_exact import triangulate
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.errors import InputError
from bern_exact.theorems.stages import RefusedOption
from tests.theorems.families import some_polygon


@pytest.mark.parametrize(
    ("theorem", "options", "said"),
    [
        (1, {"max_angle": 140}, "max angle is not an option of Theorem 1"),
        (
            4,
            {"max_angle": 140},
            "max angle is not an option of Theorem 4: its bound is 90 degrees$",
        ),
        (4, {"squares": True}, "squares is not an option of Theorem 4$"),
        (2, {"thin_angle": 120}, "^thin angle needs thin$"),
        (1, {"interior": "strips"}, "interior is not an option of Theorem 1"),
        (1, {"objective": "angle"}, "objective is not an option of Theorem 1"),
        (1, {"squares": True}, "squares is not an option of Theorem 1"),
        (2, {"interior": "best"}, "interior is not an option of Theorem 2"),
        (3, {"squares": True}, "squares is not an option of Theorem 3"),
        (3, {"interior": "bridges", "baseline": True}, "the baseline has no choice of interior"),
        (2, {"squares": True, "baseline": True}, "the baseline has no choice of squares"),
        (2, {"objective": "beauty"}, "objective 'beauty': one of fewest, height, angle"),
        (3, {"interior": "holes"}, "interior 'holes': one of strips, bridges, best"),
        (2, {"check": "some"}, "check 'some': one of every-stage, final, none"),
        (5, {}, "no theorem 5"),
        (2, {"max_angle": 135}, "135 is not within reach"),
        (2, {"max_angle": "135.05"}, "135.05 is not within reach"),
        (3, {"max_angle": "150.1"}, "150.1 is above 150"),
        (2, {"max_angle": 140, "baseline": True, "squares": True}, "no choice of squares"),
    ],
)
def test_what_does_not_go_together_is_refused(
    theorem: int, options: dict[str, Any], said: str
) -> None:
    with pytest.raises(RefusedOption, match=said):
        triangulate(some_polygon("triangle", 1), theorem=theorem, **options)


@pytest.mark.parametrize("text", ["nonsense", "-1", "181", "cos:2:1/2", "nan"])
def test_an_angle_that_is_none(text: str) -> None:
    with pytest.raises(InputError):
        triangulate(some_polygon("triangle", 1), max_angle=text)


@pytest.mark.parametrize(
    ("kind", "theorem", "expected"),
    [("simple", None, 2), ("plate", None, 3), ("simple", 3, 3), ("plate", 1, 1), ("simple", 2, 2)],
)
def test_which_theorem(kind: str, theorem: int | None, expected: int) -> None:
    made = triangulate(some_polygon(kind, 0), theorem=theorem, check="none")
    assert made.certificate.theorem == expected


@pytest.mark.parametrize(("kind", "theorem"), [("simple", 2), ("plate", 3)])
def test_the_certificate_names_the_stages_of_the_boundary(kind: str, theorem: int) -> None:
    made = triangulate(some_polygon(kind, 0), check="final")
    assert made.certificate.theorem == theorem and made.certificate.holds
    assert {"merged", "partition", "tiled"} <= made.stages.keys()
    assert made.certificate.triangles == len(made.mesh.triangles)


def test_a_bound_that_is_read_already() -> None:
    polygon = some_polygon("simple", 0)
    written, read = (
        triangulate(polygon, max_angle=bound, check="none").document
        for bound in ("140", parse_angle_bound("140"))
    )
    assert written == read


def test_baselines_of_theorems_2_and_3_keep_150_degrees() -> None:
    polygon = some_polygon("plate", 0)
    made = triangulate(polygon, baseline=True)
    assert made.certificate.holds
    assert parse_angle_bound("150").admits(made.certificate.worst.max_angle)
