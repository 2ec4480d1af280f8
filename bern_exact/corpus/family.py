"""What a family of polygons is: a function of parameters and a `Random`, and what it is for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from random import Random

from bern_exact.corpus.draws import Rings

Draw = Callable[[Random, Mapping[str, int]], Rings]
Range = tuple[int, int]


@dataclass(frozen=True)
class Family:
    """A family of polygons, or of rings that are none.

    Parameters
    ----------
    name : str
        In kebab-case.
    breaks : str
        One sentence: what it is meant to break.
    flags : tuple of str
        What every member has, from `bern_exact.corpus.flags.FLAGS`.
    parameters : mapping
        For each the least and the most that a case draws, uniformly; more can be asked for.
    draw : callable
        Rings from a `Random` and all parameters; they may fail to be a polygon, and are then
        drawn again.
    errors : tuple of str
        Of a family of bad polygons: the kinds of `InputError` that must refuse it.
    raw : bool
        Its polygons are so small that meshes are kept as they are, not thinned.
    says : callable, optional
        What is to be said of the member with these parameters.
    """

    name: str
    breaks: str
    flags: tuple[str, ...]
    parameters: Mapping[str, Range]
    draw: Draw
    errors: tuple[str, ...] = ()
    raw: bool = False
    says: Callable[[Mapping[str, int]], str] | None = None


def by_name(function: Callable[..., Rings]) -> Draw:
    """A function of a `Random` and named parameters as a `Draw`."""
    return partial(_call, function)


def by_seed(function: Callable[..., Rings], seeds: int = 10**9) -> Draw:
    """A function of named parameters and a seed, one of so many, as a `Draw`."""
    return partial(_call_with_seed, function, seeds)


def without_random(function: Callable[..., Rings]) -> Draw:
    """A function of named parameters alone as a `Draw`."""
    return partial(_call_alone, function)


# Not nested, so that families can be sent to other processes.


def _call(function: Callable[..., Rings], random: Random, parameters: Mapping[str, int]) -> Rings:
    return function(random, **parameters)


def _call_with_seed(
    function: Callable[..., Rings], seeds: int, random: Random, parameters: Mapping[str, int]
) -> Rings:
    return function(seed=random.randrange(seeds), **parameters)


def _call_alone(function: Callable[..., Rings], _: Random, parameters: Mapping[str, int]) -> Rings:
    return function(**parameters)
