"""What DEMiR-CF's parameters mean for rules of supervision."""

from __future__ import annotations

import pytest
from mrta_demir_cf.pace import demir_cf_pace

from rqt_mrta_py.hooks import AllocationPace
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Taxonomy

MISSION = Mission(
    ApplicationSpec("yard", "Yard", robots=(ApplicationRobot("robot1"), ApplicationRobot("robot2"))),
    ArchitectureSpec("mrta_demir_cf", "DEMiR-CF", Taxonomy.parse("ST-SR-IA")),
    (),
    {"robot1": {"heartbeat": 1.0, "execution_timeout": 9.0, "overdue": 3.0}},
)


def test_pace_follows_from_heartbeats_and_timeouts() -> None:
    """robot1: 9 + 1 + 1 s, robot2 by default 7 + 1 + 2 s; the longer one twice; beats of 2 s, replies 1 s."""
    pace = demir_cf_pace(MISSION, AllocationPace(handover=6.0))
    assert pace.uptake == pytest.approx(22.0)
    assert pace.handover == pytest.approx(9.0)
    assert (pace.eager, pace.overrun) == (False, 3.0)
