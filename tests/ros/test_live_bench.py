"""What a live supervisor must stand, as the benchmark measures it; how quick it is, is not asserted."""

from __future__ import annotations

from typing import Dict

import pytest

from rqt_mrta_py.app.bench.live.crash import measure_crash
from rqt_mrta_py.app.bench.live.endurance import measure_endurance
from rqt_mrta_py.app.bench.live.session import LiveSession
from rqt_mrta_py.hooks import BenchmarkTable
from tests.ros_process import require_live_ros

pytestmark = pytest.mark.ros


def row(table: BenchmarkTable) -> Dict[str, float]:
    (cells,) = table.rows
    return {name: float(cell or 0.0) for name, cell in zip(table.columns, cells)}


@pytest.mark.parametrize("seconds", [8.0, pytest.param(600.0, marks=pytest.mark.long)])
def test_a_thousand_messages_a_second_are_heard_all_and_memory_stays_flat(seconds: float) -> None:
    require_live_ros()
    with LiveSession() as session:
        found = row(measure_endurance(session, seconds))
    assert found["published"] == 1000.0 * seconds
    assert found["dropped"] == 0.0
    assert found["growth [MB]"] < 10.0


@pytest.mark.long
def test_recording_of_ten_minutes_that_is_killed_lacks_less_than_its_last_second() -> None:
    require_live_ros()
    with LiveSession() as session:
        found = row(measure_crash(session, 600.0))
    assert found["lost at the end [s]"] < 1.0
    assert found["messages kept"] > 590_000.0
