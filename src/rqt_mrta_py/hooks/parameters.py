"""What a plugin finds wrong with parameters that fit their templates."""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["ParameterProblem"]


class ParameterProblem(NamedTuple):
    """One parameter that an architecture cannot work with.

    Attributes:
        path: joined by ``/``, as in the robot's YAML file.
        message: what is wrong with the value; what is accepted.
    """

    path: str
    message: str
