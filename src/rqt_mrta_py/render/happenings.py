"""What scenarios made happen: heard from the stream, and told in a word or by a sign."""

from __future__ import annotations

import math
from collections import deque
from enum import Enum
from typing import Any, Deque, Dict, Iterable, Mapping, Tuple

import yaml

from rqt_mrta_py.hooks import Heard, ScenarioLabel, Subscription
from rqt_mrta_py.model import ScenarioEventKind, normalise_id
from rqt_mrta_py.render.text import printable

__all__ = ["Condition", "LabelKeeper", "conditions", "happening_word", "radio_is_split"]

_MOST = 2000
_LONGEST_KIND = 40
_LONGEST_YAML = 2000

_WORDS: Mapping[str, str] = {
    "robot_stops": "stops",
    "robot_returns": "returns",
    "robot_removed": "removed",
    "robot_sticks": "sticks",
    "robot_comes_free": "comes free",
    "robot_slows": "slows",
    "robot_clock_shifts": "clock shifts",
    "radio_fails": "radio fails",
    "radio_returns": "radio returns",
    "radio_partitions": "radio splits",
    "radio_heals": "radio heals",
    "radio_changes": "radio changes",
    "task_appears": "appears",
    "task_withdrawn": "withdrawn",
    "task_reassigned": "reassigned",
}
_WORDS_WHEN_OVER: Mapping[str, str] = {"robot_slows": "full speed", "robot_clock_shifts": "clock right"}

# Kinds that say no more than that something is over, and what that was.
_ENDS: Mapping[str, str] = {kind.value: kind.undoes.value for kind in ScenarioEventKind if kind.undoes is not None}
# Kinds that set a value, and the one that sets things right.
_RIGHT: Mapping[str, Tuple[str, float]] = {"robot_slows": ("factor", 1.0), "robot_clock_shifts": ("offset", 0.0)}


class Condition(Enum):
    """What is the matter with a robot because a scenario wants it so; the gravest first."""

    STOPPED = "stopped"
    OFF_THE_AIR = "off the air"
    STUCK = "stuck"
    SLOW = "slow"
    CLOCK_OFF = "clock off"


_CONDITIONS: Mapping[str, Condition] = {
    "robot_stops": Condition.STOPPED,
    "robot_removed": Condition.STOPPED,
    "radio_fails": Condition.OFF_THE_AIR,
    "robot_sticks": Condition.STUCK,
    "robot_slows": Condition.SLOW,
    "robot_clock_shifts": Condition.CLOCK_OFF,
}


class LabelKeeper:
    """Hears what scenarios made happen, and keeps the newest of it.

    Attributes:
        removed: when robots were taken off the floor, on the stream's clock [s].
    """

    SUBSCRIPTION = Subscription(
        "/mrta/scenario_event",
        "rqt_mrta_py/ScenarioEvent",
        ("kind", "robot_id", "task_id", "parameters_yaml", "text"),
    )

    def __init__(self) -> None:
        self._labels: Deque[ScenarioLabel] = deque(maxlen=_MOST)
        self.removed: Dict[str, float] = {}

    def hear(self, heard: Heard) -> None:
        """Take in one ScenarioEvent."""
        fields = heard.fields
        kind = printable(fields["kind"], _LONGEST_KIND)
        self._labels.append(
            ScenarioLabel(
                heard.receipt,
                kind,
                printable(fields["text"]),
                normalise_id(fields["robot_id"]),
                normalise_id(fields["task_id"]),
                _is_over(kind, fields["parameters_yaml"]),
            )
        )
        if kind == "robot_removed" and len(self.removed) < _MOST:
            self.removed.setdefault(self._labels[-1].robot, heard.receipt)

    def labels(self) -> Tuple[ScenarioLabel, ...]:
        """Give what happened so far, oldest first."""
        return tuple(self._labels)


def happening_word(label: ScenarioLabel) -> str:
    """Tell in a word or two what happened."""
    if label.over and label.kind in _WORDS_WHEN_OVER:
        return _WORDS_WHEN_OVER[label.kind]
    return _WORDS.get(label.kind) or printable(label.kind, _LONGEST_KIND).replace("_", " ")


def conditions(labels: Iterable[ScenarioLabel]) -> Dict[str, Condition]:
    """Say what is the matter with which robot after all this happened.

    Args:
        labels: oldest first. A robot that stopped twice returns twice.

    Returns:
        The gravest condition of each robot that has one, in the order of the first label that speaks of it.
    """
    depths: Dict[str, Dict[Condition, int]] = {}
    for label in labels:
        condition = _CONDITIONS.get(_ENDS.get(label.kind, label.kind))
        if not label.robot or condition is None:
            continue
        of_robot = depths.setdefault(label.robot, {})
        if label.over:
            of_robot[condition] = max(of_robot.get(condition, 0) - 1, 0)
        elif condition is Condition.STOPPED:
            of_robot[condition] = of_robot.get(condition, 0) + 1
        else:
            of_robot[condition] = 1
    gravest = ((robot, next((c for c in Condition if of_robot.get(c)), None)) for robot, of_robot in depths.items())
    return {robot: condition for robot, condition in gravest if condition is not None}


def radio_is_split(labels: Iterable[ScenarioLabel]) -> bool:
    """Tell whether groups of robots are cut off from one another after all this happened.

    Args:
        labels: oldest first.
    """
    newest = [label for label in labels if label.kind in ("radio_partitions", "radio_heals")]
    return bool(newest) and newest[-1].kind == "radio_partitions"


def _is_over(kind: str, parameters: str) -> bool:
    if kind in _ENDS:
        return True
    if kind not in _RIGHT or len(parameters) > _LONGEST_YAML:
        return False
    name, right = _RIGHT[kind]
    value = _value(parameters, name)
    return isinstance(value, (int, float)) and math.isclose(value, right, abs_tol=1e-9)


def _value(text: str, name: str) -> Any:
    """Look up one parameter in untrusted YAML; None for whatever is no mapping that has it."""
    try:
        parameters = yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError):
        return None
    return parameters.get(name) if isinstance(parameters, dict) else None
