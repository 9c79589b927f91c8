"""Whether what plugins register and say fits: names usable where they will be, values that can do what is asked."""

from __future__ import annotations

import json
import re
from collections import abc
from typing import Iterator, Mapping, Optional, Pattern, Sequence, Tuple

from rqt_mrta_py.hooks.benchmark import Benchmark
from rqt_mrta_py.hooks.construction import AssemblyPlanner
from rqt_mrta_py.hooks.mission_maker import MissionMaker
from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.stream import Outgoing, OutgoingRows, TeamOutgoing
from rqt_mrta_py.hooks.verb import Verb
from rqt_mrta_py.wording import shown

__all__ = ["json_breach", "message_breach", "registration_breach", "rows_breach", "team_message_breach"]

_TYPES: Mapping[str, type] = {
    "mrta_register_assembly_planners": AssemblyPlanner,
    "mrta_register_benchmarks": Benchmark,
    "mrta_register_mission_makers": MissionMaker,
    "mrta_register_robot_models": RobotModel,
    "mrta_register_verbs": Verb,
}
"""Hooks that register values of a type; all others register something to be called."""

_STR = frozenset((str,))

_WORD = (re.compile(r"[a-z0-9]+([-_][a-z0-9]+)*"), "lower case letters and digits, joined by '-' or '_'")

_NAMES: Mapping[str, Tuple[Pattern[str], str]] = {
    "mrta_register_assembly_planners": _WORD,
    "mrta_register_benchmarks": _WORD,
    "mrta_register_exporters": _WORD,
    "mrta_register_figures": _WORD,
    "mrta_register_verbs": (re.compile(r"[a-z0-9]+(-[a-z0-9]+)*"), "lower case letters and digits, joined by '-'"),
}
"""Names that are typed on the command line, or become folders."""


def registration_breach(hook: str, name: object, value: object) -> Optional[str]:
    """Find what is wrong with one registration.

    Args:
        hook: ``mrta_register_*``.
        name: under which something is registered.
        value: what is registered.

    Returns:
        A phrase that goes on after the hook's name; None if all is well.
    """
    if not isinstance(name, str) or not name:
        return f"registers under {shown(name)}; a name is needed"
    if hook in _NAMES:
        form, accepted = _NAMES[hook]
        if not form.fullmatch(name):
            return f"registers under {shown(name)}; {accepted}, are accepted"
    wanted = _TYPES.get(hook)
    if wanted is None:
        return None if callable(value) else f"registers {name!r} as {shown(value)}; something callable is needed"
    if not isinstance(value, wanted):
        return f"registers {name!r} as {shown(value)}; a {wanted.__name__} is needed"
    return None


def message_breach(message: object) -> Optional[str]:
    """Find what is wrong with a message that a plugin's part wants to publish, before its type is looked at.

    Args:
        message: what the part answered.

    Returns:
        A phrase that goes on after the part's name; None if all is well.
    """
    if not isinstance(message, Outgoing):
        return f"answered {shown(message)}; accepted is Outgoing"
    topic, type_name, fields, _ = message
    # Every message is looked at, and most are made of just these.
    if topic.__class__ is str and type_name.__class__ is str and fields.__class__ is dict:
        return None
    if not (isinstance(topic, str) and isinstance(type_name, str)):
        return f"answered an Outgoing on {shown(topic)} of type {shown(type_name)}; accepted are two texts"
    if not isinstance(fields, abc.Mapping):
        return f"answered an Outgoing on {topic!r} with fields {shown(fields)}; accepted is a mapping"
    return None


def rows_breach(messages: OutgoingRows) -> Optional[str]:
    """Find what is wrong with messages that an agent wants to publish together, before their type is looked at.

    Args:
        messages: what the agent answered.

    Returns:
        A phrase that goes on after the agent's name; None if all is well.
    """
    topics, type_name, columns = messages
    # Many agents say many rows many times a second, and most are made of just these.
    if not (isinstance(topics, tuple) and (_STR.issuperset(map(type, topics)) or _are_texts(topics))):
        return f"answered an OutgoingRows on {shown(topics)}; accepted is a tuple of texts"
    if not isinstance(type_name, str):
        return f"answered an OutgoingRows of type {shown(type_name)}; accepted is a text"
    if not isinstance(columns, abc.Mapping):
        return f"answered an OutgoingRows of {shown(type_name)} with columns {shown(columns)}; accepted is a mapping"
    for path, column in columns.items():
        rows = _rows_of(column)
        if rows is not None and rows != len(topics):
            return (
                f"answered an OutgoingRows of {shown(type_name)} with {rows} rows of {shown(path)} for {len(topics)} "
                "topics; accepted are one row a topic, or one value for all"
            )
    return None


def json_breach(value: object) -> Optional[str]:
    """Find what is wrong with a value that sums a mission up.

    Args:
        value: what a statistic or measure gave.

    Returns:
        A phrase that goes on after its name and a colon; None if all is well.
    """
    try:
        json.dumps(value, allow_nan=False)
    except (TypeError, ValueError, RecursionError) as error:
        return (
            f"its value is no plain JSON ({error}); accepted: finite numbers, texts, truth values, None, and lists and "
            "dicts of them"
        )
    return None


def team_message_breach(messages: object, robots: Sequence[str]) -> Optional[str]:
    """Find what is wrong with messages that a plugin's part wants robots to publish, before their type is looked at.

    Args:
        messages: what the part answered.
        robots: who may publish, in order.

    Returns:
        A phrase that goes on after the part's name; None if all is well.
    """
    if not isinstance(messages, TeamOutgoing):
        return f"answered {shown(messages)}; accepted is TeamOutgoing"
    topic, type_name, speakers, columns = messages
    if not (isinstance(topic, str) and isinstance(type_name, str)):
        return f"answered a TeamOutgoing on {shown(topic)} of type {shown(type_name)}; accepted are two texts"
    if not isinstance(columns, abc.Mapping):
        return f"answered a TeamOutgoing on {topic!r} with columns {shown(columns)}; accepted is a mapping"
    if speakers is not robots and not (isinstance(speakers, tuple) and _are_some_of(speakers, robots)):
        return (
            f"answered a TeamOutgoing on {topic!r} of robots {shown(speakers)}; accepted is a tuple of those that "
            f"measured, in order, each once: {shown(tuple(robots))}"
        )
    for path, column in columns.items():
        rows = _rows_of(column)
        if rows is not None and rows != len(speakers):
            return (
                f"answered a TeamOutgoing on {topic!r} with {rows} rows of {shown(path)} for {len(speakers)} robots; "
                "accepted are one row a robot, or one value for all"
            )
    return None


def _are_some_of(speakers: Tuple[object, ...], robots: Sequence[str]) -> bool:
    """Tell whether all speakers are among the robots, in the same order."""
    rest: Iterator[object] = iter(robots)
    return speakers == robots or all(speaker in rest for speaker in speakers)


def _are_texts(topics: Tuple[object, ...]) -> bool:
    return all(isinstance(topic, str) for topic in topics)


def _rows_of(column: object) -> Optional[int]:
    """Give how many rows a column has; None for one value that all share."""
    if isinstance(column, (tuple, list)):
        return len(column)
    shape = getattr(column, "shape", ())
    return int(shape[0]) if shape else None
