"""Builds sensors for tests."""

from __future__ import annotations

from typing import Any

import numpy as np

from rqt_mrta_py.hooks import SensorContext
from rqt_mrta_py.model import Pose, SensorSetup
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE

START = Pose(0.0, 0.0, 0.0)


def context(kind: str, topic: str, *, random: Any = None, start: Pose = START, rate: float = 10.0, **parameters: Any):
    """Describe one sensor of robot1."""
    generator = np.random.default_rng(7) if random is None else random
    return SensorContext("robot1", DIFF_DRIVE, SensorSetup(kind, topic, rate, parameters), start, generator)
