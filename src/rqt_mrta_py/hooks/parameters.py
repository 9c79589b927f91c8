"""How plugins read a robot's parameters, and what they find wrong with those that fit their templates."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Tuple, Type, TypeVar

__all__ = ["ParameterProblem", "ParameterRangeError", "read_fields", "wrong_parameters"]

_Parameters = TypeVar("_Parameters")

_KINDS: Dict[type, str] = {bool: "true or false", float: "a number", int: "a whole number", str: "a text"}


class ParameterProblem(NamedTuple):
    """One parameter that an architecture cannot work with.

    Attributes:
        path: joined by ``/``, as in the robot's YAML file.
        message: what is wrong with the value; what is accepted.
    """

    path: str
    message: str


class ParameterRangeError(ValueError):
    """Parameters that a plugin cannot work with; a value that checks its own ranges refuses with all at once.

    Attributes:
        problems: all of them, with paths as in the robot's YAML file.
    """

    def __init__(self, problems: Tuple[ParameterProblem, ...]) -> None:
        self.problems = problems
        super().__init__("; ".join(f"{problem.path}: {problem.message}" for problem in problems))


def read_fields(kind: Type[_Parameters], given: Mapping[str, Any]) -> _Parameters:
    """Make parameters of one level; what is missing takes its default.

    Args:
        kind: a dataclass whose fields all have defaults, each a switch, a number, a whole number or a text; a value
            must be of its default's type, where a whole number is a number too. May raise ParameterRangeError.
        given: by field name, as in the robot's YAML file; other names are passed over.

    Raises:
        ParameterRangeError: carries everything that is wrong.
    """
    values: Dict[str, Any] = {}
    problems: List[ParameterProblem] = []
    for field in fields(kind):  # type: ignore[arg-type]  # there is no type for "a dataclass" below Python 3.13
        value = given.get(field.name, field.default)
        wanted = type(field.default)
        if wanted is float and type(value) is int:
            value = float(value)
        if type(value) is wanted:
            values[field.name] = value
        else:
            problems.append(ParameterProblem(field.name, f"must be {_KINDS[wanted]} (got {value!r})"))
    try:
        parameters = kind(**values)
    except ParameterRangeError as error:
        problems.extend(error.problems)
    if problems:
        raise ParameterRangeError(tuple(problems))
    return parameters


def wrong_parameters(read: Callable[[], object]) -> Tuple[ParameterProblem, ...]:
    """List everything that is wrong with parameters.

    Args:
        read: makes them, or raises ParameterRangeError.

    Returns:
        What it raised; empty if nothing is wrong.
    """
    try:
        read()
    except ParameterRangeError as error:
        return error.problems
    return ()
