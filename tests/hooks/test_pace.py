from __future__ import annotations

import math
import re
from typing import Any, Dict

import pytest

from rqt_mrta_py.hooks import AllocationPace


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"handover": 0.0}, "handover must be above 0 and finite (got 0.0)"),
        ({"handover": 1.0, "uptake": math.inf}, "uptake must be above 0 and finite (got inf)"),
        ({"handover": 1.0, "yielding": -1.0}, "yielding must be at least 0 s and finite (got -1.0)"),
        ({"handover": 1.0, "brief": math.nan}, "brief must be above 0 and finite (got nan)"),
        (
            {"handover": 1.0, "durations": {("robot1", "patrol"): 0.0}},
            "durations[('robot1', 'patrol')] must be above 0 s (got 0.0)",
        ),
    ],
)
def test_pace_that_no_rule_could_measure_by_is_refused(values: Dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        AllocationPace(**values)


def test_what_is_settled_beforehand_has_no_uptake() -> None:
    assert AllocationPace(handover=1.0, uptake=None).uptake is None
