"""Parameters for tasks that appear and that no parameters speak of."""

from __future__ import annotations

import dataclasses
from typing import Mapping, Sequence

from mrta_alliance.messages import motivation_topic
from mrta_alliance.parameters import BehaviourSetParameters
from rqt_mrta_py.model import Task, is_legal_name

__all__ = ["parameters_for"]


def parameters_for(
    task: Task, known: Sequence[BehaviourSetParameters], kinds: Mapping[str, str]
) -> BehaviourSetParameters:
    """Choose the parameters of a new behaviour set.

    They are those of the robot's first behaviour set for a task of the same kind, else of its first one, else the
    defaults; without sensors, for those were chosen for another task. The task's own expected duration counts where
    announcing it would slow others down.

    Args:
        task: what appeared.
        known: of the behaviour sets that there are, in file order.
        kinds: by task, its kind.

    Raises:
        ValueError: the task's id is not fit for the topic of a Motivation.
    """
    if not is_legal_name(motivation_topic(task.id)):
        raise ValueError(f"{task.id!r} is not fit for a topic; letters, digits and _ are")
    alike = [each for each in known if kinds.get(each.task_id) == task.kind]
    pattern = next(iter([*alike, *known]), BehaviourSetParameters(task.id))
    duration = task.expected_duration
    if duration is None or duration <= pattern.threshold / pattern.fast_rate:
        duration = pattern.task_expected_duration
    return dataclasses.replace(pattern, task_id=task.id, task_expected_duration=duration, sensors=())
