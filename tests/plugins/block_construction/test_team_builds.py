"""Walls put up by simulated teams, one of which loses a robot."""

from __future__ import annotations

import pytest

from rqt_mrta_py.app.bench.laboratory import EmbeddedLaboratory
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.hooks import Experiment
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind

pytest.importorskip("pybullet", reason="builds are simulated in the world bullet")
pytest.importorskip("scipy", reason="SciPy finds ways")

LOST = (
    ScenarioEvent(60.0, ScenarioEventKind.ROBOT_STOPS, "robot1"),
    ScenarioEvent(120.0, ScenarioEventKind.ROBOT_REMOVED, "robot1"),
)


@pytest.mark.long
@pytest.mark.parametrize("architecture", ["mrta_demir_cf", "mrta_alliance"])
@pytest.mark.parametrize(("robots", "events"), [(3, ()), (2, LOST)])
def test_walls_are_built_by_teams_even_if_a_robot_is_lost(architecture, robots, events) -> None:  # type: ignore[no-untyped-def]
    """All six blocks lie in their slots; no two robots, each 0.36 m wide, came nearer than that or touched anything."""
    settings = ("structure=wall", "supply=corners_all", "order=free", "pose_noise=0.002")
    experiment = Experiment("block_construction", 3, architecture, robots=robots, settings=settings, events=events)
    (trial,) = EmbeddedLaboratory(compose()).trials([experiment])
    build = trial.record.statistics["build"]
    assert (build["placed"], build["blocks"]) == (6, 6)
    assert build["nearest"] >= 0.36
    assert build["collisions"] == 0
