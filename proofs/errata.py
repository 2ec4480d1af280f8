"""`python -m proofs.errata --write`: docs/ERRATA.md and its drawings, from what is refuted."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

from proofs.drawings import DRAWINGS, svg
from proofs.errata_list import ERRATA, REMARKS, Erratum
from proofs.lemma_2.thresholds import LEAST
from proofs.statement import Entry
from proofs.table import table

DOCS = Path(__file__).resolve().parent.parent / "docs"
PAGE = "ERRATA.md"

HEAD = """# Errata

Sentences of Bern, Dobkin and Eppstein, *Triangulating Polygons without Large Angles*, that do not
hold as printed, each with the smallest exact counterexample that was found, and the repair. Every
counterexample is checked anew by `python -m proofs`, with the package's own construction and
checkers. This page is made by `python -m proofs.errata --write`; do not edit it.

With the repairs no order of growth that a theorem claims changes. What is marked *open* is asserted
exactly on every run instead. Lemma 2's blocks have a proof of their own in `proofs/lemma_2/`.
"""


def entry_of(name: str) -> Entry:
    """The statement `module.function`."""
    module, function = name.split(".")
    chapter = import_module(f"proofs.{module}").CHAPTER
    (found,) = (entry for entry in chapter.entries if entry.name == function)
    return found  # type: ignore[no-any-return]


def page() -> str:
    """The whole page; does the work of every refuted statement."""
    lines = [HEAD]
    for number, erratum in enumerate(ERRATA, 1):
        lines += [*_section(number, erratum)]
    lines += ["## Remarks\n"]
    lines += [f"- **{title}.** {text}" for title, text in REMARKS]
    return "\n".join([*lines, "", table()])


def _section(number: int, erratum: Erratum) -> Iterator[str]:
    refuted = entry_of(erratum.refuted).statement()
    yield f"## {number}. {erratum.where}\n"
    yield f"> {erratum.printed}\n"
    yield f"**Counterexample.** {erratum.counterexample}\n"
    yield f"Checked by `proofs/{_place(erratum.refuted)}`: {refuted.evidence}.\n"
    if erratum.drawing:
        yield f"![{erratum.where}](errata/{erratum.drawing}.svg)\n"
    yield f"**What goes wrong.** {erratum.wrong}\n"
    yield f"**Repair.** {erratum.repair}\n"
    for name in erratum.repaired:
        entry = entry_of(name)
        yield f"- *{entry.status}* (`proofs/{_place(name)}`): {entry.text}"
    if not erratum.repaired:
        yield (
            "- Lemma 2's blocks, *proved* for tau = 1/8, and their angles for tau from "
            f"{LEAST} on (`proofs/lemma_2/`, by `--full`); "
            "checked on every run (`lemma-2.block-*`)."
        )
    yield ""


def _place(name: str) -> str:
    module, function = name.split(".")
    return f"{module}.py`, `{function}"


def files() -> dict[str, str]:
    """Every file below docs/ that is made here, and what it must hold."""
    made = {f"errata/{name}.svg": svg(drawing) for name, drawing in DRAWINGS.items()}
    return {PAGE: page(), **made}


def main() -> int:
    """Write the files, or tell which are out of date."""
    parser = argparse.ArgumentParser(prog="python -m proofs.errata", description=main.__doc__)
    parser.add_argument("--write", action="store_true")
    write = parser.parse_args().write
    stale = 0
    for name, text in files().items():
        path = DOCS / name
        if path.exists() and path.read_text(encoding="utf-8") == text:
            continue
        stale += 1
        if write:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
        print(f"{'written' if write else 'out of date'}: docs/{name}")
    return 0 if write or not stale else 1


if __name__ == "__main__":
    raise SystemExit(main())
