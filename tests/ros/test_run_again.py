"""One run after another on the same master: what was said of the first does not count for the second."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.ros.live_team import LiveRun
from tests.ros_master import MasterProcess

pytestmark = pytest.mark.ros

NODES = ("/simulation", "/robot1/agent", "/robot2/agent")


def test_a_run_takes_no_parameters_over_from_the_one_before(master: MasterProcess, tmp_path: Path) -> None:
    """ROS keeps private parameters: a run of 4 s made all later ones on its master last 4 s."""
    for name, value in (("/simulation/map", "unknown"), ("/robot1/agent/robots", 1), ("/robot1/agent/seed", 7)):
        master.ask("setParam", name, value)
    plan = ("border_patrol", "--robots", "2", "--world", "planar", "--duration", "1.5", "--lock-step")
    with LiveRun(tmp_path / "live", master.environment, *plan) as live:
        live.finish()
    assert live.summary["time"] == {"start": 1.0, "end": 2.5}
    assert [each["id"] for each in live.summary["robots"]] == ["robot1", "robot2"]
    left = master.ask("getParamNames")
    assert [name for name in left if name.startswith(NODES)] == []
