"""A scenario tells what is simulated, and what follows from that."""

from __future__ import annotations

from typing import Optional

import pytest

from rqt_mrta_py.model import Arena, ScenarioSpec


@pytest.mark.parametrize(("linger", "is_open_ended"), [(None, False), (0.0, True), (10.0, True)])
def test_a_scenario_is_open_ended_if_its_mission_ends_any_time_after_its_last_task(
    linger: Optional[float], is_open_ended: bool
) -> None:
    assert ScenarioSpec(Arena(0.0, 0.0, 1.0, 1.0), (), (), linger=linger).is_open_ended is is_open_ended
