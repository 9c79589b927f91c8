"""Makers of missions: tasks and scenario of an application follow from what users give, such as a drawing."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, Callable, FrozenSet, Mapping, NamedTuple, Optional, Tuple

__all__ = ["MadeMission", "MissionMaker", "MissionRequest", "MissionSetting"]

_NAME = re.compile(r"[a-z][a-z0-9_]*")


class MissionSetting(NamedTuple):
    """What a user may set, by ``--set name=value``.

    Attributes:
        name: lower case letters, digits and ``_``, a letter first.
        text: what it means and what is accepted, in one line.
        default: its value where the user gives none; may be empty.
    """

    name: str
    text: str
    default: str = ""


class MadeMission(NamedTuple):
    """The texts of a mission's files, as they would stand in ``tasks.yaml`` and ``scenario.yaml``."""

    tasks_yaml: str
    scenario_yaml: str


@dataclass(frozen=True)
class MissionRequest:
    """What a maker is asked.

    Attributes:
        settings: all of them with their values, by name.
        given: names of those that the user has given.
        robots: ids of all the application's robots, in order.
        team: ids of those that take part, the first ones.
        tasks_yaml: the application's own; empty where there is none.
        scenario_yaml: the application's own; empty where there is none.
        registered: gives what all plugins register by one hook, by name.
    """

    settings: Mapping[str, str]
    given: FrozenSet[str]
    robots: Tuple[str, ...]
    team: Tuple[str, ...]
    tasks_yaml: str
    scenario_yaml: str
    registered: Callable[[str], Mapping[str, Any]]


@dataclass(frozen=True)
class MissionMaker:
    """Makes the missions of one application.

    The same request has the same answer, to the byte: every node of a team makes the mission for itself.

    Attributes:
        settings: what can be set; each name once.
        make: does it. An ``MrtaError`` that it raises is told in one line, with its exit status.
        robots: how many of the application's robots take part where nobody says how many; its files are made for so
            many, and the maker is asked where others are wanted. None: all, and their number alone changes no files.

    Raises:
        ValueError: a name is none, or stands twice, or there are to be fewer than one robot.
    """

    settings: Tuple[MissionSetting, ...]
    make: Callable[[MissionRequest], MadeMission]
    robots: Optional[int] = None

    def __post_init__(self) -> None:
        names = [setting.name for setting in self.settings]
        for name in names:
            if not _NAME.fullmatch(name):
                raise ValueError(f"setting {name!r}: lower case letters, digits and '_' are accepted, a letter first")
            if names.count(name) > 1:
                raise ValueError(f"setting {name!r}: stands there twice")
        if self.robots is not None and self.robots < 1:
            raise ValueError(f"robots: must be 1 or more (found {self.robots})")
