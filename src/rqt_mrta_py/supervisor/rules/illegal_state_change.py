"""Rule: a task changes its state in a way that there is none."""

from __future__ import annotations

from typing import Dict, Tuple, Union

from rqt_mrta_py.hooks import Fact, IncidentBoard, RuleSetup, TaskClaimed, TaskEndTold, TaskStateChanged
from rqt_mrta_py.model import Evidence, Severity, TaskState
from rqt_mrta_py.supervisor.rules.fact_rule import FactRule
from rqt_mrta_py.supervisor.tasks import FINAL

__all__ = ["IllegalStateChange"]

_Key = Tuple[str, str]


class IllegalStateChange(FactRule[_Key]):
    """Puts up an error when messages say of a task that is over what can no longer be.

    A task that is done, failed or withdrawn stays so until it appears anew.

    Fires: when more than ``pace.handover`` after a task's end a message says that a robot carries it out, or that it
    ended otherwise than it did (done after failed, withdrawn after done, ...). One incident for each task and robot; it
    lasts from the first such message to the last one, which is that after which there is none for twice
    ``pace.handover``, or until the task appears anew.

    Does not fire: for messages that were under way when the task ended; for a task that is told done once more
    (``task_completed_twice``); for a task that is done without anybody having been seen to hold it.

    Args:
        setup: ``pace.handover`` says for how long late words are none.
    """

    causes = (
        "A robot has not heard that the task is over, and goes on: its messages or those of others are lost, or it was "
        "away; or two nodes judge by themselves whether the task is done."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup)
        self._ended: Dict[str, float] = {}
        self._open: Dict[_Key, Tuple[float, Evidence]] = {}

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow when tasks end, and what is said of them after that."""
        if isinstance(fact, TaskStateChanged):
            if fact.after in FINAL:
                self._ended[fact.task] = fact.time
            elif self._ended.pop(fact.task, None) is not None:
                for key in [key for key in self._open if key[0] == fact.task]:
                    self._close(key, board)
        elif isinstance(fact, TaskClaimed):
            who = f"{fact.robot} held it" if fact.robot else "it was held"
            self._say(fact, fact.state, f"{who} still", board)
        elif isinstance(fact, TaskEndTold) and fact.before in FINAL and fact.told is not fact.before:
            who = f" by {fact.robot}" if fact.robot else ""
            said = f"it was said to be {fact.told.value}{who}"
            self._say(fact, fact.before, said, board)

    def fall_due(self, key: _Key, time: float, board: IncidentBoard) -> None:
        """Take in that nothing more was said."""
        self._close(key, board)

    def _say(self, fact: Union[TaskClaimed, TaskEndTold], state: TaskState, said: str, board: IncidentBoard) -> None:
        task, robot, time, message = fact.task, fact.robot, fact.time, fact.message
        ended = self._ended.get(task, self.start)
        key = (task, robot)
        if time - ended <= self.pace.handover and key not in self._open:
            return
        if key not in self._open:
            text = f"{task} was {state.value} at {self.since(ended)}, but at {self.since(time)} {said}"
            robots = [robot] if robot else []
            board.open(_name(key), Severity.ERROR, time, text, robots=robots, tasks=[task], evidence=[message])
        self._open[key] = (time, message)
        self.deadlines.put(key, time + 2.0 * self.pace.handover, board)

    def _close(self, key: _Key, board: IncidentBoard) -> None:
        self.deadlines.drop(key)
        time, message = self._open.pop(key)
        board.close(_name(key), time, evidence=[message])


def _name(key: _Key) -> str:
    # Ids of foreign bags may hold any character, so none of them can stand between the two.
    return f"{len(key[0])} {key[0]} {key[1]}"
