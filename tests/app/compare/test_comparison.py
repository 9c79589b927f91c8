from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any, Dict, Mapping, Optional

import pytest

from rqt_mrta_py.app.compare.comparison import Comparison, FigureComparison, Verdict, compare
from rqt_mrta_py.app.compare.document import document
from rqt_mrta_py.app.compare.side import HeldIncident, Side, read_side
from rqt_mrta_py.model import Tolerance, Worse
from tests.app.compare.summaries import allocation, folder, incident, summary

EMPTY = Side(Path("s"), None, None, None, None, 100.0, (), (), (), (), {})


def with_figures(statistics: Mapping[str, Any]) -> Side:
    return dataclasses.replace(EMPTY, statistics=statistics)


def figure(comparison: Comparison, name: str) -> FigureComparison:
    (found,) = [each for each in comparison.figures if each.name == name]
    return found


def verdict(first: object, second: object, tolerance: Optional[Tolerance] = None) -> Verdict:
    tolerances = () if tolerance is None else (tolerance,)
    comparison = compare(with_figures({"x": first}), with_figures({"x": second}), tolerances)
    return figure(comparison, "statistics.x").verdict


@pytest.mark.parametrize(
    ("way", "first", "second", "expected"),
    [
        (Worse.HIGHER, 10.0, 12.0, Verdict.ALLOWED),
        (Worse.HIGHER, 10.0, 12.1, Verdict.WORSE),
        (Worse.HIGHER, 10.0, 1.0, Verdict.ALLOWED),
        (Worse.LOWER, 10.0, 8.0, Verdict.ALLOWED),
        (Worse.LOWER, 10.0, 7.9, Verdict.WORSE),
        (Worse.LOWER, 10.0, 99.0, Verdict.ALLOWED),
        (Worse.EITHER, 10.0, 7.9, Verdict.WORSE),
        (Worse.EITHER, 10.0, 12.1, Verdict.WORSE),
        (Worse.NEVER, 10.0, 1e9, Verdict.SHOWN),
        (Worse.HIGHER, 10.0, 10.0, Verdict.EQUAL),
        (Worse.HIGHER, 10, 10.0, Verdict.EQUAL),
        (Worse.HIGHER, -10.0, -8.0, Verdict.ALLOWED),
        (Worse.HIGHER, -10.0, -7.9, Verdict.WORSE),
    ],
)
def test_a_fifth_is_allowed_in_the_direction_that_is_worse(
    way: Worse, first: float, second: float, expected: Verdict
) -> None:
    assert verdict(first, second, Tolerance("statistics.x", way, relative=0.2)) is expected


@pytest.mark.parametrize(("second", "expected"), [(1.3, Verdict.ALLOWED), (1.31, Verdict.WORSE)])
def test_the_greater_of_both_allowances_counts(second: float, expected: Verdict) -> None:
    assert verdict(1.0, second, Tolerance("*", Worse.HIGHER, relative=0.2, absolute=0.3)) is expected


def test_a_change_of_exactly_the_allowance_is_allowed_whatever_floats_make_of_it() -> None:
    assert 0.95 - 0.05 != 0.9
    assert verdict(0.95, 0.9, Tolerance("*", Worse.LOWER, absolute=0.05)) is Verdict.ALLOWED


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        (3.0, None, Verdict.WORSE),
        (None, 3.0, Verdict.ALLOWED),
        (None, None, Verdict.EQUAL),
        ("a", "b", Verdict.ALLOWED),
        ("a", "a", Verdict.EQUAL),
        (True, 1, Verdict.ALLOWED),
    ],
)
def test_a_number_that_got_lost_is_worse(first: object, second: object, expected: Verdict) -> None:
    assert verdict(first, second, Tolerance("*", Worse.HIGHER)) is expected


@pytest.mark.parametrize(("first", "second"), [("a", "b"), (True, False), (None, 3.0)])
def test_whatever_changes_is_worse_where_either_way_is(first: object, second: object) -> None:
    assert verdict(first, second, Tolerance("*", Worse.EITHER)) is Verdict.WORSE


def test_what_one_mission_does_not_know_at_all_is_shown() -> None:
    everything = (Tolerance("*", Worse.EITHER),)
    comparison = compare(with_figures({"x": 1}), with_figures({"y": 1}), everything)
    for name, known in (("statistics.x", (True, False)), ("statistics.y", (False, True))):
        assert (figure(comparison, name).known, figure(comparison, name).verdict) == (known, Verdict.SHOWN)


def test_the_first_tolerance_that_matches_counts_and_unused_ones_are_told() -> None:
    unused = Tolerance("statistics.z", Worse.HIGHER)
    tolerances = (Tolerance("statistics.x", Worse.NEVER), Tolerance("statistics.*", Worse.HIGHER), unused)
    comparison = compare(with_figures({"x": 1, "y": 1}), with_figures({"x": 2, "y": 2}), tolerances)
    assert [each.name for each in comparison.worse] == ["statistics.y"]
    assert comparison.unused == (unused,)


def test_nested_statistics_are_figures_of_their_own_and_what_is_no_number_of_ours_is_left_out() -> None:
    statistics = {"shares": {"r1": 0.5}, "list": [1, {"deep": 2}], "huge": 10**400, "none": None}
    names = [each.name for each in compare(with_figures(statistics), EMPTY).figures if "statistics" in each.name]
    assert names == ["statistics.list.0", "statistics.list.1.deep", "statistics.none", "statistics.shares.r1"]


def test_a_mission_compared_with_itself_is_equal(tmp_path: Path) -> None:
    content = summary(
        allocations=[allocation("dig", "r1", 2.0, 9.0)], incidents=[incident("odd", "error", 3.0, ["r1"], ["dig"])]
    )
    mission = read_side(folder(tmp_path, "a", content))
    comparison = compare(mission, mission, [Tolerance("*", Worse.EITHER)])
    assert {each.verdict for each in comparison.figures} == {Verdict.EQUAL}
    assert comparison.worse == ()


def missions(tmp_path: Path) -> Dict[str, Side]:
    """Give two missions: in the second, r1 falls silent with dig after 20 s, r2 takes it, haul is never done."""
    first = summary(
        time=(1.0, 101.0),
        allocations=[allocation("dig", "r1", 2.0, 41.0), allocation("haul", "r2", 3.0, 61.0)],
        statistics={"reallocations": 0, "coverage": {"dig": 0.39, "haul": 0.58}},
    )
    second = summary(
        time=(1000.0, 1100.0),
        tasks=[("dig", "done"), ("haul", "waiting")],
        allocations=[allocation("dig", "r1", 1001.0, 1020.0, "lost"), allocation("dig", "r2", 1025.0, 1060.0)],
        incidents=[incident("robot_silent_with_task", "error", 1020.0, ["r1"], ["dig"])],
        statistics={"reallocations": 1, "coverage": {"dig": 0.54, "haul": 0.0}},
        seed=8,
    )
    return {"a": read_side(folder(tmp_path, "a", first)), "b": read_side(folder(tmp_path, "b", second))}


def test_a_worse_mission_is_judged_by_the_tolerances_of_the_house(tmp_path: Path) -> None:
    both = missions(tmp_path)
    comparison = compare(both["a"], both["b"])
    assert [each.name for each in comparison.worse] == ["incidents.error", "tasks.done"]
    assert figure(comparison, "statistics.reallocations").verdict is Verdict.ALLOWED
    assert figure(comparison, "statistics.coverage.haul").verdict is Verdict.SHOWN
    assert figure(comparison, "differences.new_incidents.error").second == 1
    # dig: r1 to 40 s against r1 to 20 s, nobody, r2 from 25 to 60 s; haul: r2 from 2 to 60 s against nobody.
    # In other hands 20 to 60 s of 1 to 60 s, and 58 s.
    share = figure(comparison, "differences.share_of_time_held_otherwise")
    assert (share.first, share.second) == (0, pytest.approx((40 + 58) / (59 + 58)))
    assert compare(both["b"], both["a"]).worse == ()


def test_the_document_holds_plain_values_only_and_is_the_same_every_time(tmp_path: Path) -> None:
    both = missions(tmp_path)
    told = document(compare(both["a"], both["b"]), 1.0)
    assert json.dumps(told, allow_nan=False) == json.dumps(document(compare(both["a"], both["b"]), 1.0))
    assert told["worse"] == ["incidents.error", "tasks.done"]
    assert told["a"]["seed"] == 7
    assert told["b"]["duration"] == 100.0
    (dig, haul) = told["tasks"]
    assert (dig["held_otherwise"], dig["held"], haul["state_b"]) == (40.0, 59.0, "waiting")
    assert dig["allocations"][0] == {
        "robot": "r1",
        "number": 1,
        "a": {"from": 1.0, "to": 40.0, "outcome": "done"},
        "b": {"from": 1.0, "to": 20.0, "outcome": "lost"},
        "moved": 20.0,
        "differs": True,
    }
    assert [(each["a"], each["b"]["rule"]) for each in told["incidents"]] == [(None, "robot_silent_with_task")]


def found(rule: str, start: float, robot: str = "r1") -> HeldIncident:
    return HeldIncident(rule, "warning", (robot,), ("dig",), start, start + 1.0, rule)


def test_incidents_are_paired_by_rule_robots_and_tasks_in_their_order() -> None:
    first = dataclasses.replace(EMPTY, incidents=(found("a", 1.0), found("a", 5.0), found("b", 6.0)))
    second = dataclasses.replace(EMPTY, incidents=(found("a", 2.0), found("a", 7.0, "r2")))
    pairs = compare(first, second).incidents
    assert [(pair.first and pair.first.start, pair.second and pair.second.start) for pair in pairs] == [
        (1.0, 2.0),
        (5.0, None),
        (6.0, None),
        (None, 7.0),
    ]
