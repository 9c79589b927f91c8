"""Which of a robot's tasks could be carried out now, as their behaviours say."""

from __future__ import annotations

from itertools import groupby
from types import MappingProxyType
from typing import Any, Callable, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.hooks import Perception
from rqt_mrta_py.model import Task
from rqt_mrta_py.robot.asking import Asking
from rqt_mrta_py.robot.charges import Charge, Charges, yes_or_no

__all__ = ["Applicability"]

_BOOL = frozenset((bool,))

_Run = Tuple[Callable[[Task, Perception], Any], Perception, Sequence[Task]]
"""Neighbouring tasks of which one behaviour is asked: its answer, what it perceives, and the tasks."""


class Applicability:
    """Asks about all tasks of one robot, each in turn.

    Args:
        charges: the tasks.
        asking: on behalf of whom.
        who: names a task's behaviour.
    """

    def __init__(self, charges: Charges, asking: Asking, who: Callable[[Charge], str]) -> None:
        self._charges = charges
        self._asking = asking
        self._who = who
        self._asked: Sequence[Tuple[Charge, str]] = ()
        self._runs: List[_Run] = []
        self._answers: Optional[List[bool]] = None
        self._told: Mapping[str, bool] = {}

    def ask(self) -> Mapping[str, bool]:
        """Ask now; give the answers by task id, in the order of tasks, the same object again while they stay.

        Raises:
            RobotError: a behaviour raised, or answered neither True nor False. Errors that already speak to the user
                pass as they are.
        """
        asked = self._charges.with_hindrances()
        if asked is not self._asked:
            self._line_up(asked)
        answers: List[bool] = []
        answer = answers.append
        try:
            for applicable, perception, tasks in self._runs:
                for task in tasks:
                    answer(applicable(task, perception))
            if not _BOOL.issuperset(map(type, answers)):
                self._refuse(answers)
        except MrtaError:
            raise
        except Exception as error:
            raise self._asking.failure(self._who(asked[len(answers)][0]), error) from error
        if answers != self._answers:
            self._answers = answers
            self._told = MappingProxyType({charge.task.id: each for (charge, _), each in zip(asked, answers)})
        return self._told

    def _line_up(self, asked: Sequence[Tuple[Charge, str]]) -> None:
        self._asked, self._answers = asked, None
        self._runs = []
        for _, run in groupby(asked, lambda each: (id(each[0].behaviour), id(each[0].perception), bool(each[1]))):
            charges, hindrances = zip(*run)
            applicable = _never if hindrances[0] else charges[0].behaviour.applicable
            self._runs.append((applicable, charges[0].perception, tuple(charge.task for charge in charges)))

    @staticmethod
    def _refuse(answers: List[Any]) -> None:
        """Find the first answer that is none, and leave those before it."""
        place = next(place for place, answer in enumerate(answers) if answer.__class__ is not bool)
        refused = answers[place]
        del answers[place:]
        yes_or_no(refused)


def _never(task: Task, perception: Perception) -> bool:
    return False
