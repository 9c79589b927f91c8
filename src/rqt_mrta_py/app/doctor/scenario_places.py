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

_SENSOR = r"sensor \S+ on (?P<topic>\S+): (?:parameter (?P<parameter>\w+): )?"
_FORMS = (
    (re.compile(r"robot (?P<robot>\S+): (?=no robot model )"), "model"),
    (re.compile(r"robot (?P<robot>\S+): (?=no sensor \S+ for (?P<topic>\S+);)"), "sensors"),
    (re.compile(r"robot (?P<robot>\S+): " + _SENSOR), "sensors"),
    (re.compile(r"robot (?P<robot>\S+): (?=world \S+ lacks )"), "model"),
    (re.compile(r"robot (?P<robot>\S+): (?=the id )"), "id"),
    (re.compile(r"robot (?P<robot>\S+): "), "start"),
    (re.compile(r"team " + _SENSOR), "sensors"),
    (re.compile(r"obstacle (?P<obstacle>\S+): "), ""),
    (re.compile(r"body (?P<body>\S+): (?=the id )"), "id"),
    (re.compile(r"body (?P<body>\S+): "), ""),
    (re.compile(r"dispenser (?P<dispenser>\S+): (?=the id )"), "id"),
    (re.compile(r"dispenser (?P<dispenser>\S+): (?=stock )"), "stock"),
    (re.compile(r"dispenser (?P<dispenser>\S+): "), ""),
    (re.compile(r"event (?P<event>\S+) at (?P<time>\S+) s: (?=no radio )"), "parameters/kind"),
    (re.compile(r"event (?P<event>\S+) at (?P<time>\S+) s: (?:(?P<parameter>\w+): )?"), "parameters"),
    (re.compile(r"scenario: (?=no world )"), "world"),
    (re.compile(r"scenario: (?=no radio )"), "radio/kind"),
    (re.compile(r"radio \S+: (?:(?P<parameter>\w+): )?"), "radio"),
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
            said = {name: text for name, text in match.groupdict().items() if text is not None}
            element = _element(said, key, lines)
            return Told("/".join([element, *([said["parameter"]] if "parameter" in said else [])]), line[match.end() :])
    return Told("", line)


def _element(said: Mapping[str, str], key: str, lines: YamlLines) -> str:
    if "obstacle" in said:
        return _entry("obstacles", lines, lambda entry: normalise_id(entry["id"]) == said["obstacle"])
    if "body" in said or "dispenser" in said:
        kind, holder = ("body", "bodies") if "body" in said else ("dispenser", "dispensers")
        loose = _entry(holder, lines, lambda entry: normalise_id(entry["id"]) == said[kind])
        return f"{loose}/{key}" if key else loose
    if "event" in said:
        event = _entry("events", lines, lambda entry: _is_event(entry, said))
        return f"{event}/{key}" if lines.has(f"{event}/{key}") else event
    if "robot" not in said and "topic" not in said:
        return key
    owner = "robots[0]"
    if "robot" in said:
        owner = _entry("robots", lines, lambda entry: normalise_id(entry["id"]) == said["robot"])
    # A key that a robot gives replaces the one in robot_defaults as a whole.
    if not lines.has(f"{owner}/{key}") and lines.has(f"robot_defaults/{key}"):
        owner = "robot_defaults"
    if "topic" in said:
        return _entry(f"{owner}/{key}", lines, lambda entry: entry["topic"] == said["topic"])
    return f"{owner}/{key}"


def _is_event(entry: Mapping[str, Any], said: Mapping[str, str]) -> bool:
    return entry["kind"] == said["event"] and f"{entry['time']:g}" == said["time"]


def _entry(holder: str, lines: YamlLines, fits: Callable[[Mapping[str, Any]], bool]) -> str:
    """Find an entry of a list; the list itself if none fits."""
    for index, entry in enumerate(lines.value(holder) or ()):
        if fits(entry):
            return f"{holder}[{index}]"
    return holder
