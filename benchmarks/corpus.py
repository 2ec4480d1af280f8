"""How many cases of a corpus are made a minute, and what a second worker is worth.

    python -m benchmarks.corpus                # the table on stdout, as Markdown
    python -m benchmarks.corpus --write        # and into benchmarks/RESULTS.md
    python -m benchmarks.corpus --count 24 --workers 1 2 4

Every run makes the same corpus in an empty directory; the wall clock counts, as it does for users.
It ends with exit code 1 if the corpora differ by a byte, or two workers are not `WANTED` times as
fast as one (which a machine of two free processors is needed for).
"""

from __future__ import annotations

import argparse
import sys
import time
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.results import machine, write_section
from bern_exact.corpus.generate import generate

WANTED = 1.7
TITLE = "Corpora: cases a minute"


def measure(count: int, workers: int) -> tuple[float, str, int]:
    """Seconds to make a corpus, its digest, and its bytes."""
    with TemporaryDirectory() as name:
        directory = Path(name) / "corpus"
        started = time.perf_counter()
        generate(directory, seed=1, count=count, workers=workers)
        seconds = time.perf_counter() - started
        digest, size = sha256(), 0
        for path in sorted(directory.rglob("*")):
            if path.is_file():
                content = path.read_bytes()
                digest.update(path.relative_to(directory).as_posix().encode() + b"\0" + content)
                size += len(content)
    return seconds, digest.hexdigest(), size


def main() -> int:
    """Run and print; 0 if all is as it should be."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--count", type=int, default=120)
    parser.add_argument("--workers", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--write", action="store_true", help="into benchmarks/RESULTS.md")
    options = parser.parse_args()
    lines = ["| workers | cases | MB | s | cases a minute | speed-up |"]
    lines += ["| --: | --: | --: | --: | --: | --: |"]
    digests, times = set[str](), dict[int, float]()
    for workers in options.workers:
        seconds, digest, size = measure(options.count, workers)
        digests.add(digest)
        times[workers] = seconds
        gain = times[options.workers[0]] / seconds
        lines.append(
            f"| {workers} | {options.count} | {size / 1e6:.1f} | {seconds:.1f} "
            f"| {60 * options.count / seconds:.0f} | {gain:.2f} |"
        )
        print(lines[-1], file=sys.stderr)
    text = f"{machine()}\n\n" + "\n".join(lines) + "\n"
    print(text)
    if options.write:
        write_section(Path(__file__).parent / "RESULTS.md", TITLE, text)
    slow = {1, 2} <= times.keys() and times[1] / times[2] < WANTED
    return 1 if slow or len(digests) > 1 else 0


if __name__ == "__main__":
    sys.exit(main())
