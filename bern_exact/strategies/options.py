"""Options of strategies, checked when the strategy is asked for."""

from __future__ import annotations

from hypothesis.errors import InvalidArgument


def check_integer(name: str, value: object, least: int) -> None:
    """Refuse what is no integer of at least this size.

    Raises
    ------
    InvalidArgument
        With the option's name.
    """
    if not isinstance(value, int) or isinstance(value, bool):
        raise InvalidArgument(f"{name}={value!r} must be an integer")
    if value < least:
        raise InvalidArgument(f"{name}={value!r} must be at least {least}")


def check_range(low_name: str, low: object, high_name: str, high: object, least: int) -> None:
    """Refuse bounds on a number that are no integers from this on, or cross."""
    check_integer(low_name, low, least)
    check_integer(high_name, high, least)
    if isinstance(low, int) and isinstance(high, int) and low > high:
        raise InvalidArgument(f"{low_name}={low!r} is more than {high_name}={high!r}")


def check_boolean(name: str, value: object) -> None:
    """Refuse what is neither True nor False."""
    if not isinstance(value, bool):
        raise InvalidArgument(f"{name}={value!r} must be True or False")


def check_numbers(max_value: object, max_denominator: object, least: int) -> None:
    """Refuse bounds on coordinates between which there is nothing."""
    check_integer("max_value", max_value, least)
    check_integer("max_denominator", max_denominator, 1)
