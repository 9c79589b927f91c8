"""Lengths to one goal, held against scipy's Dijkstra, on maps that change."""

from __future__ import annotations

import math
from typing import List

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.robot.navigation.distances import Distances
from tests.robot.navigation.drawings import DRAWINGS, cells, oracle


@given(DRAWINGS, st.data())
def test_distances_are_those_of_the_oracle_in_whichever_order_they_are_asked_for(
    drawing: List[str], data: st.DataObject
) -> None:
    blocked, width = cells(drawing)
    free = [cell for cell, taken in enumerate(blocked) if not taken]
    if not free:
        return
    goal = data.draw(st.sampled_from(free))
    distances, expected = Distances(blocked, width, goal), oracle(blocked, width)[goal]
    for cell in data.draw(st.permutations(range(len(blocked)))):
        assert distances.to(cell) == pytest.approx(expected[cell])


@given(DRAWINGS, st.data())
def test_distances_on_another_map_are_those_that_are_computed_afresh(drawing: List[str], data: st.DataObject) -> None:
    """To the last bit, so that a run does not hang on what was asked for before."""
    blocked, width = cells(drawing)
    free = [cell for cell, taken in enumerate(blocked) if not taken]
    inner = [cell for cell in range(width, len(blocked) - width) if 0 < cell % width < width - 1]
    if not free:
        return
    goal = data.draw(st.sampled_from(free))
    distances = Distances(blocked, width, goal)
    for _ in range(data.draw(st.integers(1, 3))):
        for cell in data.draw(st.lists(st.sampled_from(inner), max_size=4)):
            distances.to(cell)
        changed = set(data.draw(st.lists(st.sampled_from(inner), max_size=5))) - {goal}
        before, blocked = blocked, bytes(taken ^ (cell in changed) for cell, taken in enumerate(blocked))
        old, distances = distances, distances.on(blocked)
        afresh = Distances(blocked, width, goal)
        assert [old.to(cell) for cell in inner] == [Distances(before, width, goal).to(cell) for cell in inner]
        asked = data.draw(st.lists(st.sampled_from(inner), max_size=4))
        assert [distances.to(cell) for cell in asked] == [afresh.to(cell) for cell in asked]
    assert [distances.to(cell) for cell in inner] == [afresh.to(cell) for cell in inner]


def test_a_way_that_is_cut_off_has_no_length_until_it_is_open_again() -> None:
    """Of a corridor of five cells the middle one is blocked, and freed."""
    blocked, width = cells(["....."])
    barred, _ = cells(["..#.."])
    goal, far = width + 1, width + 5
    distances = Distances(blocked, width, goal)
    assert distances.to(far) == 4.0
    assert math.isinf(distances.on(barred).to(far))
    assert distances.on(barred).on(blocked).to(far) == 4.0


def test_on_an_equal_map_nothing_is_computed_again() -> None:
    blocked, width = cells(["..", ".."])
    distances = Distances(blocked, width, width + 1)
    assert distances.on(bytes(blocked)) is distances
