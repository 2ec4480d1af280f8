"""A corpus made by a real Dask scheduler and two workers, one of which is killed on the way."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.corpus.small import CHOICES, COUNT, SEED, contents

pytest.importorskip("distributed")

FAMILIES = [
    f"{choice.family}:" + ",".join(f"{k}={v}" for k, v in choice.given.items())
    if choice.given
    else choice.family
    for choice in CHOICES
]


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@contextmanager
def running(*words: str) -> Iterator[subprocess.Popen[bytes]]:
    """A program of Dask in the background, with all its children."""
    process = subprocess.Popen(
        [sys.executable, "-m", *words],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        yield process
    finally:
        kill(process)


def kill(process: subprocess.Popen[bytes]) -> None:
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def command(out: Path, address: str) -> list[str]:
    words = [sys.executable, "-m", "bern_exact", "corpus", "generate", "--dask", address]
    words += ["--out", str(out), "--seed", str(SEED), "--count", str(COUNT)]
    for family in FAMILIES:
        words += ["--family", family]
    return words


def test_one_of_two_workers_is_killed(corpus: Path, tmp_path: Path) -> None:
    address = f"tcp://127.0.0.1:{free_port()}"
    port = address.rpartition(":")[2]
    scheduler = ("distributed.cli.dask_scheduler", "--port", port, "--no-dashboard")
    worker = ("distributed.cli.dask_worker", address, "--no-dashboard", "--nthreads", "1")
    worker += ("--local-directory", str(tmp_path))
    with running(*scheduler), running(*worker) as first, running(*worker):
        out = tmp_path / "c"
        made = subprocess.Popen(
            command(out, address), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )
        until = time.monotonic() + 60
        while not any(out.glob("*/case.json")) and time.monotonic() < until:
            time.sleep(0.05)
        kill(first)
        said, _ = made.communicate(timeout=120)
        assert made.returncode == 0, said
    assert contents(out) == contents(corpus)


def test_no_scheduler_is_a_clear_error(tmp_path: Path) -> None:
    words = command(tmp_path / "c", f"tcp://127.0.0.1:{free_port()}")
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 2
    assert "no Dask scheduler answers" in done.stderr and "Traceback" not in done.stderr
