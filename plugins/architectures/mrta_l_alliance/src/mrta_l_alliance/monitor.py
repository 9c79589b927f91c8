"""The performance monitor: who has been on which task since when, and how it ended (TM-13000, 6.2).

A robot cannot look into another: what it hears is that the other announces a task, and that the task is done. A trial
lasts from the first announcement to the report that the same robot has done the task.

Reconstructed: an attempt that ends otherwise counts as failure if the robot says so, if it lasted longer than the
robot's trials did on average, or, while there are none, longer than the silence after which a robot counts as stopped;
what is let go earlier was taken from it by a reset, an operator or chance. The time of one that outlasts the average
enters among the trials, for the robot would have needed at least that long.
"""

from __future__ import annotations

from typing import AbstractSet, Dict, List, NamedTuple, Optional, Set

from mrta_l_alliance.memory import Memory
from rqt_mrta_py.model import Progress

__all__ = ["Monitor", "learn_failure", "learn_success"]

_DROPS = (Progress.WITHDRAWN, Progress.APPEARED, Progress.REASSIGNED)


class _Attempt(NamedTuple):
    task: str
    start: float
    newest: float


def learn_success(memory: Memory, robot: str, task: str, time: float, window: int) -> Memory:
    """Take in that a robot has done a task.

    Args:
        memory: what was known before.
        robot: its id.
        task: its id.
        time: that it took; none at all teaches nothing [s].
        window: mu, the number of trials kept.
    """
    return memory.including(robot, task, memory.of(robot, task).with_time(time, window)) if time > 0.0 else memory


def learn_failure(
    memory: Memory, robot: str, task: str, time: float, *, window: int, shortest: float, certain: bool = False
) -> Memory:
    """Take in that a robot let a task go.

    Args:
        memory: what was known before.
        robot: its id.
        task: its id.
        time: that it was on it [s].
        window: mu, the number of trials kept.
        shortest: the time that an attempt must last to count, while no trial is known [s].
        certain: the robot itself says that it failed.
    """
    before = memory.of(robot, task)
    is_long = time > (sum(before.times) / len(before.times) if before.times else shortest)
    if not is_long and not certain:
        return memory
    after = before.with_time(time, window) if is_long and before.times else before
    return memory.including(robot, task, after.with_failure())


class Monitor:
    """Watches a team, the own robot included.

    Args:
        memory: what is known before.
        tasks: ids of those that can end; others are not watched.
        window: mu, the number of trials kept.
        timeout: tau, after what silence a robot counts as stopped [s].
    """

    def __init__(self, memory: Memory, tasks: AbstractSet[str], window: int, timeout: float) -> None:
        self.memory = memory
        self._tasks: Set[str] = set(tasks)
        self._window = window
        self._timeout = timeout
        self._attempts: Dict[str, _Attempt] = {}
        self._silent: Set[str] = set()

    @property
    def silent(self) -> AbstractSet[str]:
        """Give the robots that fell silent on a task and have not been heard since."""
        return self._silent

    def follow(self, task: str) -> None:
        """Watch one more task."""
        self._tasks.add(task)

    def follows(self, task: str) -> bool:
        """Tell whether a task is watched."""
        return task in self._tasks

    def see(self, robot: str, task: Optional[str], time: float) -> None:
        """Take in that a robot is on a task at a time [s]; None: on nothing any more."""
        attempt = self._attempts.get(robot)
        if task is not None:
            self._silent.discard(robot)
            if attempt is not None and attempt.task == task and time - attempt.newest <= self._timeout:
                self._attempts[robot] = attempt._replace(newest=max(time, attempt.newest))
                return
        self._close(robot, time if task is None else None)
        if task in self._tasks and task is not None:
            self._attempts[robot] = _Attempt(task, time, time)

    def report(self, task: str, progress: Progress, robot: Optional[str], time: float) -> None:
        """Take in what became of a task at a time [s], and who says so.

        Args:
            task: its id.
            progress: what is reported.
            robot: the reporter; None for an operator.
            time: now [s].
        """
        if progress is Progress.DONE:
            for each in self._on(task):
                attempt = self._attempts.pop(each)
                if each == robot:
                    self.memory = learn_success(self.memory, each, task, time - attempt.start, self._window)
        elif progress in (Progress.FAILED, Progress.UNREACHABLE):
            attempt_of = None if robot is None else self._attempts.get(robot)
            if robot is not None and attempt_of is not None and attempt_of.task == task:
                self._close(robot, time, certain=True)
        elif progress in _DROPS:
            for each in self._on(task):
                del self._attempts[each]

    def listen(self, now: float) -> None:
        """Notice who has fallen silent by now [s]."""
        for robot in [each for each, at in self._attempts.items() if now - at.newest > self._timeout]:
            self._silent.add(robot)
            self._close(robot, None)

    def _on(self, task: str) -> List[str]:
        return [robot for robot, attempt in self._attempts.items() if attempt.task == task]

    def _close(self, robot: str, time: Optional[float], *, certain: bool = False) -> None:
        """End a robot's attempt without success, at a time or when it was last heard [s]."""
        attempt = self._attempts.pop(robot, None)
        if attempt is not None:
            lasted = (attempt.newest if time is None else time) - attempt.start
            self.memory = learn_failure(
                self.memory, robot, attempt.task, lasted, window=self._window, shortest=self._timeout, certain=certain
            )
