"""What one look says of one cell: log-odds worked out by hand."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from rqt_mrta_py.robot.mapping.inverse_sensor import InverseSensor, log_odds, probability, updated


def test_log_odds_of_an_even_chance_are_0_and_of_seven_to_three_0_8473() -> None:
    assert log_odds(0.5) == 0.0
    assert log_odds(0.7) == pytest.approx(math.log(7.0 / 3.0))
    assert log_odds(0.7) == pytest.approx(0.847298, abs=1e-6)


def test_the_usual_evidence_is_that_of_the_probabilities_named() -> None:
    """1 / (1 + exp(-0.85)) = 0.7006, 1 / (1 + exp(0.4)) = 0.4013, of the bounds 0.1192 and 0.9707."""
    usual = InverseSensor()
    chances = [probability(each) for each in (usual.hit, usual.passed, usual.lowest, usual.highest)]
    assert chances == pytest.approx([0.7006, 0.4013, 0.1192, 0.9707], abs=1e-4)


def test_evidence_is_added_between_the_bounds() -> None:
    before = np.array([0.0, 3.0, -1.8], dtype=np.float32)
    assert updated(before, 0.85, -2.0, 3.5).tolist() == pytest.approx([0.85, 3.5, -0.95])
    assert updated(before, -0.4, -2.0, 3.5).tolist() == pytest.approx([-0.4, 2.6, -2.0])


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"hit": 0.0}, "hit: must be a finite number above 0 (got 0.0)"),
        ({"passed": 0.4}, "passed: must be a finite number below 0 (got 0.4)"),
        ({"lowest": -math.inf}, "lowest: must be a finite number below 0 (got -inf)"),
        ({"highest": math.nan}, "highest: must be a finite number above 0 (got nan)"),
    ],
)
def test_evidence_on_the_wrong_side_is_refused(values: dict, message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        InverseSensor(**values)
