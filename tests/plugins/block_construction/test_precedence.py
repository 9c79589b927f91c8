"""What must lie before a block is placed: by hand, and every order that respects it can be carried out."""

from __future__ import annotations

import math
import random
from typing import Dict, FrozenSet, List, Sequence, Set, Tuple

import pytest
from block_construction.diagram.diagram import assembly_diagram
from block_construction.errors import ConstructionError
from block_construction.execution.arena import Arena
from block_construction.execution.feasibility import placement_faults
from block_construction.execution.plan import BuildPlan, PlannedStep
from block_construction.execution.planners import METHODS, plan_build
from block_construction.execution.problem import BuildProblem
from block_construction.execution.supply import SupplyPlace
from block_construction.mission.precedence import precedence
from block_construction.structure.layers import layer_of
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import BlockPlacement, Structure
from tests.plugins.block_construction.builds import ARENA, CORNERS, RING, RING_BLOCKS, place, problem

pytest.importorskip("scipy", reason="SciPy finds ways")

Cell = Tuple[int, int, int]


def before(asked: BuildProblem) -> Dict[int, Set[int]]:
    return {number: set(others) for number, others in precedence(asked).items()}


def test_blocks_of_a_ring_that_are_placed_from_outside_are_free() -> None:
    assert before(problem(RING, RING_BLOCKS)) == {1: set(), 2: set(), 3: set(), 4: set()}


def test_a_block_comes_after_what_it_lies_on_and_not_after_what_that_lies_on() -> None:
    asked = problem([[3, 1]], [(1, 1, 1, 2), (1, 1, 2, 1), (1, 1, 3, 1)])
    assert before(asked) == {1: set(), 2: {1}, 3: {2}}


def test_a_block_comes_before_what_would_close_its_corridor() -> None:
    """Three blocks along x side by side; the middle one is placed from below, past where the first will lie."""
    asked = problem([[1, 1]] * 3, [(1, 1, 1, 2), (1, 2, 1, 2), (1, 3, 1, 2)])
    assert [approach.side.heading_deg for approach in asked.approaches] == [90, 90, 270]
    assert before(asked) == {1: {2}, 2: set(), 3: set()}


def test_a_block_within_comes_before_what_the_robot_would_run_into_there() -> None:
    """A column of two levels in the middle of a square of 7 x 7 cells that is one level high all around.

    The robot's centre comes to 0.30 m from the column's middle and its radius is 0.18 m, so that cells whose nearest
    side is 0.12 m or farther away there, the second and third in front, must be empty, though they are lower.
    """
    heights = [[1] * 7 for _ in range(7)]
    heights[3][3] = 2
    cells = [(x, y, 1, 1) for y in range(1, 8) for x in range(1, 8)]
    asked = problem(heights, [*cells, (4, 4, 2, 1)])
    assert asked.approaches[-1].side.heading_deg == 90
    found = before(asked)
    number_at = {
        (block.placement.x, block.placement.y, block.placement.z): block.number for block in asked.diagram.blocks
    }
    top = number_at[4, 4, 2]

    def after_top(cell: Cell) -> bool:
        pending, seen = [number_at[cell]], set()
        while pending:
            one = pending.pop()
            if one not in seen:
                seen.add(one)
                pending += found[one]
        return top in seen

    assert [after_top((4, y, 1)) for y in (1, 2, 3)] == [True, True, False]
    assert not after_top((4, 7, 1))


def test_a_block_in_a_court_comes_before_the_ring_that_would_shut_it_in() -> None:
    """The court is 1.04 m wide: the robot has room to stand in it, but no way in once the ring is whole."""
    side = range(1, 16)
    ring = [(x, y, 1, 1) for y in side for x in side if {x, y} & {1, 15}]
    heights = [[int(bool({x, y} & {1, 15})) for x in side] for y in side]
    heights[7][7] = 1
    structure = Structure("court", tuple(map(tuple, heights)))
    diagram = assembly_diagram(structure, (1,), [BlockPlacement(*each) for each in (*ring, (8, 8, 1, 1))])
    corner = SupplyPlace(1, 0.2, 0.2, -0.75 * math.pi, {1: None})
    found = before(BuildProblem(diagram, [corner], Arena(side=3.0)))
    (first,) = [number for number, others in found.items() if not others]
    assert [others for number, others in found.items() if number != first] == [{first}] * 56


def test_an_order_that_there_is_not_is_refused_with_a_block() -> None:
    """Side by side, the middle ones of four rows: each would have to be placed before the other."""
    asked = problem([[1, 1]] * 3, [(1, 1, 1, 2), (1, 2, 1, 2), (1, 3, 1, 2)])
    above = asked.approaches[2]
    # Placed from above, the first block passes over where the others lie.
    asked.approaches = (above, asked.approaches[1], above)
    with pytest.raises(
        ConstructionError, match=r"^corridor_blocked: block 1 at x 1, y 1, level 1 of small: would have"
    ):
        precedence(asked)


@st.composite
def builds(draw: st.DrawFn) -> BuildProblem:
    """Draw a small structure, covered by blocks at random, from places at random."""
    columns, rows = draw(st.integers(1, 5)), draw(st.integers(1, 5))
    heights = draw(
        st.lists(st.lists(st.integers(0, 3), min_size=columns, max_size=columns), min_size=rows, max_size=rows)
    )
    assume(any(height for row in heights for height in row))
    chance = random.Random(draw(st.integers(0, 2**32)))
    structure = Structure("drawn", tuple(map(tuple, heights)))
    diagram = assembly_diagram(structure, (1, 2, 3), covered(structure, chance))
    places = [place(number, x, y, {1: None, 2: None, 3: None}) for number, (x, y) in enumerate(CORNERS, 1)]
    try:
        return BuildProblem(diagram, places, ARENA)
    except ConstructionError:
        assume(condition=False)
        raise


def covered(structure: Structure, chance: random.Random) -> List[BlockPlacement]:
    taken: Set[Cell] = set()
    found = []
    for z in range(1, structure.levels + 1):
        for y in range(1, structure.rows + 1):
            for x in range(1, structure.columns + 1):
                lengths = [length for length in (1, 2, 3, -2, -3) if fits(structure, (x, y, z), length, taken)]
                if lengths:
                    found.append(BlockPlacement(x, y, z, chance.choice(lengths)))
                    taken.update((cell.x, cell.y, cell.z) for cell in found[-1].cells())
    return found


def fits(structure: Structure, first: Cell, length: int, taken: Set[Cell]) -> bool:
    cells = list(BlockPlacement(*first, length).cells())
    layers = {layer_of(cell.x, cell.y, structure.columns, structure.rows) for cell in cells}
    free = all(structure.is_filled(*cell) and (cell.x, cell.y, cell.z) not in taken for cell in cells)
    return free and len(layers) == 1


def any_order(constraints: Dict[int, FrozenSet[int]], chance: random.Random) -> Sequence[int]:
    order: List[int] = []
    while len(order) < len(constraints):
        ready = [number for number, others in constraints.items() if number not in order and others <= set(order)]
        order.append(chance.choice(ready))
    return order


@settings(max_examples=60)
@given(asked=builds(), seed=st.integers(0, 2**32))
def test_every_order_that_respects_it_can_be_carried_out(asked: BuildProblem, seed: int) -> None:
    try:
        constraints = dict(precedence(asked))
    except ConstructionError:
        assume(condition=False)
        return
    chance = random.Random(seed)
    steps = tuple(
        PlannedStep(chance.randint(1, 4), number, asked.approaches[number - 1].side, 0.0, 0.0)
        for number in any_order(constraints, chance)
    )
    plan = BuildPlan("any", asked.diagram, asked.arena, asked.places, steps)
    assert list(placement_faults(plan)) == []


@settings(max_examples=60)
@given(asked=builds())
def test_every_method_plans_what_can_be_built_and_exact_the_shortest(asked: BuildProblem) -> None:
    assume(max(map(len, asked.groups)) <= 8)
    try:
        precedence(asked)
    except ConstructionError:
        assume(condition=False)
    few = {"pla": {"runs": 1, "iterations": 5}}
    planned = [plan_build(method, asked, settings=few.get(method)).plan for method in sorted(METHODS)]
    assert [list(placement_faults(plan)) for plan in planned] == [[]] * len(METHODS)
    shortest = plan_build("exact", asked).plan.cost.total
    assert min(plan.cost.total for plan in planned) >= shortest - 1e-9
