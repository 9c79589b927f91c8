"""What is known of how long robots take for tasks, and its text form, which is YAML."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Dict, Iterable, Iterator, Mapping, Tuple

import yaml

__all__ = ["NOTHING", "Memory", "Performance", "read_memory", "written"]

_DECIMALS = 3  # of a second, in the text form

# Far above what any team needs; a longer text is a mistake.
_LONGEST = 1_000_000
_DEEPEST = 4


@dataclass(frozen=True)
class Performance:
    """What is known of one robot on one task.

    Attributes:
        times: of the trials kept, the oldest first [s].
        failures: how often it was begun and not completed.
    """

    times: Tuple[float, ...] = ()
    failures: int = 0

    @property
    def attempts(self) -> int:
        """Give how often the robot is known to have tried."""
        return len(self.times) + self.failures

    def with_time(self, time: float, window: int) -> Performance:
        """Add a trial's time [s]; only so many as ``window`` are kept."""
        return Performance((*self.times, time)[-window:], self.failures)

    def with_failure(self) -> Performance:
        """Count one more failure."""
        return Performance(self.times, self.failures + 1)


NOTHING = Performance()
"""What is known at first."""


@dataclass(frozen=True)
class Memory:
    """What one robot knows of all robots and tasks; changing it makes another.

    Attributes:
        known: by robot and task.
    """

    known: Mapping[Tuple[str, str], Performance] = field(default_factory=dict)

    def of(self, robot: str, task: str) -> Performance:
        """Give what is known of a robot on a task."""
        return self.known.get((robot, task), NOTHING)

    def including(self, robot: str, task: str, performance: Performance) -> Memory:
        """Give this memory with something else known of one robot on one task."""
        return Memory({**self.known, (robot, task): performance})

    def __iter__(self) -> Iterator[Tuple[str, str, Performance]]:
        """Go through all that is known, by robot and task."""
        return ((robot, task, self.known[robot, task]) for robot, task in sorted(self.known))

    @property
    def most_attempts(self) -> int:
        """Give the most attempts of any robot at any task; 0 if nothing is known."""
        return max((each.attempts for each in self.known.values()), default=0)


def written(memory: Memory) -> str:
    """Write a memory down as one line of YAML, which the parameter ``learning/memory`` takes."""
    robots: Dict[str, Dict[str, Any]] = {}
    for robot, task, each in memory:
        entry = {"times": [round(time, _DECIMALS) for time in each.times], "failures": each.failures}
        robots.setdefault(robot, {})[task] = entry
    return yaml.safe_dump(robots, default_flow_style=True, width=math.inf).strip()


# A whole team is told the same text.
@lru_cache(maxsize=16)
def read_memory(text: str) -> Memory:
    """Read a memory.

    Args:
        text: from anybody: YAML, ``{robot: {task: {times: [...], failures: ...}}}``; empty: nothing is known.

    Raises:
        ValueError: it is something else; says where in it, in one line.
    """
    known: Dict[Tuple[str, str], Performance] = {}
    for robot, tasks in _mapping(_loaded(text), "it").items():
        _check_name(robot, "it")
        for task, entry in _mapping(tasks, robot).items():
            _check_name(task, robot)
            known[robot, task] = _performance(entry, f"{robot}/{task}")
    return Memory(known)


def _loaded(text: str) -> Any:
    if len(text) > _LONGEST:
        raise ValueError(f"must be no longer than {_LONGEST} letters (got {len(text)})")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        _check_shape(yaml.parse(text, Loader=loader))
        return yaml.load(text, Loader=loader)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f" (line {mark.line + 1}, column {mark.column + 1})" if mark else ""
        raise ValueError(f"must be YAML without tags{where}") from error


def _check_shape(events: Iterable[yaml.Event]) -> None:
    """Refuse what costs more to read than its length says, at the first sign of it."""
    depth = 0
    for event in events:
        if isinstance(event, yaml.AliasEvent):
            raise ValueError("must be YAML without aliases")
        depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
        if depth > _DEEPEST:
            raise ValueError(f"must be YAML that is nested no deeper than {_DEEPEST} levels")


def _mapping(value: Any, where: str) -> Mapping[Any, Any]:
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        raise ValueError(f"{where}: must be a mapping (got {_shown(value)})")
    return value


def _check_name(name: Any, where: str) -> None:
    if not isinstance(name, str) or not name:
        raise ValueError(f"{where}: every key must be the id of a robot or task (got {_shown(name)})")


def _performance(entry: Any, where: str) -> Performance:
    told = _mapping(entry, where)
    unknown = [key for key in told if key not in ("times", "failures")]
    if unknown:
        raise ValueError(f"{where}: {_shown(unknown[0])} is unknown; there are times and failures")
    times = told.get("times", [])
    failures = told.get("failures", 0)
    if not isinstance(times, list) or not all(map(_is_time, times)):
        raise ValueError(f"{where}/times: must be a list of seconds above 0 (got {_shown(times)})")
    if isinstance(failures, bool) or not isinstance(failures, int) or failures < 0:
        raise ValueError(f"{where}/failures: must be a whole number, at least 0 (got {_shown(failures)})")
    return Performance(tuple(float(time) for time in times), failures)


def _is_time(value: Any) -> bool:
    # A greater number would be inf as a float.
    return isinstance(value, (int, float)) and not isinstance(value, bool) and 0.0 < value < 1e12


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
