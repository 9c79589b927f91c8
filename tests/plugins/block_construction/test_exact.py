from __future__ import annotations

import itertools
from typing import Dict, Iterator, List, Tuple

import pytest
from block_construction.diagram.actions import actions_by_cell
from block_construction.diagram.cost import diagram_cost
from block_construction.diagram.planning import plan_diagram
from block_construction.exact.planner import EXACT
from block_construction.structure.library import library_structure
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import BlockPlacement, Structure, Voxel

pytest.importorskip("ortools", reason="OR-tools proves optima")


@pytest.mark.parametrize(
    ("name", "cost", "faults", "counts"),
    [
        ("wall", 6, 0, {1: 1, 2: 2, 3: 3}),
        ("cistern", 32, 0, {1: 0, 2: 0, 3: 32}),
        ("vertical_extension", 112, 0, {1: 0, 2: 0, 3: 112}),
        ("horizontal_extension", 160, 0, {1: 0, 2: 0, 3: 160}),
        # The source's minima; other counts of as low a cost may be found.
        ("pyramid", 46, None, None),
        ("tower", 30, None, None),
        ("dam", 19, None, None),
        ("station", 32, None, None),
        ("station_b", 32, None, None),
    ],
)
def test_optima_are_those_of_the_source(name: str, cost: int, faults: int, counts: Dict[int, int]) -> None:
    found = plan_diagram(EXACT, library_structure(name), (1, 2, 3))
    assert found.proved
    assert found.diagram.cost == cost
    if counts is not None:
        assert (len(found.diagram.faults), found.diagram.counts) == (faults, counts)


def test_one_seed_has_one_diagram() -> None:
    first, second = (plan_diagram(EXACT, library_structure("tower"), (1, 2, 3), seed=7) for _ in range(2))
    assert first.diagram == second.diagram


def _coverings(structure: Structure) -> Iterator[Tuple[BlockPlacement, ...]]:
    """Give every covering of a structure by blocks, by trying all."""
    actions = actions_by_cell(structure, (1, 2, 3))

    def extend(left: List[Voxel], chosen: Tuple[BlockPlacement, ...]) -> Iterator[Tuple[BlockPlacement, ...]]:
        if not left:
            yield chosen
            return
        for length in actions[left[0]]:
            block = BlockPlacement(*left[0], length)
            covered = set(block.cells())
            if covered <= set(left):
                yield from extend([cell for cell in left if cell not in covered], (*chosen, block))

    yield from extend(list(actions), ())


small = st.lists(st.lists(st.integers(0, 2), min_size=3, max_size=3).map(tuple), min_size=2, max_size=2).map(tuple)


@given(small.filter(lambda rows: 0 < sum(map(sum, rows)) <= 10))
@hypothesis_settings(max_examples=30)
def test_nothing_that_can_be_tried_costs_less(heights: Tuple[Tuple[int, ...], ...]) -> None:
    structure = Structure("small", heights)
    least = min(diagram_cost(each) for each in itertools.islice(_coverings(structure), 200_000))
    assert plan_diagram(EXACT, structure, (1, 2, 3)).diagram.cost == least
