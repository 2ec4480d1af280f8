"""Pictures of blocks, of removed lines and of the recursion's parts."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree

from gmpy2 import mpq

from bern_exact.convex.merge import merge
from bern_exact.convex.reduction import reduce_blocks
from bern_exact.trace import Trace
from bern_exact.view.blocks import PARTS, merged_layers, part_layers, reduced_layers
from bern_exact.view.layers import Layer
from bern_exact.view.stages import draw_stage, more_pictures
from tests.convex.samples import disc, rectangle

SVG = "{http://www.w3.org/2000/svg}"
MERGED = merge(disc(40))
REDUCED = reduce_blocks(MERGED)


def rings(layers: list[Layer]) -> dict[str, int]:
    return {layer.style: len(layer.rings) for layer in layers}


def classes(picture: str) -> set[str | None]:
    return {path.get("class") for path in ElementTree.fromstring(picture).iter(f"{SVG}path")}


def test_every_block_is_drawn() -> None:
    found = rings(merged_layers(MERGED))
    assert found["cell"] == found["outline"] == len(MERGED.blocks)


def test_every_triangle_and_every_removed_line_is_drawn() -> None:
    found = rings(reduced_layers(REDUCED))
    assert found["cell"] + found["halved"] == REDUCED.number
    removed = sum(len(node.removed) for block in REDUCED.blocks for node in block.nodes)
    assert found["removed"] == removed


def test_each_use_of_lemma_10_has_its_triangle() -> None:
    uses = sum(len(list(node.halved())) for block in REDUCED.blocks for node in block.nodes)
    assert rings(reduced_layers(REDUCED))["halved"] == uses > 0


def test_the_seven_parts_and_the_strips_between_them() -> None:
    """Narrow columns on both sides of wide ones: both outer parts are cut in three."""
    columns = [mpq(1, 9)] * 4 + [mpq(2)] * 6 + [mpq(1, 9)] * 4
    rows = [mpq(1, 2)] * 2 + [mpq(1)] * 6 + [mpq(1, 2)] * 2
    found = rings(part_layers(reduce_blocks(rectangle(columns, rows))))
    assert {name: found[name] for name in (*PARTS, "strip")} == {
        "outer": 4,
        "halfway": 2,
        "between": 1,
        "strip": 6,
    }


def test_all_three_are_pictures() -> None:
    merged, reduced = draw_stage("merged", MERGED), draw_stage("reduced", REDUCED)
    assert merged is not None
    assert reduced is not None
    assert {"cell", "line", "outline"} == classes(merged)
    assert {"cell", "halved", "removed", "outline"} == classes(reduced)
    ((name, parts),) = more_pictures("reduced", REDUCED)
    assert name == "parts"
    assert {"strip", "between", "line"} <= classes(parts)


def test_a_trace_keeps_all_of_them(tmp_path: Path) -> None:
    trace = Trace(tmp_path)
    trace.stage("merged", MERGED)
    trace.stage("reduced", REDUCED)
    stems = ("01-merged.json", "01-merged.svg", "02-reduced-parts.svg", "02-reduced.json")
    assert sorted(p.name for p in tmp_path.iterdir()) == [*stems, "02-reduced.svg"]
    record = json.loads((tmp_path / "02-reduced.json").read_text())
    assert record["merged"] == {"stage": "merged"}
