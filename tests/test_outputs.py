"""Files are written whole or not at all."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from bern_exact.outputs import write_atomically


def test_it_writes_and_overwrites(tmp_path: Path) -> None:
    target = tmp_path / "x"
    write_atomically(target, "one\n")
    write_atomically(target, "two\n")
    assert target.read_bytes() == b"two\n"
    assert os.listdir(tmp_path) == ["x"]


def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path: Path) -> None:
    target = tmp_path / "x"
    target.write_text("old")
    with pytest.raises(UnicodeEncodeError):
        write_atomically(target, "\ud800")
    assert target.read_text() == "old"
    assert os.listdir(tmp_path) == ["x"]


def test_a_failure_names_the_file_that_was_asked_for(tmp_path: Path) -> None:
    target = tmp_path / "no such directory" / "x"
    with pytest.raises(FileNotFoundError) as failure:
        write_atomically(target, "new")
    assert failure.value.filename == str(target)


def test_permissions_are_kept(tmp_path: Path) -> None:
    target = tmp_path / "x"
    target.write_text("old")
    target.chmod(0o640)
    write_atomically(target, "new")
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "real").write_text("old")
    (tmp_path / "link").symlink_to("real")
    write_atomically(tmp_path / "link", "new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_text() == "new"


def test_a_device_is_written_to_and_not_replaced() -> None:
    write_atomically(Path("/dev/null"), "gone")
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


def test_a_directory_that_is_not_there_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        write_atomically(tmp_path / "no" / "x", "text")


def run_with(shell: str) -> subprocess.CompletedProcess[str]:
    """`bern-exact facts` on a real polygon, its stdout and stderr redirected."""
    words = f"{sys.executable} -m bern_exact facts examples/mdi_cog.json {shell}"
    root = Path(__file__).resolve().parent.parent
    return subprocess.run(words, shell=True, cwd=root, capture_output=True, text=True, check=False)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no full disk here")
@pytest.mark.parametrize("option", ["", "--json"])
def test_a_full_disk_is_no_traceback_and_not_the_answer_no(option: str) -> None:
    done = run_with(f"{option} > /dev/full")
    assert done.returncode == 2
    assert "standard output: No space left" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.skipif(os.name != "posix", reason="needs a POSIX shell")
@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-"])
def test_closed_streams_are_no_error(closed: str) -> None:
    done = run_with(closed)
    assert done.returncode == 0
    assert done.stderr == ""
