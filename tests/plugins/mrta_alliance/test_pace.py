"""What ALLIANCE's parameters mean for rules of supervision, worked out by hand."""

from __future__ import annotations

from typing import Any, Dict

import pytest
from mrta_alliance.pace import alliance_pace

from rqt_mrta_py.hooks import AllocationPace
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Task, Taxonomy

USUAL = AllocationPace(handover=4.0, uptake=30.0, brief=10.0)


def mission(**parameters: Dict[str, Any]) -> Mission:
    robots = tuple(ApplicationRobot(robot) for robot in ("robot1", "robot2"))
    architecture = ArchitectureSpec("mrta_alliance", "ALLIANCE", Taxonomy.parse("ST-SR-IA"))
    return Mission(
        ApplicationSpec("yard", "Yard", robots=robots), architecture, (Task("patrol", "wander"),), parameters
    )


def told(threshold: float = 30.0, psi: float = 20.0, giving_up: float = 300.0, **robot: Any) -> Dict[str, Any]:
    behaviour_set = {
        "task_id": "patrol",
        "task_expected_duration": 60.0,
        "motivational_behaviour": {
            "threshold": threshold,
            "acquiescence": {"yielding_delay": psi, "giving_up_delay": giving_up},
            "impatience": {"fast_rate": 1.0},
        },
    }
    return {"behaviour_sets": {"size": 1, "behaviour_set0": behaviour_set}, **robot}


def test_pace_follows_from_the_parameters_of_the_slowest_robot() -> None:
    """robot2: tau 3 s, 40 / (1 x 5 Hz) = 8 s, a broadcast of 0.5 s, three cycles of 0.2 s: 12.1 s, twice."""
    pace = alliance_pace(mission(robot1=told(), robot2=told(threshold=40.0, psi=25.0)), USUAL)
    assert pace.uptake == pytest.approx(24.2)
    assert pace.handover == pytest.approx(4.0 + 0.5 + 0.6)
    assert (pace.yielding, pace.eager, pace.overrun, pace.brief) == (25.0, True, 1.0, 10.0)
    assert pace.durations == {("robot1", "patrol"): 60.0, ("robot2", "patrol"): 60.0}


def test_robots_that_soon_give_up_by_themselves_do_not_flip() -> None:
    assert alliance_pace(mission(robot1=told(giving_up=5.0)), USUAL).brief == 4.5


def test_original_nodes_believe_in_others_for_twice_as_long() -> None:
    """2 x (6 + 6 + 0.5 + 0.6) s."""
    pace = alliance_pace(mission(robot1=told(strict_original=True)), USUAL)
    assert pace.uptake == pytest.approx(26.2)


def test_mission_without_parameters_counts_as_having_the_defaults() -> None:
    pace = alliance_pace(mission(), USUAL)
    assert (pace.yielding, pace.durations) == (20.0, {})
    assert pace.uptake == pytest.approx(20.2)
