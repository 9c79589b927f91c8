from __future__ import annotations

from pathlib import Path
from typing import List, Sequence, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.app.compare.allocations import compare_allocations, time_held_otherwise
from rqt_mrta_py.app.compare.side import Holding, Side


def held(robot: str, start: float, end: float, outcome: str = "done", task: str = "dig") -> Holding:
    return Holding(task, robot, start, end, outcome)


def side(*holdings: Holding, duration: float = 100.0, tasks: Sequence[Tuple[str, str]] = (("dig", "done"),)) -> Side:
    return Side(Path("s"), None, None, None, None, duration, (), tuple(tasks), holdings, (), {})


def test_the_same_robots_at_the_same_times_do_not_differ() -> None:
    mission = side(held("r1", 0.0, 10.0), held("r2", 20.0, 30.0))
    (task,) = compare_allocations(mission, mission)
    assert (task.otherwise, task.held) == (0.0, 20.0)
    assert not any(pair.differs(0.0) for pair in task.pairs)


def test_time_in_other_hands_is_measured_between_all_changes() -> None:
    first = [held("r1", 0.0, 10.0), held("r2", 12.0, 20.0)]
    second = [held("r1", 2.0, 6.0), held("r2", 5.0, 14.0)]
    # In other hands: 0 to 2 (r1, nobody), 5 to 6 (r1, both), 6 to 10 (r1, r2), 10 to 12 (nobody, r2),
    # 14 to 20 (r2, nobody); in nobody's at no time between 0 and 20.
    assert time_held_otherwise(first, second, 100.0) == (15.0, 20.0)


def test_what_only_the_longer_mission_saw_does_not_count() -> None:
    long, short = side(held("r1", 0.0, 90.0)), side(held("r1", 0.0, 30.0, "open"), duration=30.0)
    (task,) = compare_allocations(long, short)
    assert (task.otherwise, task.held) == (0.0, 30.0)


def test_two_allocations_of_one_robot_at_a_time_are_one_holder() -> None:
    first = [held("r1", 0.0, 10.0), held("r1", 5.0, 8.0)]
    assert time_held_otherwise(first, [held("r1", 0.0, 10.0)], 10.0) == (0.0, 10.0)


def test_a_robots_times_with_a_task_are_paired_in_their_order() -> None:
    first = side(held("r1", 0.0, 10.0, "lost"), held("r2", 12.0, 20.0))
    second = side(held("r1", 0.5, 10.0, "done"), held("r1", 30.0, 40.0, "done"))
    (task,) = compare_allocations(first, second)
    assert [(pair.robot, pair.number, pair.first is None, pair.second is None) for pair in task.pairs] == [
        ("r1", 1, False, False),
        ("r2", 1, False, True),
        ("r1", 2, True, False),
    ]
    assert [pair.differs(1.0) for pair in task.pairs] == [True, True, True]


@pytest.mark.parametrize(("shift", "differs"), [(0.0, True), (0.49, True), (0.5, False), (1.0, False)])
def test_an_allocation_that_moved_differs_beyond_the_shift(shift: float, differs: bool) -> None:
    (task,) = compare_allocations(side(held("r1", 0.1, 10.0)), side(held("r1", 0.3, 10.5)))
    (pair,) = task.pairs
    assert pair.moved == pytest.approx(0.5)
    assert pair.differs(shift) is differs


def test_tasks_of_either_mission_are_listed_once_those_of_the_first_before() -> None:
    first = side(held("r1", 0.0, 1.0, task="haul"), tasks=(("dig", "done"),))
    second = side(held("r1", 0.0, 1.0, task="wait"), tasks=(("haul", "done"), ("dig", "failed")))
    compared = compare_allocations(first, second)
    assert [(task.task, task.states) for task in compared] == [
        ("dig", ("done", "failed")),
        ("haul", (None, "done")),
        ("wait", (None, None)),
    ]


def test_missions_without_messages_have_nothing_to_compare() -> None:
    empty = Side(Path("s"), None, None, None, None, None, (), (), (), (), {})
    assert compare_allocations(empty, empty) == ()


HOLDINGS = st.lists(
    st.tuples(st.sampled_from(["r1", "r2", "r3"]), st.integers(0, 20), st.integers(1, 20)).map(
        lambda each: held(each[0], each[1], each[1] + each[2])
    ),
    max_size=6,
)


@given(HOLDINGS, HOLDINGS)
def test_time_in_other_hands_is_what_counting_seconds_gives(first: List[Holding], second: List[Holding]) -> None:
    def holders(holdings: List[Holding], second_number: int) -> List[str]:
        return sorted({each.robot for each in holdings if each.start <= second_number < each.end})

    pairs = [(holders(first, number), holders(second, number)) for number in range(30)]
    otherwise = sum(one != other for one, other in pairs)
    assert time_held_otherwise(first, second, 30.0) == (otherwise, sum(bool(one or other) for one, other in pairs))
    assert time_held_otherwise(second, first, 30.0)[0] == otherwise
