"""Explanations in words, for the terminal and for the page alike."""

from __future__ import annotations

from typing import Dict, Iterable, List, NamedTuple, Optional, Sequence, Tuple, TypeVar

from rqt_mrta_py.model import Candidate, Explanation, RobotState, Spell, Whereabouts
from rqt_mrta_py.render.text import printable
from rqt_mrta_py.render.times import seconds

__all__ = [
    "CandidateGroup",
    "candidate_groups",
    "ends_of",
    "named",
    "others_in_lines",
    "spell_in_words",
    "task_in_words",
]

_LONGEST_ID = 60
_MOST_ROBOTS = 20
_MOST_STRETCHES = 9
_ANSWERS = {True: "yes", False: "no", None: "unknown"}

_Item = TypeVar("_Item")


class CandidateGroup(NamedTuple):
    """Robots of which the same is to be said.

    Attributes:
        answer: ``yes``, ``no`` or ``unknown``: whether they could have had the task.
        robots: who, as a list in words.
        why: the reason.
    """

    answer: str
    robots: str
    why: str


def named(ids: Sequence[str]) -> str:
    """List ids in words, of very many the first."""
    more = f" and {len(ids) - _MOST_ROBOTS} more" if len(ids) > _MOST_ROBOTS else ""
    return ", ".join(printable(each, _LONGEST_ID) for each in ids[:_MOST_ROBOTS]) + more


def task_in_words(explanation: Explanation) -> str:
    """Say what a task is, what it needs, and what it was in the end."""
    told = explanation.definition
    parts = ["nothing is known of what it is"]
    if told is not None:
        parts = [told.kind, f"needs {named(told.capabilities) if told.capabilities else 'nothing in particular'}"]
        parts += [f"{told.robots} robots"] if told.robots > 1 else []
        parts += [f"after {named(told.predecessors)}"] if told.predecessors else []
    return f"{', '.join(parts)}; {explanation.state.value} at the end"


def candidate_groups(candidates: Iterable[Candidate]) -> List[CandidateGroup]:
    """Put robots together of which the same is to be said: those first that could have had the task."""
    found: Dict[Tuple[Optional[bool], str], List[str]] = {}
    for each in candidates:
        found.setdefault((each.able, each.why), []).append(each.robot)
    order = (True, None, False)
    keys = sorted(found, key=lambda key: order.index(key[0]))
    return [CandidateGroup(_ANSWERS[able], named(found[able, why]), why) for able, why in keys]


def spell_in_words(spell: Spell) -> str:
    """Say how a hold ended, or what the task was while nobody held it."""
    if spell.outcome is None:
        return ", then ".join(state.value for state in spell.states) or "not known"
    ended = spell.outcome.value.replace("_", " ")
    return f"{ended}: {spell.text}" if spell.text else ended


def others_in_lines(spell: Spell, start: float) -> List[str]:
    """Say what the robots were doing that could have had the task: when it was taken, or all the while.

    Args:
        spell: a hold or a time between holds.
        start: of the mission [s].

    Returns:
        A line for all, or one for those of which the same is to be said; none if there is nothing to say.
    """
    if not spell.others:
        return []
    more = [f"{spell.more} more in summary.json"] if spell.more else []
    if spell.outcome is not None:
        told = [f"{named([each.robot])} {_doing(each)}" for each in spell.others]
        return [f"when it was taken: {', '.join([*told, *more])}"]
    by_robot: Dict[str, List[Whereabouts]] = {}
    for each in spell.others:
        by_robot.setdefault(each.robot, []).append(each)
    alike: Dict[str, List[str]] = {}
    for robot, course in by_robot.items():
        alike.setdefault(_course(course, start), []).append(robot)
    return [*(f"{named(robots)}: {course}" for course, robots in alike.items()), *more]


def ends_of(items: Sequence[_Item], most: int) -> Tuple[Sequence[_Item], int, Sequence[_Item]]:
    """Give the first and the last of many, and how many are left out between them.

    Args:
        items: any number.
        most: that are given, at least 2.
    """
    if len(items) <= most:
        return items, 0, ()
    last = most // 3
    return items[: most - last], len(items) - most, items[len(items) - last :]


def _course(course: Sequence[Whereabouts], start: float) -> str:
    first, left_out, last = ends_of(course, _MOST_STRETCHES)
    told = [f"{_doing(each)} until {seconds(each.end - start)}" for each in first]
    told += [f"{left_out} other things"] if left_out else []
    told += [f"{_doing(each)} until {seconds(each.end - start)}" for each in last]
    # What it did at last it did until the end, which the spell tells.
    return ", then ".join([*told[:-1], _doing(course[-1])])


def _doing(each: Whereabouts) -> str:
    if each.state is None:
        return "not known of yet"
    if each.tasks:
        return f"{each.state.value} with {named(each.tasks)}"
    return "busy without a known task" if each.state is RobotState.BUSY else each.state.value
