"""What the task that each robot carries out still costs it, for pictures."""

from __future__ import annotations

from typing import Sequence

from mrta_demir_cf.message_kinds import SUBSCRIPTIONS, Kind
from mrta_demir_cf.messages import read_message
from mrta_demir_cf.parameters import DemirCfParameters
from rqt_mrta_py.hooks import CurvePanel, CurveTrace, Heard, PanelSetup, Subscription, TeamTraces, nice_top

__all__ = ["CostPanel"]

_SILENCE = 5.1
"""The longest heartbeat, and one lost message [s]."""

_SUBSCRIPTION = next(wish for wish in SUBSCRIPTIONS if wish.topic == Kind.EXECUTION.topic)


class CostPanel:
    """Collects what robots say of the tasks that they carry out: each time a stroke that falls towards 0.

    Args:
        setup: its robots and tasks each get a curve from the start; others join at the end.
    """

    def __init__(self, setup: PanelSetup) -> None:
        self._traces = TeamTraces(setup.mission, lambda: CurveTrace(_SILENCE))
        told = {robot: given.get("unknown_cost") for robot, given in setup.mission.parameters.items()}
        self._unknown = {robot: cost for robot, cost in told.items() if isinstance(cost, (int, float))}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' executions."""
        return (_SUBSCRIPTION,)

    def hear(self, heard: Heard) -> None:
        """Take in one message; what stands for a cost that nobody knows is not drawn."""
        message = read_message(heard)
        if isinstance(message, str):
            return
        if message.cost != self._unknown.get(message.robot, DemirCfParameters.unknown_cost):
            self._traces.of(message.robot, message.task).add(heard.receipt, message.cost)

    def view(self, start: float, end: float) -> CurvePanel:
        """Give the costs from ``start`` to ``end`` [s], one group for each robot."""
        groups = self._traces.groups(start, end)
        return CurvePanel("Cost of the task carried out", "m", nice_top(groups), None, groups)
