"""Values made without their constructors are those that the constructors make."""

from __future__ import annotations

import pickle
from dataclasses import FrozenInstanceError
from typing import Any

import pytest

from rqt_mrta_py.model import (
    Allocation,
    Outcome,
    RobotInterval,
    RobotRecord,
    RobotState,
    TaskInterval,
    TaskRecord,
    TaskState,
)
from rqt_mrta_py.supervisor.making import allocation, interval, robot_record, task_record

_BUSY = RobotInterval(RobotState.BUSY, 1.0, 2.5)
_DONE = TaskInterval(TaskState.DONE, 1.5, 2.5)


@pytest.mark.parametrize(
    ("made", "built"),
    [
        (interval(RobotInterval, RobotState.BUSY, 1.0, 2.5), _BUSY),
        (interval(TaskInterval, TaskState.DONE, 1.5, 2.5), _DONE),
        (robot_record("robot1", (_BUSY,), 2.25), RobotRecord("robot1", (_BUSY,), 2.25)),
        (robot_record("robot1", (), None), RobotRecord("robot1", ())),
        (task_record("patrol", (_DONE,)), TaskRecord("patrol", (_DONE,))),
        (
            allocation("patrol", "robot1", 1.0, 2.5, Outcome.OPEN),
            Allocation(task="patrol", robot="robot1", start=1.0, end=2.5, outcome=Outcome.OPEN),
        ),
    ],
    ids=lambda value: type(value).__name__,
)
def test_made_values_are_those_of_the_constructors(made: Any, built: Any) -> None:
    assert made == built
    assert hash(made) == hash(built)
    assert repr(made) == repr(built)
    assert vars(made) == vars(built)
    assert pickle.loads(pickle.dumps(made)) == built
    with pytest.raises(FrozenInstanceError):
        made.end = 3.0
