"""Plans that cannot be carried out: each fault by its name, with the block at fault."""

from __future__ import annotations

from dataclasses import replace
from typing import Dict, List, Optional, Sequence, Tuple

import pytest
from block_construction.diagram.diagram import assembly_diagram
from block_construction.errors import ConstructionError
from block_construction.execution.approach import SIDES, Side
from block_construction.execution.arena import Arena
from block_construction.execution.feasibility import FaultKind, check_plan, placement_faults
from block_construction.execution.plan import BuildPlan, PlannedStep
from block_construction.execution.planners import METHODS, plan_build
from block_construction.execution.problem import BuildProblem
from block_construction.structure.layers import layer_of

from rqt_mrta_py.hooks import BlockPlacement, Structure
from tests.plugins.block_construction.builds import RING, RING_BLOCKS, place, problem

pytest.importorskip("scipy", reason="SciPy finds ways")

BELOW, ABOVE, LEFT, RIGHT = SIDES
ROW = [(1, 1, 1, 2), (1, 2, 1, 2), (1, 3, 1, 2)]
"""Three blocks side by side, in two columns and three rows."""
ROWS = [[1, 1], [1, 1], [1, 1]]


def plan_of(asked: BuildProblem, steps: Sequence[Tuple[int, int, Side]]) -> BuildPlan:
    planned = tuple(PlannedStep(place, block, side, 0.0, 0.0) for place, block, side in steps)
    return BuildPlan("by hand", asked.diagram, asked.arena, asked.places, planned)


def faults(asked: BuildProblem, steps: Sequence[Tuple[int, int, Side]]) -> List[Tuple[FaultKind, int, int]]:
    return [each[:3] for each in placement_faults(plan_of(asked, steps))]


GOOD = [(1, 1, BELOW), (1, 2, RIGHT), (1, 3, LEFT), (1, 4, ABOVE)]


def test_a_plan_that_can_be_carried_out_has_no_fault() -> None:
    asked = problem(RING, RING_BLOCKS)
    assert [(each.placement.x, each.placement.y, each.placement.length) for each in asked.diagram.blocks] == [
        (1, 1, 2),
        (3, 1, -2),
        (1, 2, -2),
        (2, 3, 2),
    ]
    assert faults(asked, GOOD) == []


@pytest.mark.parametrize(
    ("steps", "found"),
    [
        ([*GOOD, (1, 4, ABOVE)], (FaultKind.PLACED_TWICE, 5, 4)),
        ([*GOOD, (1, 9, ABOVE)], (FaultKind.UNKNOWN, 5, 9)),
        ([*GOOD[:3], (9, 4, ABOVE)], (FaultKind.UNKNOWN, 4, 4)),
        (GOOD[:3], (FaultKind.LEFT_OUT, 0, 4)),
        ([(1, 1, LEFT), *GOOD[1:]], (FaultKind.GRIPPER_NOT_PARALLEL, 1, 1)),
        ([*GOOD[:3], (1, 4, RIGHT)], (FaultKind.GRIPPER_NOT_PARALLEL, 4, 4)),
    ],
)
def test_steps_that_make_no_sense_are_named(
    steps: Sequence[Tuple[int, int, Side]], found: Tuple[FaultKind, int, int]
) -> None:
    assert found in faults(problem(RING, RING_BLOCKS), steps)


def test_a_block_between_two_others_is_surrounded() -> None:
    """Figure 36 a: the middle one must come before one of its neighbours."""
    # The middle row is a layer of its own, and would be built first.
    assert layer_of(1, 2, 2, 3) == 1
    asked = problem(ROWS, ROW)
    plan = plan_of(asked, [(1, 1, BELOW), (1, 3, ABOVE), (1, 2, BELOW)])
    (fault,) = [each for each in placement_faults(plan) if each.kind is FaultKind.SLOT_SURROUNDED]
    assert fault.text == (
        "slot_surrounded: step 3, block 2 at x 1, y 2, level 1: blocks 1 and 3 lie on both sides of its slot already"
    )
    assert faults(asked, [(1, 1, BELOW), (1, 2, ABOVE), (1, 3, ABOVE)]) == []


def test_a_block_that_comes_over_another_is_blocked_and_from_the_other_side_is_not() -> None:
    """Figure 36 b: the block from above would touch the one that lies there."""
    asked = problem(ROWS, ROW)
    steps = [(1, 1, BELOW), (1, 2, BELOW), (1, 3, ABOVE)]
    plan = plan_of(asked, steps)
    with pytest.raises(ConstructionError) as caught:
        check_plan(plan)
    assert str(caught.value) == (
        "corridor_blocked: step 2, block 2 at x 1, y 2, level 1: block 1 lies in the way of the carried block"
    )
    check_plan(replace(plan, steps=(plan.steps[0], plan.steps[1]._replace(side=ABOVE), plan.steps[2])))


def test_lower_blocks_are_in_nobodys_way_until_the_robot_touches_them() -> None:
    """The carried block passes above one row of 8 cm; of two rows the second would be under the robot, 0.18 m wide."""
    asked = problem([[1, 1], [2, 2]], [*ROW[:2], (1, 2, 2, 2)])
    assert faults(asked, [(1, 1, BELOW), (1, 2, ABOVE), (1, 3, BELOW)]) == []
    deep = problem([[1, 1], [1, 1], [2, 2]], [*ROW, (1, 3, 2, 2)])
    steps = [(1, 1, BELOW), (1, 2, ABOVE), (1, 3, ABOVE)]
    assert faults(deep, [*steps, (1, 4, BELOW)]) == [(FaultKind.CORRIDOR_BLOCKED, 4, 4)]
    assert faults(deep, [*steps, (1, 4, ABOVE)]) == []


def test_a_block_without_one_below_is_unsupported() -> None:
    asked = problem([[2, 1]], [(1, 1, 1, 2), (1, 1, 2, 1)])
    assert faults(asked, [(1, 2, BELOW), (1, 1, BELOW)])[0] == (FaultKind.UNSUPPORTED, 1, 2)


def test_a_place_with_other_blocks_is_named_by_what_would_go_wrong() -> None:
    """Figures 35 d and e."""
    stocks: List[Dict[int, Optional[int]]] = [{2: None}, {3: None}, {1: None}, {2: 1}]
    places = [
        place(number, x, y, stock)
        for number, ((x, y), stock) in enumerate(zip(((0.2, 0.2), (2.0, 0.2), (0.2, 2.0), (2.0, 2.0)), stocks), 1)
    ]
    asked = problem(RING, RING_BLOCKS, places)
    found = faults(asked, [(2, 1, BELOW), (3, 2, RIGHT), (4, 3, LEFT), (4, 4, ABOVE)])
    assert found == [
        (FaultKind.BLOCK_TOO_LARGE, 1, 1),
        (FaultKind.BLOCK_TOO_SMALL, 2, 2),
        (FaultKind.SUPPLY_EMPTY, 4, 4),
    ]


def test_a_ring_close_around_a_slot_leaves_the_robot_no_room() -> None:
    """Nine cells a side: from 0.30 m off the middle, the ring is nearer than the robot's 0.18 m."""
    side = 9
    edge = (0, side - 1)
    heights = [[int(x in edge or y in edge or x == y == side // 2) for x in range(side)] for y in range(side)]
    blocks = [(x, y, 1, 3) for y in (1, side) for x in (1, 4, 7)]
    blocks += [(x, y, 1, -length) for x in (1, side) for y, length in ((2, 3), (5, 3), (8, 1))]
    blocks = [each if each[3] != -1 else (*each[:3], 1) for each in blocks]
    asked = problem(heights, [*blocks, (5, 5, 1, 1)])
    inner = next(block.number for block in asked.diagram.blocks if block.layer > 1)
    # From the innermost layer out all is well.
    assert plan_build("greedy", asked).plan.steps[0].block == inner
    last = [(step.place, step.block, step.side) for step in plan_build("greedy", asked).plan.steps]
    found = faults(asked, [*last[1:], last[0]])
    assert [each[:1] + each[2:] for each in found] == [(FaultKind.CORRIDOR_BLOCKED, inner)]


def test_a_court_that_is_shut_leaves_no_path() -> None:
    """The court is 1.04 m wide: there is room to stand 0.30 m off its middle, but no way in once the ring is whole."""
    side = range(1, 16)
    ring = [(x, y, 1, 1) for y in side for x in side if {x, y} & {1, 15}]
    cells = [*ring, (8, 8, 1, 1)]
    heights = tuple(tuple(int((x, y, 1, 1) in cells) for x in side) for y in side)
    diagram = assembly_diagram(Structure("court", heights), (1,), [BlockPlacement(*each) for each in cells])
    asked = BuildProblem(diagram, [place(1, 0.2, 0.2, {1: None})], Arena(side=3.0))
    inner = next(block.number for block in diagram.blocks if block.layer > 1)
    outer = [block.number for block in diagram.blocks if block.number != inner]
    plan = plan_of(asked, [(1, number, asked.approaches[number - 1].side) for number in (*outer, inner)])
    (fault,) = placement_faults(plan)
    assert fault[:3] == (FaultKind.NO_PATH, 57, inner)
    assert fault.text.endswith("there is no way to it from supply place 1")
    first = plan_of(asked, [(1, number, asked.approaches[number - 1].side) for number in (inner, *outer)])
    assert list(placement_faults(first)) == []


def test_level_first_takes_another_heading_or_refuses_by_name() -> None:
    """Three rings below a tower of one cell: the robot can come near from no side any more once they lie."""
    assert plan_build("exact", problem([[1, 1, 1], [1, 2, 1], [1, 1, 1]], _filled(3), level_first=True)).plan.steps
    heights = [[2 if x == y == 3 else 1 for x in range(7)] for y in range(7)]
    with pytest.raises(ConstructionError) as caught:
        problem(heights, _filled(7), level_first=True)
    assert str(caught.value).startswith("corridor_blocked: block 50 at x 4, y 4, level 2 of small: ")
    assert problem(heights, _filled(7)).groups[0] == (49,)


def _filled(side: int) -> List[Tuple[int, int, int, int]]:
    """Cover a square by single blocks, with one more in its middle on top."""
    blocks = [(x, y, 1, 1) for y in range(1, side + 1) for x in range(1, side + 1)]
    return [*blocks, (side // 2 + 1, side // 2 + 1, 2, 1)]


@pytest.mark.parametrize("method", sorted(METHODS))
def test_no_method_places_a_block_in_the_way_of_another_of_its_group(method: str) -> None:
    """Of two blocks side by side the inner one is placed from the left, past where the outer one will lie."""
    asked = problem([[1, 1, 0], [1, 1, 1]], [(1, 1, 1, -2), (2, 1, 1, -2), (3, 2, 1, 1)])
    assert [approach.side for approach in asked.approaches] == [LEFT, LEFT, ABOVE]
    assert asked.before == {1: {2}, 2: set(), 3: set()}
    planned = plan_build(method, asked, settings={"runs": 1, "iterations": 10} if method == "pla" else {})
    assert list(placement_faults(planned.plan)) == []


@pytest.mark.parametrize("method", sorted(METHODS))
def test_blocks_in_each_others_way_are_refused_by_every_method(method: str) -> None:
    """Two rows of a square of two: each is placed past where the other will lie."""
    asked = problem([[1, 1], [1, 1]], [(1, 1, 1, 2), (1, 2, 1, 2)])
    across = asked.approaches
    asked.approaches = (across[1]._replace(side=ABOVE), across[0]._replace(side=BELOW))
    with pytest.raises(ConstructionError) as caught:
        plan_build(method, asked)
    assert str(caught.value) == (
        "corridor_blocked: block 1 at x 1, y 1, level 1 of small: would have to come after 2, and they after it"
    )


@pytest.mark.parametrize("method", sorted(METHODS))
def test_every_methods_plan_can_be_carried_out(method: str) -> None:
    asked = problem([[2, 2, 2], [1, 0, 1], [1, 1, 1]], [*RING_BLOCKS, (1, 1, 2, 3)])
    planned = plan_build(method, asked, settings={"iterations": 10} if method == "pla" else {})
    assert list(placement_faults(planned.plan)) == []
    assert planned.proved is (method == "exact")
