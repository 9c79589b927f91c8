"""Where in a scenario.yaml stands what a line of the simulation speaks of.

The simulation knows no files: its lines begin with a thing and its name, such as ``robot robot1``. What many robots
have from ``robot_defaults`` is one thing of the file, and is told once.
"""

from __future__ import annotations

import re
from typing import Any, Callable, Mapping, NamedTuple

from rqt_mrta_py.config.yaml.lines import YamlLines
from rqt_mrta_py.model import normalise_id

__all__ = ["Told", "located"]

_FORMS = (
    (re.compile(r"robot (?P<robot>\S+): (?=no robot model )"), "model"),
    (re.compile(r"robot (?P<robot>\S+): (?=no sensor \S+ for (?P<topic>\S+);)"), "sensors"),
    (re.compile(r"robot (?P<robot>\S+): (?=sensor \S+ on (?P<topic>\S+): )"), "sensors"),
    (re.compile(r"robot (?P<robot>\S+): (?=world \S+ lacks )"), "model"),
    (re.compile(r"robot (?P<robot>\S+): "), "start"),
    (re.compile(r"team (?=sensor \S+ on (?P<topic>\S+): )"), "sensors"),
    (re.compile(r"obstacle (?P<obstacle>\S+): "), ""),
    (re.compile(r"event (?P<event>\S+) at (?P<time>\S+) s: "), ""),
    (re.compile(r"scenario: (?=no world )"), "world"),
    (re.compile(r"scenario: (?=no radio )"), "radio/kind"),
    (re.compile(r"radio \S+: "), "radio"),
    (re.compile(r"arena: "), "arena"),
)
"""How lines begin, and the key that is meant."""


class Told(NamedTuple):
    """A problem of a scenario.

    Attributes:
        element: of the file that it is about; empty if that cannot be told.
        message: what is wrong with it.
    """

    element: str
    message: str


def located(line: str, lines: YamlLines) -> Told:
    """Find what a line speaks of.

    Args:
        line: of the simulation.
        lines: of the file, which its reader accepts.
    """
    for form, key in _FORMS:
        match = form.match(line)
        if match is not None:
            return Told(_element({"robot": "", "topic": "", **match.groupdict()}, key, lines), line[match.end() :])
    return Told("", line)


def _element(said: Mapping[str, Any], key: str, lines: YamlLines) -> str:
    if "obstacle" in said:
        return _entry("obstacles", lines, lambda entry: normalise_id(entry["id"]) == said["obstacle"])
    if "event" in said:
        kind, time = said["event"], said["time"]
        return _entry("events", lines, lambda entry: entry["kind"] == kind and f"{entry['time']:g}" == time)
    if not (said["robot"] or said["topic"]):
        return key
    owner = _entry("robots", lines, lambda entry: normalise_id(entry["id"]) == said["robot"]) if said["robot"] else ""
    # A key that a robot gives replaces the one in robot_defaults as a whole.
    if not (owner and lines.has(f"{owner}/{key}")) and lines.has(f"robot_defaults/{key}"):
        owner = "robot_defaults"
    owner = owner or "robots[0]"
    if said["topic"]:
        return _entry(f"{owner}/{key}", lines, lambda entry: entry["topic"] == said["topic"])
    return f"{owner}/{key}"


def _entry(holder: str, lines: YamlLines, fits: Callable[[Mapping[str, Any]], bool]) -> str:
    """Find an entry of a list; the list itself if none fits."""
    for index, entry in enumerate(lines.value(holder) or ()):
        if fits(entry):
            return f"{holder}[{index}]"
    return holder
