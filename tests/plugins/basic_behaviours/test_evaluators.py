from __future__ import annotations

import pytest
from basic_behaviours.plugin import mrta_register_sensory_evaluators

from rqt_mrta_py.hooks import SensorReading
from rqt_mrta_py.model import Task


@pytest.mark.parametrize(
    ("fresh", "applicable"), [((), True), ((True,), True), ((True, True), True), ((True, False), False)]
)
def test_all_sensors_fresh_asks_for_every_sensor(fresh: tuple, applicable: bool) -> None:
    evaluator = mrta_register_sensory_evaluators()["basic_behaviours/all_sensors_fresh"](Task("t", "k"))
    readings = [SensorReading(f"sensor{index}", up_to_date, None) for index, up_to_date in enumerate(fresh)]
    assert evaluator.is_applicable(1.0, readings) is applicable
