"""Training: missions one after the other, each going on with what was learned in those before."""

from __future__ import annotations

from dataclasses import replace
from typing import List, Sequence, Tuple

from mrta_l_alliance.memory import Memory, written
from mrta_l_alliance.monitor import learn_failure, learn_success
from mrta_l_alliance.parameters import Phase
from rqt_mrta_py.hooks import Experiment, Laboratory
from rqt_mrta_py.model import MissionRecord, Outcome

__all__ = ["learn", "settings", "train"]

_FAILURES = (Outcome.FAILED, Outcome.YIELDED, Outcome.GAVE_UP, Outcome.LOST, Outcome.PREEMPTED)


def learn(memory: Memory, record: MissionRecord, window: int = 5, timeout: float = 3.0) -> Memory:
    """Learn from a finished mission what a robot would have learned that heard everything.

    Args:
        memory: what was known before.
        record: of the mission.
        window: mu, the number of trials kept.
        timeout: the shortest attempt that counts as failure while no trial is known [s].
    """
    for each in sorted(record.allocations, key=lambda each: (each.end, each.robot, each.task)):
        time = each.end - each.start
        if each.outcome is Outcome.DONE:
            memory = learn_success(memory, each.robot, each.task, time, window)
        elif each.outcome in _FAILURES:
            certain = each.outcome is Outcome.FAILED
            memory = learn_failure(
                memory, each.robot, each.task, time, window=window, shortest=timeout, certain=certain
            )
    return memory


def settings(memory: Memory, team: Sequence[str], phase: Phase = Phase.ADAPTIVE) -> Tuple[str, ...]:
    """Give what a mission must be told to go on with a memory, as ``--set`` and ``Experiment.settings`` take it.

    Args:
        memory: what is known.
        team: ids of the robots that shall know it.
        phase: of control.
    """
    text = written(memory)
    return tuple(
        f"{robot}/learning/{name}={value}"
        for robot in team
        for name, value in (("phase", phase.value), ("memory", text))
    )


def train(
    laboratory: Laboratory, courses: Sequence[Experiment], team: Sequence[str], missions: int = 10
) -> List[Memory]:
    """Train teams, each on missions of its own.

    Args:
        laboratory: carries the missions out.
        courses: one experiment for each memory to be made; mission n of a course has its seed plus n.
        team: ids of the robots.
        missions: how many to train on.

    Returns:
        What each course taught, in their order.
    """
    memories = [Memory() for _ in courses]
    for number in range(missions):
        lessons = [
            replace(
                course,
                architecture="mrta_l_alliance",
                seed=course.seed + number,
                settings=(*course.settings, *settings(memory, team, Phase.ACTIVE)),
            )
            for course, memory in zip(courses, memories)
        ]
        trials = laboratory.trials(lessons)
        memories = [learn(memory, trial.record) for memory, trial in zip(memories, trials)]
    return memories
