"""Every task is asked about once a cycle, and what stays is told as the same object."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import pytest

from rqt_mrta_py.errors import RobotError
from rqt_mrta_py.hooks import Perception
from rqt_mrta_py.model import Progress, Task
from rqt_mrta_py.robot.applicability import Applicability
from rqt_mrta_py.robot.asking import Asking
from rqt_mrta_py.robot.charges import Charges
from rqt_mrta_py.robot.perception import BehaviourPerception, Senses


class Scripted:
    """A behaviour that answers by task id, and counts what it is asked."""

    def __init__(self, answers: Dict[str, Any]) -> None:
        self.answers = answers
        self.asked: List[str] = []

    def applicable(self, task: Task, perception: Perception) -> Any:
        self.asked.append(task.id)
        answer = self.answers[task.id]
        if isinstance(answer, Exception):
            raise answer
        return answer


def robot(**answers: Any) -> Tuple[Applicability, Charges, Scripted]:
    """Make a robot whose tasks' kinds are their first letters."""
    behaviour, senses = Scripted(answers), Senses()
    kinds = sorted({task[0] for task in answers})
    views = {kind: BehaviourPerception(senses) for kind in kinds}
    charges = Charges(dict.fromkeys(kinds, behaviour), views, None)  # type: ignore[arg-type]
    for task in answers:
        charges.take_on(charges.charge(Task(task, task[0])))
    return Applicability(charges, Asking("robot1", senses), lambda charge: charge.task.id), charges, behaviour


def test_answers_stand_in_the_order_of_tasks_and_are_the_same_object_until_one_changes() -> None:
    tasks, _, behaviour = robot(a1=True, a2=False, b1=True, a3=True)
    first, second = tasks.ask(), tasks.ask()
    assert list(first.items()) == [("a1", True), ("a2", False), ("b1", True), ("a3", True)]
    assert second is first
    behaviour.answers["a2"] = True
    assert dict(tasks.ask()) == dict.fromkeys(("a1", "a2", "b1", "a3"), True)
    assert not first["a2"]


def test_a_task_that_something_stands_in_the_way_of_is_not_asked_about() -> None:
    tasks, charges, behaviour = robot(a1=True, a2=True, a3=True)
    before = tasks.ask()
    charges.end("a2", Progress.DONE)
    behaviour.asked.clear()
    assert dict(tasks.ask()) == {"a1": True, "a2": False, "a3": True}
    assert behaviour.asked == ["a1", "a3"]
    assert before["a2"]


@pytest.mark.parametrize(
    ("answer", "problem"),
    [
        (ValueError("no map"), "ValueError: no map"),
        (1, "TypeError: applicable answered 1; accepted is bool"),
        (None, "TypeError: applicable answered None; accepted is bool"),
    ],
)
def test_who_fails_is_named(answer: Any, problem: str) -> None:
    tasks, _, _ = robot(a1=True, b1=answer, b2=True)
    with pytest.raises(RobotError) as caught:
        tasks.ask()
    assert str(caught.value) == f"robot1: b1 failed at 0.000 s: {problem}"


@pytest.mark.parametrize("number", [10, 40])
def test_work_is_linear_in_tasks(number: int) -> None:
    tasks, _, behaviour = robot(**{f"a{place}": True for place in range(number)})
    for _ in range(5):
        tasks.ask()
    assert len(behaviour.asked) == 5 * number
