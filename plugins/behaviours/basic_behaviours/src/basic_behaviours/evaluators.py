"""Sensory evaluators that any team can use."""

from __future__ import annotations

from typing import Sequence

from rqt_mrta_py.hooks import SensorReading
from rqt_mrta_py.model import Task

__all__ = ["AllSensorsFresh"]


class AllSensorsFresh:
    """Finds a task applicable while every sensor that its parameters name is up to date; without sensors always.

    Args:
        task: judged; its content does not matter here.
    """

    def __init__(self, task: Task) -> None:
        self._task = task

    def is_applicable(self, now: float, sensors: Sequence[SensorReading]) -> bool:
        """Judge by the sensors; see hooks.SensoryEvaluator."""
        return all(sensor.up_to_date for sensor in sensors)
