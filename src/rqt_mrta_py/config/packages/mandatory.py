"""Parameters of a new application that are mandatory and have no value yet."""

from __future__ import annotations

from typing import Iterable, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.config.parameters.lookup import template_at
from rqt_mrta_py.config.parameters.resolving import MANDATORY
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.model import ArchitectureSpec, ParameterTemplate

__all__ = ["MissingValue", "missing_values"]


class MissingValue(NamedTuple):
    """A value that must be given.

    Attributes:
        path: robot or config first.
        template: what the architecture says of it.
    """

    path: str
    template: ParameterTemplate


def missing_values(
    problems: Iterable[Problem], robots: Sequence[str], architecture: ArchitectureSpec
) -> Tuple[MissingValue, ...]:
    """Find out which values would end problems.

    Args:
        problems: of an application.
        robots: its ids.
        architecture: whose templates it fills in.

    Returns:
        The values, in the order of the problems; nothing for a problem that no value ends.
    """
    found = []
    for problem in problems:
        if problem.message.startswith(MANDATORY):
            value = _find(problem.element, robots, architecture)
            if value is not None:
                found.append(value)
    return tuple(found)


def _find(element: str, robots: Sequence[str], architecture: ArchitectureSpec) -> Optional[MissingValue]:
    for config in architecture.configs:
        owners = robots if config.id == architecture.robot_config_id else (config.id,)
        named = [(f"{owner}/", element[len(owner) + 1 :]) for owner in owners if element.startswith(f"{owner}/")]
        for prefix, rest in named:
            template = template_at(config.items, tuple(rest.split("/")))
            if template is not None:
                return MissingValue(prefix + rest, template)
    return None
