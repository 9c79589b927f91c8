"""What L-ALLIANCE's parameters mean for rules of supervision."""

from __future__ import annotations

import pytest
from mrta_l_alliance.pace import l_alliance_pace

from rqt_mrta_py.hooks import AllocationPace
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Taxonomy


def test_robots_may_wait_for_who_is_better_and_overrun_what_was_learned() -> None:
    """ALLIANCE's 2 x (3 + 6 + 0.5 + 0.6) s and twice the boredom of 9 s."""
    architecture = ArchitectureSpec("mrta_l_alliance", "L-ALLIANCE", Taxonomy.parse("ST-SR-IA"))
    application = ApplicationSpec("yard", "Yard", robots=(ApplicationRobot("robot1"),))
    learning = {"learning": {"boredom_delay": 9.0, "giving_up_factor": 4.0}}
    mission = Mission(application, architecture, (), {"robot1": learning})
    pace = l_alliance_pace(mission, AllocationPace(handover=4.0))
    assert pace.uptake == pytest.approx(20.2 + 18.0)
    assert (pace.eager, pace.overrun, pace.durations) == (False, 4.0, {})
