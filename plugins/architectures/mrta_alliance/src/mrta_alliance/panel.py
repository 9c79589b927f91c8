"""Motivation against threshold of every behaviour set, for pictures (the panel of rqt_alliance)."""

from __future__ import annotations

import math
from typing import Sequence

from mrta_alliance.messages import MOTIVATION_TOPICS, MOTIVATION_TYPE
from rqt_mrta_py.hooks import CurvePanel, CurveTrace, Heard, PanelSetup, Subscription, TeamTraces
from rqt_mrta_py.model import normalise_id

__all__ = ["MotivationPanel"]

_SUBSCRIPTION = Subscription(
    MOTIVATION_TOPICS, MOTIVATION_TYPE, ("header/frame_id", "task_id", "motivation", "threshold")
)

_SILENCE = 2.0
"""Nothing is known of the motivation after that [s]."""

_TOP = 1.08


class MotivationPanel:
    """Collects the motivations of a team."""

    def __init__(self, setup: PanelSetup) -> None:
        """Start with an empty curve for every robot of the mission and every task that it may carry out."""
        self._traces = TeamTraces(setup.mission, lambda: CurveTrace(_SILENCE, falls=False))

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' motivations."""
        return (_SUBSCRIPTION,)

    def hear(self, heard: Heard) -> None:
        """Take in one Motivation; robots and tasks that the mission does not know join at the end."""
        threshold = heard.fields["threshold"]
        ratio = heard.fields["motivation"] / threshold if threshold else math.nan
        if not math.isfinite(ratio):
            return
        robot, task = normalise_id(heard.fields["header/frame_id"]), heard.fields["task_id"]
        self._traces.of(robot, task).add(heard.receipt, ratio)

    def view(self, start: float, end: float) -> CurvePanel:
        """Give the ratio of motivation to threshold from ``start`` to ``end`` [s], one group for each robot."""
        return CurvePanel("Motivation / threshold", "1", _TOP, 1.0, self._traces.groups(start, end))
