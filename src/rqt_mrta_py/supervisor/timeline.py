"""The states that one thing goes through, as contiguous intervals."""

from __future__ import annotations

from typing import Callable, Generic, List, Tuple, TypeVar

from rqt_mrta_py.model import RobotInterval, RobotState, TaskInterval, TaskState

__all__ = ["Timeline"]

_State = TypeVar("_State", RobotState, TaskState)
_Interval = TypeVar("_Interval", RobotInterval, TaskInterval)


class Timeline(Generic[_State, _Interval]):
    """A history without gaps and overlaps; the newest interval is open, all others have a length.

    Args:
        make: builds an interval from state, start and end [s].
        state: the first state.
        start: when it begins [s].
    """

    def __init__(self, make: Callable[[_State, float, float], _Interval], state: _State, start: float) -> None:
        self._make: Callable[[_State, float, float], _Interval] = make
        self._closed: List[_Interval] = []
        self.state: _State = state
        self.since = start

    def change(self, state: _State, time: float) -> float:
        """Begin a new state.

        Args:
            state: from now on.
            time: when it begins [s]; a time before the present state's start counts as that start.

        Returns:
            The time at which it began [s].
        """
        time = max(time, self.since)
        if time > self.since:
            self._closed.append(self._make(self.state, self.since, time))
        self.state, self.since = state, time
        if self._closed and self._closed[-1].state is state:
            # What lay between had no length: the older interval goes on.
            self.since = self._closed.pop().start
        return time

    def intervals(self, end: float) -> Tuple[_Interval, ...]:
        """List the history, oldest first; the last interval is the present state's, whatever its length.

        Args:
            end: where the open interval is cut [s].
        """
        present = (self._make(self.state, self.since, end),)
        return tuple(self._closed) + present if self._closed else present

    def fork(self) -> Timeline[_State, _Interval]:
        """Copy the history, so that the copy can go on by itself."""
        twin: Timeline[_State, _Interval] = Timeline(self._make, self.state, self.since)
        twin._closed.extend(self._closed)
        return twin
