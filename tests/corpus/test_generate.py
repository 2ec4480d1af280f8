"""Corpora: the same bytes however they come about, and never half a case."""

from __future__ import annotations

import errno
import os
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from bern_exact.corpus import storage
from bern_exact.corpus.case import case_files
from bern_exact.corpus.generate import generate
from bern_exact.corpus.plan import Plan
from bern_exact.exact.errors import InputError
from tests.corpus import small
from tests.corpus.small import CHOICES, COUNT, SEED, contents


def test_a_case_is_a_function_of_seed_and_id(corpus: Path) -> None:
    for case in Plan(SEED, COUNT, CHOICES).cases():
        files = {name: text.encode() for name, text in case_files(SEED, case).items()}
        assert files == contents(corpus / case)


def test_other_seeds_are_other_cases() -> None:
    case = CHOICES[0].case(0)
    assert case_files(1, case)["polygon.json"] != case_files(2, case)["polygon.json"]


def test_processes_make_the_same(corpus: Path, tmp_path: Path) -> None:
    assert contents(small.made(tmp_path / "two", workers=2)) == contents(corpus)


def test_any_executor_will_do(corpus: Path, tmp_path: Path) -> None:
    with ThreadPoolExecutor(2) as pool:
        generate(tmp_path / "c", seed=SEED, count=COUNT, families=CHOICES, executor=pool)
    assert contents(tmp_path / "c") == contents(corpus)


def test_what_is_there_is_kept(corpus: Path, tmp_path: Path) -> None:
    directory = tmp_path / "copy"
    shutil.copytree(corpus, directory)
    said: list[str] = []
    generate(
        directory,
        seed=SEED,
        count=COUNT,
        families=CHOICES,
        listener=lambda case, done, total: said.append(case),
    )
    assert not said


@pytest.mark.parametrize("what", ["file-removed", "file-changed", "folder-removed", "half-written"])
def test_what_is_broken_is_made_again(corpus: Path, tmp_path: Path, what: str) -> None:
    directory = tmp_path / "copy"
    shutil.copytree(corpus, directory)
    case = CHOICES[0].case(0)
    match what:
        case "file-removed":
            (directory / CHOICES[0].case(0) / "facts.json").unlink()
        case "file-changed":
            (directory / CHOICES[0].case(0) / "polygon.wkt").write_text("POLYGON EMPTY")
        case "folder-removed":
            shutil.rmtree(directory / CHOICES[0].case(0))
        case "half-written":
            (directory / CHOICES[0].case(0)).rename(directory / f"{storage.PARTIAL}{case}")
            (directory / "manifest.json").unlink()
    assert contents(small.made(directory)) == contents(corpus)


def test_a_shorter_corpus_goes_on_to_a_longer_one(corpus: Path, tmp_path: Path) -> None:
    directory = small.made(tmp_path / "c", count=1)
    assert contents(small.made(directory)) == contents(corpus)


def test_another_corpus_is_left_alone(corpus: Path, tmp_path: Path) -> None:
    directory = tmp_path / "copy"
    shutil.copytree(corpus, directory)
    with pytest.raises(InputError, match="not of this corpus"):
        small.made(directory, count=1)
    with pytest.raises(InputError, match=f"of seed {SEED}, not 6"):
        generate(directory, seed=6, count=COUNT, families=CHOICES)
    assert contents(directory) == contents(corpus)


def test_a_directory_with_other_files_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("all my work")
    with pytest.raises(InputError, match=r"thesis\.tex"):
        small.made(tmp_path)
    assert list(tmp_path.iterdir()) == [tmp_path / "thesis.tex"]


def test_when_the_disk_is_full_no_case_is_broken(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    room = 30_000
    write = Path.write_text

    def write_text(path: Path, text: str, *args: object, **options: str) -> int:
        nonlocal room
        room -= len(text)
        if room < 0:
            write(path, text[: max(0, len(text) // 2)], **options)
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))
        return write(path, text, **options)

    monkeypatch.setattr(Path, "write_text", write_text)
    with pytest.raises(OSError, match="No space left"):
        small.made(tmp_path)
    cases = list(Plan(SEED, COUNT, CHOICES).cases())
    assert all(path.name in cases for path in tmp_path.iterdir())
    assert all(storage.is_complete(tmp_path, SEED, path.name) for path in tmp_path.iterdir())


def test_a_read_only_directory_is_an_error(tmp_path: Path) -> None:
    if os.geteuid() == 0:
        target = Path("/proc/corpus")  # not even root can write there
    else:
        target = tmp_path / "corpus"
        target.mkdir(mode=0o500)
    with pytest.raises(OSError):
        small.made(target)


COMMAND = [sys.executable, "-m", "bern_exact", "corpus", "generate", "--seed", str(SEED)]
COMMAND += ["--count", str(COUNT), "--family", "star:n=4", "--family", "bad-edges-cross"]
COMMAND += ["--family", "paper-holes:side=1", "--workers", "2"]


def test_killed_at_any_moment_and_run_again_it_ends_the_same(corpus: Path, tmp_path: Path) -> None:
    directory = tmp_path / "c"
    for wait in (0.6, 1.1, 2.0):
        run = subprocess.Popen(
            [*COMMAND, "--out", str(directory)],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        time.sleep(wait)
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
    done = subprocess.run(
        [*COMMAND, "--out", str(directory)],
        env={**os.environ, "PYTHONHASHSEED": "77"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert contents(directory) == contents(corpus)


def test_workers_end_with_the_process_that_started_them(tmp_path: Path) -> None:
    words = ["corpus", "generate", "--out", str(tmp_path), "--seed", "9", "--count", "400"]
    run = subprocess.Popen(
        [sys.executable, "-m", "bern_exact", *words, "--workers", "2"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    assert run.stderr is not None
    while not any(tmp_path.iterdir()) and run.poll() is None:
        time.sleep(0.05)
    run.kill()
    run.stderr.read()  # ends when the last worker has closed it
    assert run.wait() == -signal.SIGKILL
