"""Ways, costs and plans on builds so small that they can be reckoned by hand or by trying everything."""

from __future__ import annotations

import itertools
import math
from typing import Iterator, List, Tuple

import numpy as np
import pytest
from block_construction.diagram.diagram import assembly_diagram
from block_construction.errors import ConstructionError
from block_construction.execution.approach import sides_of
from block_construction.execution.arena import Arena, Point, site_of
from block_construction.execution.cost import plan_cost
from block_construction.execution.greedy import plan_greedily
from block_construction.execution.local_search import plan_locally
from block_construction.execution.order import build_groups
from block_construction.execution.problem import BuildProblem, Step
from block_construction.execution.subset_programme import plan_exactly
from block_construction.execution.supply import SupplyPlace, corner_places, stand_point
from block_construction.execution.ways import Ground, Ways
from block_construction.structure.library import library_structure
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import BlockPlacement, Structure
from tests.plugins.block_construction.builds import ARENA, CORNERS, RING, RING_BLOCKS, place, problem

pytest.importorskip("scipy", reason="SciPy finds ways")


def test_the_structure_stands_in_the_middle() -> None:
    """Seven cells of 8 cm make 56 cm, half of it on each side of 1.10 m."""
    site = site_of(ARENA, library_structure("cistern"))
    assert site == pytest.approx((0.82, 0.82, 1.38, 1.38))


def test_a_structure_without_room_around_it_is_refused() -> None:
    """31 cells are 2.48 m; 0.26 m to where the robot stands and its radius of 0.18 m come on both sides."""
    with pytest.raises(ConstructionError, match=r"measures 2\.48 m x 2\.48 m; the robot needs an arena of 3\.36 m"):
        site_of(ARENA, library_structure("horizontal_extension"))


def test_the_first_voxel_without_room_is_named() -> None:
    """Of 2.2 m, 0.44 m on both sides are the robot's: 1.32 m are left, which are 16 cells."""
    assert site_of(ARENA, Structure("row", ((1,) * 16,))).left == pytest.approx(0.46)
    rows = ((0,) * 17, (1,) * 17)
    with pytest.raises(ConstructionError, match=r"; voxel x 17, y 2, level 1 is beyond the 16 cells a side that have"):
        site_of(ARENA, Structure("row", rows))


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"side": math.nan}, "arena: side: must be finite and above 0 m (found nan)"),
        ({"cell": 0.0}, "arena: cell: must be finite and above 0 m (found 0.0)"),
        ({"cell": 0.001}, "arena: cell: 0.001 m for a side of 2.2 m; 2 to 400 cells a side are accepted"),
        ({"start": (0.1, 1.0)}, "arena: start: (0.1, 1) m is nearer than 0.18 m to a wall"),
    ],
)
def test_arenas_that_make_no_sense_are_refused(values: object, message: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        Arena(**values)  # type: ignore[arg-type]
    assert str(caught.value).startswith(message)


def test_robots_fetch_from_30_cm_before_a_place_by_its_heading() -> None:
    """Out from the middle, along the diagonal, that is 0.3 m / sqrt 2 in both directions."""
    assert stand_point(ARENA, place(1, 0.2, 0.2, {1: None})) == pytest.approx((0.4121, 0.4121), abs=1e-4)
    assert stand_point(ARENA, place(1, 1.1, 2.0, {1: None})) == pytest.approx((1.1, 1.7))
    assert stand_point(ARENA, SupplyPlace(1, 0.6, 0.2, 0.0, {1: None})) == pytest.approx((0.3, 0.2))


def test_a_place_whose_heading_puts_the_robot_into_a_wall_is_refused() -> None:
    with pytest.raises(ConstructionError) as caught:
        problem(RING, RING_BLOCKS, [SupplyPlace(1, 0.2, 0.2, 0.0, {2: None})])
    assert str(caught.value) == (
        "supply place 1 at (0.2, 0.2) m: a robot would fetch from (-0.1, 0.2) m, nearer than 0.18 m to a wall"
    )


def test_corner_places_face_outward() -> None:
    places = corner_places(ARENA, [(2,), (1,), (3,), (3,)])
    assert [(each.x, each.y) for each in places] == [pytest.approx(corner) for corner in CORNERS]
    assert [round(math.degrees(each.yaw)) for each in places] == [-135, -45, 135, 45]


@pytest.mark.parametrize(
    ("cell", "headings"),
    [
        ((1, 1, 1, 2), [90, 270]),  # along x on the lower edge: from below, looking up
        ((2, 3, 1, 2), [270, 90]),
        ((3, 1, 1, -2), [180, 0]),
        ((1, 2, 1, -2), [0, 180]),
    ],
)
def test_blocks_are_placed_across_their_longer_side_from_outside_first(
    cell: Tuple[int, int, int, int], headings: List[int]
) -> None:
    asked = problem(RING, RING_BLOCKS)
    block = next(each for each in asked.diagram.blocks if each.placement == BlockPlacement(*cell))
    assert [side.heading_deg for side in sides_of(block, asked.diagram.structure)] == headings


def test_a_single_unit_in_a_corner_is_placed_from_both_outer_sides_first() -> None:
    asked = problem([[1, 1]], [(1, 1, 1, 1), (2, 1, 1, 1)])
    headings = [
        [side.heading_deg for side in sides_of(block, asked.diagram.structure)] for block in asked.diagram.blocks
    ]
    assert headings == [[90, 270, 0, 180], [90, 270, 180, 0]]


def test_groups_go_from_the_innermost_layer_out_and_up_within_it() -> None:
    heights = [[1, 1, 1], [1, 2, 1], [1, 1, 1]]
    blocks = [(1, 1, 1, 3), (1, 2, 1, 1), (2, 2, 1, 1), (3, 2, 1, 1), (1, 3, 1, 3), (2, 2, 2, 1)]
    diagram = problem(heights, blocks).diagram
    inner, outer = (5, 6), (1, 2, 3, 4)
    assert [each.placement.z for each in diagram.blocks] == [1, 1, 1, 1, 1, 2]
    assert build_groups(diagram) == ((inner[0],), (inner[1],), outer)
    assert build_groups(diagram, level_first=True) == ((inner[0],), outer, (inner[1],))


def test_straight_and_diagonal_ways_are_as_long_as_they_are() -> None:
    """Ten cells along an axis are 0.4 m, ten across 0.4 sqrt 2 m; both together are what takes 20 and 10 cells."""
    structure = Structure("one", ((1,),))
    site = site_of(ARENA, structure)
    middle = Point(0.5, 0.5)
    goals = [Point(0.9, 0.5), Point(0.9, 0.9), Point(1.3, 0.9)]
    ways = Ways(Ground(ARENA, site, 1), 0.04, [middle], goals)
    straight, across = 0.4, 0.4 * math.sqrt(2.0)
    assert ways.lengths(0)[0] == pytest.approx([straight, across, straight + across])


def test_a_placed_block_is_gone_around_at_the_robots_radius() -> None:
    """From left to right of one cell in the middle: the ways touch the circle of 0.18 m around its corners."""
    site = site_of(ARENA, Structure("one", ((1,),)))
    ways = Ways(Ground(ARENA, site, 1), 0.04, [Point(0.7, 1.1)], [Point(1.5, 1.1), Point(1.1, 1.1)])
    free, around = float(ways.lengths(0)[0, 0]), float(ways.lengths(1)[0, 0])
    assert free == pytest.approx(0.8)
    # Up 0.22 m or more (0.04 and 0.18) by diagonal moves: six cells up and six down.
    assert around == pytest.approx(0.8 + 12 * 0.04 * (math.sqrt(2.0) - 1.0))
    assert math.isinf(ways.lengths(1)[0, 1])
    path = ways.path(1, 0, 0)
    assert (path[0], path[-1]) == (pytest.approx((0.7, 1.1)), pytest.approx((1.5, 1.1)))
    assert sum(math.hypot(b.x - a.x, b.y - a.y) for a, b in zip(path, path[1:])) == pytest.approx(around)
    assert ways.path(1, 0, 1) == ()


def test_two_blocks_cost_the_ways_there_and_back() -> None:
    """Two single blocks side by side, placed from below; one place straight below the left one's corridor.

    All is in the column of cells around x = 1.06 and 1.14, so ways are straight but for one or two diagonal steps.
    """
    below = [place(1, 1.06, 0.25, {1: None})]
    asked = problem([[1, 1]], [(1, 1, 1, 1), (2, 1, 1, 1)], below)
    # Blocks stand at (1.06, 1.10) and (1.14, 1.10); the robot at y = 0.80, of two cells as near the lower: 0.78.
    assert [each.point for each in asked.approaches] == [pytest.approx((1.06, 0.8)), pytest.approx((1.14, 0.8))]
    # It fetches at (1.073, 0.55), the cell around (1.06, 0.54), and starts at (1.10, 0.20), that around (1.10, 0.18).
    start, near = 8 * 0.04 + 0.04 * math.sqrt(2.0), 6 * 0.04
    far = 4 * 0.04 + 2 * 0.04 * math.sqrt(2.0)
    left_first = plan_cost(asked, [Step(1, 1), Step(1, 2)])
    assert left_first.fetching == pytest.approx(start + near)
    assert left_first.placing == pytest.approx(near + far)
    right_first = plan_cost(asked, [Step(1, 2), Step(1, 1)])
    assert right_first.total == pytest.approx(start + far + far + near)
    assert [step.block for step in plan_exactly(asked)] == [1, 2]


def orders(asked: BuildProblem) -> Iterator[List[int]]:
    """Give every order that keeps to the groups."""
    for parts in itertools.product(*(itertools.permutations(group) for group in asked.groups)):
        yield [number for part in parts for number in part]


def shortest(asked: BuildProblem) -> float:
    """Try every order with every choice of places."""
    least = math.inf
    for order in orders(asked):
        for places in itertools.product(*(asked.holding(block).tolist() for block in order)):
            steps = [Step(place + 1, block) for place, block in zip(places, order)]
            least = min(least, plan_cost(asked, steps).total)
    return least


ONE_TYPE = [place(1, 0.2, 0.2, {2: None}), place(2, 2.0, 0.2, {1: None}), place(3, 0.2, 2.0, {3: None, 2: None})]


@pytest.mark.parametrize(
    ("heights", "blocks"),
    [
        (RING, RING_BLOCKS),
        ([[2, 1, 1], [0, 0, 1]], [(1, 1, 1, 2), (3, 1, 1, -2), (1, 1, 2, 1)]),
        ([[1, 2, 2, 1]], [(1, 1, 1, 2), (3, 1, 1, 2), (2, 1, 2, 2)]),
    ],
)
def test_the_exact_plan_is_as_short_as_the_best_of_all(
    heights: List[List[int]], blocks: List[Tuple[int, int, int, int]]
) -> None:
    asked = problem(heights, blocks, ONE_TYPE)
    least = shortest(asked)
    assert plan_cost(asked, plan_exactly(asked)).total == pytest.approx(least)
    assert plan_cost(asked, plan_locally(asked, beam=64)).total == pytest.approx(least)
    assert plan_cost(asked, plan_greedily(asked)).total >= least - 1e-9


@st.composite
def walls(draw: st.DrawFn) -> BuildProblem:
    """Give a straight wall of up to six blocks on up to two levels, with one to four places."""
    lengths = draw(st.lists(st.integers(1, 3), min_size=1, max_size=4))
    blocks, x = [], 1
    for length in lengths:
        blocks.append((x, 1, 1, length))
        x += length
    upper = min(draw(st.integers(0, 2)), x - 1)
    heights = [[1 + (column < upper) for column in range(x - 1)]]
    if upper:
        blocks.append((1, 1, 2, upper))
    stocks = draw(st.lists(st.sets(st.integers(1, 3)), min_size=3, max_size=3))
    places = [
        place(number, *CORNERS[number - 1], dict.fromkeys(sorted(stock) or [1]))
        for number, stock in enumerate(stocks, 1)
    ]
    places.append(place(4, *CORNERS[3], {1: None, 2: None, 3: None}))
    return problem(heights, blocks, places)


@hypothesis_settings(max_examples=25)
@given(walls())
def test_every_plan_is_a_permutation_by_groups_and_exact_is_the_shortest(asked: BuildProblem) -> None:
    plans = {"exact": plan_exactly(asked), "greedy": plan_greedily(asked), "local": plan_locally(asked, beam=2)}
    least = plan_cost(asked, plans["exact"]).total
    for steps in plans.values():
        built = iter(steps)
        for group in asked.groups:
            assert sorted(next(built).block for _ in group) == sorted(group)
        assert next(built, None) is None
        assert all(step.place - 1 in asked.holding(step.block) for step in steps)
        assert plan_cost(asked, steps).total >= least - 1e-9


def test_groups_that_are_too_large_are_refused_by_name() -> None:
    count = 16
    heights = [[1] * count]
    asked = problem(heights, [(x, 1, 1, 1) for x in range(1, count + 1)])
    with pytest.raises(
        ConstructionError, match="layer 1 on level 1 has 16 blocks; up to 15 are accepted; take the method local"
    ):
        plan_exactly(asked)


def test_methods_do_not_take_more_than_there_is() -> None:
    """The near place has one block, so the second comes from the far one."""
    places = [place(1, 1.1, 0.2, {1: 1}), place(2, 0.2, 2.0, {1: None})]
    asked = problem([[1, 1]], [(1, 1, 1, 1), (2, 1, 1, 1)], places)
    assert [step.place for step in plan_greedily(asked)] == [1, 2]
    assert sorted(step.place for step in plan_locally(asked, beam=8)) == [1, 2]
    with pytest.raises(
        ConstructionError, match="exact: the shortest plan takes 2 blocks of 1 units from supply place 1"
    ):
        plan_exactly(asked)


def test_a_mirrored_structure_has_a_plan_as_long() -> None:
    """Its places and the start are mirrored with it."""
    places = [place(1, 0.2, 0.2, {2: None}), place(2, 2.0, 2.0, {2: None})]
    mirrored = [place(1, 2.0, 0.2, {2: None}), place(2, 0.2, 2.0, {2: None})]
    one = problem([[1, 1, 1], [0, 0, 1]], [(1, 1, 1, 2), (3, 1, 1, -2)], places)
    other = problem([[1, 1, 1], [1, 0, 0]], [(2, 1, 1, 2), (1, 1, 1, -2)], mirrored)
    assert plan_cost(one, plan_exactly(one)).total == pytest.approx(plan_cost(other, plan_exactly(other)).total)


def test_a_diagram_needs_enough_blocks_of_each_length() -> None:
    places = [place(1, 0.2, 0.2, {2: 3}), place(2, 2.0, 0.2, {1: 9})]
    with pytest.raises(ConstructionError) as caught:
        problem(RING, RING_BLOCKS, places)
    assert str(caught.value) == (
        "small: 4 blocks of 2 units are needed, and there are 3 in the supply; "
        "block 4 is the first that would be missing"
    )


@pytest.mark.parametrize(
    ("x", "y", "message"),
    [
        (
            1.1,
            1.1,
            "supply place 1 at (1.1, 1.1) m: lies inside the site, which reaches from (0.98, 0.98) to (1.22, 1.22) m",
        ),
        (1.1, 0.88, "supply place 1 at (1.1, 0.88) m: lies 0.1 m from the site"),
        (
            1.1,
            0.55,
            "supply place 1 at (1.1, 0.55) m: a robot would fetch from (1.1, 0.85) m, nearer than 0.18 m to the site",
        ),
        (2.3, 0.2, "supply place 1 at (2.3, 0.2) m: lies outside of the arena, which measures 2.2 m"),
    ],
)
def test_supply_places_in_the_way_are_refused_by_name(x: float, y: float, message: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        problem(RING, RING_BLOCKS, [place(1, x, y, {2: None})])
    assert str(caught.value).startswith(message)


def test_lengths_that_were_measured_cannot_be_changed() -> None:
    lengths = problem(RING, RING_BLOCKS).ways.lengths(0)
    with pytest.raises(ValueError, match="read-only"):
        lengths[0, 0] = np.inf


def test_a_diagram_in_another_order_has_the_same_groups() -> None:
    structure = Structure("small", tuple(map(tuple, RING)))
    one, other = (
        assembly_diagram(structure, (1, 2), [BlockPlacement(*each) for each in blocks])
        for blocks in (RING_BLOCKS, RING_BLOCKS[::-1])
    )
    assert build_groups(one) == build_groups(other) == ((1, 2, 3, 4),)
