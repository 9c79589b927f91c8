"""Sensory evaluators: from what a robot's sensors say of late to whether a task is applicable (ALLIANCE's 3.1)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Optional, Protocol, Sequence

from rqt_mrta_py.hooks.stream import Heard
from rqt_mrta_py.model import Task

__all__ = ["SensorReading", "SensoryEvaluator", "SensoryEvaluatorFactory"]


@dataclass(frozen=True)
class SensorReading:
    """One sensor as an evaluator sees it.

    Attributes:
        topic: as in the parameters.
        up_to_date: False once its newest message is older than the sensor's timeout, or before the first.
        newest: its newest message; None before the first.
    """

    topic: str
    up_to_date: bool
    newest: Optional[Heard]


class SensoryEvaluator(Protocol):
    """Judges whether one task is applicable in the present state of the environment."""

    def is_applicable(self, now: float, sensors: Sequence[SensorReading]) -> bool:
        """Judge by the sensors that the task's parameters name, in their order, at a time [s]."""
        ...


SensoryEvaluatorFactory = Callable[[Task], SensoryEvaluator]
