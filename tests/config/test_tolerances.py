"""Files of tolerances."""

from __future__ import annotations

import pytest

from rqt_mrta_py.config.tolerances import read_tolerances
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import Tolerance, Worse


def test_tolerances_are_read_in_their_order_with_their_lines() -> None:
    text = """# of our CI
tolerances:
  - figure: statistics.makespan
    worse: higher
    relative: 0.1
    absolute: 2
  - {figure: "tasks.*", worse: either}
"""
    assert [tuple(line) for line in read_tolerances(text, "t.yaml")] == [
        (3, Tolerance("statistics.makespan", Worse.HIGHER, 0.1, 2.0)),
        (7, Tolerance("tasks.*", Worse.EITHER)),
    ]


def test_everything_that_is_wrong_is_told_with_its_line() -> None:
    text = """tolerances:
- {figure: a, worse: less}
- {figure: b, worse: lower, relative: -0.1}
- {figure: b, worse: lower, absolut: 1}
- {worse: lower, absolute: .inf}
"""
    with pytest.raises(ConfigError) as caught:
        read_tolerances(text, "t.yaml")
    assert str(caught.value) == "t.yaml:5: holds .inf; numbers must be finite"
    with pytest.raises(ConfigError) as caught:
        read_tolerances(text.replace(".inf", "2"), "t.yaml")
    assert str(caught.value).splitlines() == [
        "t.yaml:2: tolerances[0]/worse: must be one of higher, lower, either, never (got 'less')",
        "t.yaml:3: tolerances[1]/relative: must be a number from 0 (got -0.1)",
        "t.yaml:4: tolerances[2]/absolut: is not known; nearest is 'absolute'",
        "t.yaml:4: tolerances[2]/figure: 'b' stands twice; the first one is in line 3",
        "t.yaml:5: tolerances[3]/figure: is missing; give a text",
    ]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "t.yaml:1: is empty; accepted: tolerances"),
        (
            "tolerances: 3",
            "t.yaml:1: tolerances: must be a list of mappings (figure, worse, relative, absolute) (got 3)",
        ),
        ("figures: []", "t.yaml:1: figures: is not known; accepted: tolerances"),
    ],
)
def test_what_is_no_file_of_tolerances_is_told(text: str, message: str) -> None:
    with pytest.raises(ConfigError) as caught:
        read_tolerances(text, "t.yaml")
    assert str(caught.value).splitlines()[0] == message


@pytest.mark.parametrize(("relative", "absolute"), [(-0.1, 0.0), (0.0, -1.0), (float("nan"), 0.0)])
def test_a_tolerance_is_not_negative(relative: float, absolute: float) -> None:
    with pytest.raises(ValueError, match="tolerances must be from 0"):
        Tolerance("x", Worse.HIGHER, relative, absolute)
