"""The network of learning automata that plans builds."""

from __future__ import annotations

import numpy as np
import pytest
from block_construction.errors import ConstructionError
from block_construction.execution.cost import plan_cost
from block_construction.execution.feasibility import check_plan
from block_construction.execution.network import Learning, learn_plan, open_share
from block_construction.execution.planners import plan_build
from block_construction.execution.problem import BuildProblem, Step
from block_construction.execution.subset_programme import plan_exactly

from tests.plugins.block_construction.builds import RING, RING_BLOCKS, place, problem

pytest.importorskip("scipy", reason="SciPy finds ways")

TWO_LEVELS = [[2, 2, 1], [1, 0, 1], [1, 1, 1]]


def asked() -> BuildProblem:
    return problem(TWO_LEVELS, [*RING_BLOCKS, (1, 1, 2, 2)])


def test_closed_actions_leave_their_share_to_the_open_ones() -> None:
    """Of 0.5, 0.3, 0.2 the first is closed: 0.3 and 0.2 become 0.6 and 0.4 (equation 5.8)."""
    assert [open_share(each, 0.5) for each in (0.3, 0.2)] == pytest.approx([0.6, 0.4])


def test_what_is_kept_is_the_shortest_of_what_was_drawn() -> None:
    build = asked()
    learned = learn_plan(build, Learning(iterations=60), np.random.default_rng(3))
    assert len(learned.lengths) == 60
    assert plan_cost(build, learned.steps).total == pytest.approx(min(learned.lengths))
    assert min(learned.lengths) >= plan_cost(build, plan_exactly(build)).total - 1e-9


def test_every_drawn_plan_keeps_to_groups_and_places() -> None:
    """With a rate of 0 nothing is learned, and draws are uniform over all plans."""
    build = asked()
    for seed in range(20):
        steps = learn_plan(build, Learning(iterations=1), np.random.default_rng(seed)).steps
        assert sorted(step.block for step in steps[:4]) == [1, 2, 3, 4]
        assert steps[4].block == 5
        assert all(step.place - 1 in build.holding(step.block) for step in steps)


def test_without_learning_all_orders_are_as_likely() -> None:
    """Of two blocks and one place each order has probability 1/2: 400 draws lie within 4 deviations of 10."""
    build = problem([[1, 1]], [(1, 1, 1, 1), (2, 1, 1, 1)], [place(1, 0.2, 0.2, {1: None})])
    lengths = learn_plan(build, Learning(rate=0.0, iterations=400), np.random.default_rng(1)).lengths
    one = plan_cost(build, [Step(1, 1), Step(1, 2)]).total
    first = sum(length == pytest.approx(one) for length in lengths)
    assert 160 <= first <= 240


def test_plans_become_shorter_by_learning() -> None:
    lengths = learn_plan(asked(), Learning(iterations=600), np.random.default_rng(0)).lengths
    assert np.mean(lengths[-100:]) < np.mean(lengths[:100]) - 0.3


def test_one_seed_has_one_plan_and_runs_differ() -> None:
    settings = {"runs": 2, "iterations": 30}
    first, second, other = (plan_build("pla", asked(), seed=seed, settings=settings) for seed in (1, 1, 2))
    assert (first.plan, first.lengths) == (second.plan, second.lengths)
    assert first.lengths != other.lengths


def test_places_that_have_no_more_blocks_are_left_out() -> None:
    places = [place(1, 0.2, 0.2, {2: 1}), place(2, 2.0, 2.0, {2: 3})]
    planned = plan_build("pla", problem(RING, RING_BLOCKS, places), settings={"runs": 1, "iterations": 20})
    check_plan(planned.plan)
    assert sorted(step.place for step in planned.plan.steps) == [1, 2, 2, 2]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"memory": 0}, "setting memory: must be 1 to 100000 (found 0)"),
        ({"iterations": 10_000_001}, "setting iterations: must be 1 to 10000000 (found 10000001)"),
        ({"power": 6}, "setting power: must be 1 to 5 (found 6)"),
        ({"runs": 0}, "setting runs: must be 1 or more (found 0)"),
        ({"rate": -0.1}, "setting rate: must be 0 to 1 (found -0.1)"),
        ({"rate": 1e308}, "setting rate: must be 0 to 1 (found 1e+308)"),
        ({"stiffness": 10.1}, "setting stiffness: must be 0 to 10 (found 10.1)"),
        ({"bound": 101.0}, "setting bound: must be 0 to 100 (found 101.0)"),
        ({"noise": 1e308}, "setting noise: must be 0 to 10 (found 1e+308)"),
    ],
)
def test_settings_out_of_range_are_refused(settings: object, message: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        plan_build("pla", asked(), settings=settings)  # type: ignore[arg-type]
    assert str(caught.value) == message
