"""Parameters of one level, as plugins read them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Tuple

import pytest

from rqt_mrta_py.hooks import ParameterProblem, ParameterRangeError, read_fields, wrong_parameters


@dataclass(frozen=True)
class Mower:
    """Four parameters, one of each kind."""

    speed: float = 0.5
    blades: int = 2
    quiet: bool = False
    colour: str = "green"

    def __post_init__(self) -> None:
        if self.speed <= 0.0:
            raise ParameterRangeError((ParameterProblem("speed", f"must be above 0 m/s (got {self.speed:g})"),))


def test_what_is_missing_takes_its_default_and_what_is_unknown_is_passed_over() -> None:
    assert read_fields(Mower, {}) == Mower()
    assert read_fields(Mower, {"speed": 2, "blades": 3, "wings": 4}) == Mower(2.0, 3)
    assert isinstance(read_fields(Mower, {"speed": 2}).speed, float)


@pytest.mark.parametrize(
    ("given", "found"),
    [
        ({"speed": "fast"}, [("speed", "must be a number (got 'fast')")]),
        ({"speed": True}, [("speed", "must be a number (got True)")]),
        ({"blades": 2.5}, [("blades", "must be a whole number (got 2.5)")]),
        ({"quiet": 1}, [("quiet", "must be true or false (got 1)")]),
        ({"colour": None}, [("colour", "must be a text (got None)")]),
        (
            {"speed": -1.0, "colour": 7},
            [("colour", "must be a text (got 7)"), ("speed", "must be above 0 m/s (got -1)")],
        ),
        ({}, []),
    ],
)
def test_everything_that_is_wrong_is_told_at_once(given: Dict[str, Any], found: List[Tuple[str, str]]) -> None:
    assert [tuple(problem) for problem in wrong_parameters(lambda: read_fields(Mower, given))] == found
    if found:
        with pytest.raises(ParameterRangeError) as caught:
            read_fields(Mower, given)
        assert str(caught.value) == "; ".join(f"{path}: {message}" for path, message in found)
