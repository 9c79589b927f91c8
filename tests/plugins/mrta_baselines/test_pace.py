"""What the parameters of baselines mean for rules of supervision."""

from __future__ import annotations

from typing import Optional

import pytest
from mrta_baselines.pace import baseline_pace

from rqt_mrta_py.hooks import AllocationPace
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Taxonomy


@pytest.mark.parametrize(("rule", "uptake"), [("fixed", None), ("random", 15.0)])
def test_tasks_that_are_dealt_once_wait_for_their_robots(rule: str, uptake: Optional[float]) -> None:
    """At 5 Hz four cycles take 0.8 s; the timeout is 2 s."""
    mission = Mission(
        ApplicationSpec("yard", "Yard", robots=(ApplicationRobot("robot1"),)),
        ArchitectureSpec("mrta_baselines", "Baselines", Taxonomy.parse("ST-SR-IA")),
        (),
        {"robot1": {"rule": rule}},
    )
    pace = baseline_pace(mission, AllocationPace(handover=2.0, uptake=15.0))
    assert pace.handover == pytest.approx(4.8)
    assert pace.uptake == uptake
