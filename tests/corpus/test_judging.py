"""Other people's meshes and verdicts, held against a corpus."""

from __future__ import annotations

import json
import shutil
from collections import Counter
from pathlib import Path

import pytest

from bern_exact.corpus.judging import NOTHING, Criterion, judge_results
from bern_exact.corpus.plan import Plan
from bern_exact.exact.angle_bound import parse_angle_bound
from bern_exact.exact.errors import InputError
from tests.corpus.small import CHOICES, COUNT, SEED

STAR, HOLES = CHOICES[0].case(0), CHOICES[2].case(0)


def counts(corpus: Path, results: Path, criterion: Criterion = NOTHING) -> Counter[str]:
    return Counter(outcome.result for outcome in judge_results(corpus, results, criterion))


def right_answers(corpus: Path) -> dict[str, str]:
    """What a correct verifier says of every damaged mesh."""
    return {
        f"{path.parent.parent.name}/{defect['name']}": defect["result"]
        for path in sorted(corpus.glob("*/defects/defects.json"))
        for defect in json.loads(path.read_text())["defects"]
    }


def write(results: Path, verdicts: object) -> Path:
    (results / "verdicts.json").write_text(json.dumps(verdicts))
    return results


def test_our_own_meshes_pass(corpus: Path, tmp_path: Path) -> None:
    for case in (STAR, HOLES, CHOICES[0].case(1)):
        shutil.copy(corpus / case / "theorem-1.mesh.json", tmp_path / f"{case}.mesh.json")
    assert counts(corpus, tmp_path) == {"passed": 3}


def test_a_mesh_in_another_format_is_read(corpus: Path, tmp_path: Path) -> None:
    for suffix in ("node", "ele"):
        shutil.copy(corpus / STAR / f"theorem-1.{suffix}", tmp_path / f"{STAR}.{suffix}")
    outcome = judge_results(corpus, tmp_path)[0]
    assert outcome.name == STAR and outcome.result in ("passed", "invalid")


def test_an_angle_bound_is_asked_of_meshes(corpus: Path, tmp_path: Path) -> None:
    shutil.copy(corpus / STAR / "theorem-2.mesh.json", tmp_path / f"{STAR}.mesh.json")
    assert counts(corpus, tmp_path, Criterion(parse_angle_bound("150")))["passed"] == 1
    tight = judge_results(corpus, tmp_path, Criterion(parse_angle_bound("61")))
    assert tight[0].result == "invalid" and tight[0].kinds == ("angle-above-bound",)


def test_a_damaged_mesh_is_invalid_by_its_defect(corpus: Path, tmp_path: Path) -> None:
    defects = json.loads((corpus / STAR / "defects/defects.json").read_text())["defects"]
    bad = next(d for d in defects if d["result"] == "invalid" and not d["criterion"])
    shutil.copy(corpus / STAR / bad["file"], tmp_path / f"{STAR}.json")
    outcome = judge_results(corpus, tmp_path)[0]
    assert outcome.result == "invalid" and outcome.kinds and outcome.message


def test_what_cannot_be_read_says_so(corpus: Path, tmp_path: Path) -> None:
    (tmp_path / f"{STAR}.mesh.json").write_text("{")
    outcome = judge_results(corpus, tmp_path)[0]
    assert outcome.result == "unreadable" and outcome.kinds == ("syntax",)


def test_right_verdicts_pass(corpus: Path, tmp_path: Path) -> None:
    verdicts = right_answers(corpus)
    assert counts(corpus, write(tmp_path, verdicts)) == {"passed": len(verdicts)}


def test_a_verifier_that_accepts_all_is_found_out(corpus: Path, tmp_path: Path) -> None:
    verdicts = right_answers(corpus)
    outcomes = judge_results(corpus, write(tmp_path, dict.fromkeys(verdicts, "valid")))
    wrong = [outcome for outcome in outcomes if outcome.result == "wrongly accepted"]
    assert len(wrong) == list(verdicts.values()).count("invalid")
    assert all(len(outcome.kinds) == 1 for outcome in wrong)


def test_a_verifier_that_refuses_all_is_found_out(corpus: Path, tmp_path: Path) -> None:
    verdicts = right_answers(corpus)
    refused = counts(corpus, write(tmp_path, dict.fromkeys(verdicts, "invalid")))
    assert refused["wrongly refused"] == list(verdicts.values()).count("valid")


def test_what_has_no_verdict_is_missing(corpus: Path, tmp_path: Path) -> None:
    verdicts = right_answers(corpus)
    name = next(iter(verdicts))
    assert counts(corpus, write(tmp_path, {name: verdicts[name]})) == {
        "passed": 1,
        "missing": len(verdicts) - 1,
    }


def test_polygons_and_good_meshes_have_verdicts_too(corpus: Path, tmp_path: Path) -> None:
    verdicts = {f"{STAR}/theorem-1": "invalid", f"{CHOICES[1].case(0)}/polygon": "valid"}
    found = counts(corpus, write(tmp_path, verdicts))
    assert found["wrongly refused"] == found["wrongly accepted"] == 1


@pytest.mark.parametrize("verdicts", [[], {"nothing/like-it": "valid"}, {f"{STAR}/theorem-1": 1}])
def test_verdicts_that_are_refused(corpus: Path, tmp_path: Path, verdicts: object) -> None:
    with pytest.raises(InputError):
        judge_results(corpus, write(tmp_path, verdicts))


def test_nothing_to_be_judged_is_an_error(corpus: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"verdicts\.json"):
        judge_results(corpus, tmp_path)


def test_every_case_has_an_outcome(corpus: Path, tmp_path: Path) -> None:
    shutil.copy(corpus / STAR / "theorem-1.mesh.json", tmp_path / f"{STAR}.mesh.json")
    valid = [case for case in Plan(SEED, COUNT, CHOICES).cases() if "bad" not in case]
    assert [outcome.name for outcome in judge_results(corpus, tmp_path)] == valid
