"""Whether what plugins register and say fits: names usable where they will be, values that can do what is asked."""

from __future__ import annotations

import re
from collections import abc
from typing import Mapping, Optional, Pattern, Tuple

from rqt_mrta_py.hooks.benchmark import Benchmark
from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.stream import Outgoing
from rqt_mrta_py.hooks.verb import Verb
from rqt_mrta_py.wording import shown

__all__ = ["message_breach", "registration_breach"]

_TYPES: Mapping[str, type] = {
    "mrta_register_benchmarks": Benchmark,
    "mrta_register_robot_models": RobotModel,
    "mrta_register_verbs": Verb,
}
"""Hooks that register values of a type; all others register something to be called."""

_WORD = (re.compile(r"[a-z0-9]+([-_][a-z0-9]+)*"), "lower case letters and digits, joined by '-' or '_'")

_NAMES: Mapping[str, Tuple[Pattern[str], str]] = {
    "mrta_register_benchmarks": _WORD,
    "mrta_register_exporters": _WORD,
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
