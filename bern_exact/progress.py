"""What people see while a long run goes on: a bar on stderr, if that is a terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable
from types import TracebackType
from typing import Self

from rich.console import Console
from rich.progress import BarColumn, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.progress import Progress as Bar

StageListener = Callable[[str, object], None]
"""Called with a stage's name and its record."""


class _OnStderr:
    """A bar on stderr, if that is a terminal, while its block runs."""

    def __init__(self, first: str, total: int | None) -> None:
        self._bar = Bar(
            SpinnerColumn(),
            TextColumn("{task.description}"),
            BarColumn(),
            TimeElapsedColumn(),
            console=Console(stderr=True),
            transient=True,
            disable=sys.stderr is None or not sys.stderr.isatty(),
        )
        self._task = self._bar.add_task(first, total=total)

    def __enter__(self) -> Self:
        self._bar.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._bar.stop()


class Progress(_OnStderr):
    """A progress bar over the stages of a run, and a way for others to listen along.

    Without a terminal on stderr nothing is shown.

    Parameters
    ----------
    stages : int, optional
        How many stages are expected, if that is known.
    """

    def __init__(self, stages: int | None) -> None:
        super().__init__("reading", stages)
        self._listeners: list[StageListener] = []

    def follow(self, listener: StageListener) -> None:
        """Let somebody else see each stage's record, too."""
        self._listeners.append(listener)

    def stage(self, name: str, record: object) -> None:
        """A stage is done."""
        self._bar.update(self._task, advance=1, description=f"{name} done")
        for listener in self._listeners:
            listener(name, record)


class Counting(_OnStderr):
    """A progress bar over things that are counted.

    Parameters
    ----------
    total : int, optional
        How many are expected, if that is known.
    """

    def __init__(self, total: int | None) -> None:
        super().__init__("begun", total)

    def done(self, name: str, done: int, total: int) -> None:
        """So many of so many are done, this one last."""
        self._bar.update(self._task, completed=done, total=total, description=name)
