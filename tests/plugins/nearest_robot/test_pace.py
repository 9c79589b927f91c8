"""What the parameters of bidding robots mean for rules of supervision."""

from __future__ import annotations

import pytest
from nearest_robot.pace import nearest_robot_pace

from rqt_mrta_py.hooks import AllocationPace
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Taxonomy


@pytest.mark.parametrize(("usual", "uptake"), [(15.0, 15.0), (5.0, 10.0)])
def test_pace_follows_from_rates_and_timeouts(usual: float, uptake: float) -> None:
    """The slower robot's four cycles take 2 s, the more patient one's timeout is 3 s: 5 s, twice."""
    mission = Mission(
        ApplicationSpec("yard", "Yard", robots=(ApplicationRobot("robot1"), ApplicationRobot("robot2"))),
        ArchitectureSpec("nearest_robot", "Nearest robot", Taxonomy.parse("ST-SR-IA")),
        (),
        {"robot1": {"rate": 2.0}, "robot2": {"timeout": 3.0}},
    )
    pace = nearest_robot_pace(mission, AllocationPace(handover=2.0, uptake=usual))
    assert (pace.handover, pace.uptake, pace.eager) == (7.0, uptake, True)
