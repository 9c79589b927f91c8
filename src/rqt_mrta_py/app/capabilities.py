"""What robots can do, as far as that is known."""

from __future__ import annotations

from typing import Dict, FrozenSet, Mapping, Optional

from rqt_mrta_py.hooks import RobotModel
from rqt_mrta_py.model import ScenarioSpec

__all__ = ["known_capabilities"]


def known_capabilities(scenario: Optional[ScenarioSpec], models: Mapping[str, RobotModel]) -> Dict[str, FrozenSet[str]]:
    """Tell what each simulated robot of a known model can do; of real robots nothing is known.

    Args:
        scenario: what is simulated; None on hardware.
        models: by name.

    Returns:
        By the robot's id.
    """
    robots = scenario.robots if scenario is not None else ()
    return {
        robot.id: models[robot.model].capabilities.union(robot.capabilities)
        for robot in robots
        if robot.model in models
    }
