"""The pytest plugin: the fixture `exact_judge`.

It is loaded with every pytest of an environment in which this package is installed, so nothing else
is imported before a test asks for the fixture.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from bern_exact.testing import ExactJudge


@pytest.fixture
def exact_judge(tmp_path: Path) -> ExactJudge:
    """Assert exactly that a mesh is a triangulation, and save mesh and picture if it is not.

    A callable like `bern_exact.testing.assert_triangulation`::

        def test_my_mesher(exact_judge):
            vertices, triangles = my_mesher(polygon)
            exact_judge(vertices, triangles, polygon, max_angle=140)

    On failure `exact_judge_1.mesh.json`, `.polygon.json` and `.svg` are in the test's `tmp_path`.
    """
    from bern_exact.testing import ExactJudge

    return ExactJudge(tmp_path)
