from __future__ import annotations

from itertools import combinations
from typing import List, Tuple

from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.labels import LabelPlacer

BOUNDS = Box(0, 0, 400, 300)


def test_placer_puts_a_lone_label_to_the_right_of_its_thing() -> None:
    placement = LabelPlacer(BOUNDS).place((100, 100), 10, (40, 12))
    assert placement is not None
    # Radius 10 and 3 pixels of air; vertically in the middle.
    assert placement.box == Box(113, 94, 153, 106)
    assert not placement.far


def test_placer_goes_to_the_left_at_the_right_edge() -> None:
    placement = LabelPlacer(BOUNDS).place((390, 100), 5, (40, 12))
    assert placement is not None
    assert placement.box.right == 390 - 8


def test_placer_keeps_off_other_things_while_there_is_room() -> None:
    neighbour = Box(115, 90, 135, 110)
    placement = LabelPlacer(BOUNDS, [neighbour]).place((100, 100), 10, (40, 12))
    assert placement is not None
    assert not placement.box.meets(neighbour)


def test_placer_gives_up_where_there_is_no_room() -> None:
    placer = LabelPlacer(Box(0, 0, 30, 30))
    assert placer.place((15, 15), 5, (40, 12)) is None
    assert placer.placed == []


@given(
    st.lists(
        st.tuples(st.integers(0, 400), st.integers(0, 300), st.integers(10, 120), st.integers(8, 16)),
        min_size=2,
        max_size=30,
    )
)
def test_placer_never_lets_labels_meet_or_leave_the_bounds(things: List[Tuple[int, int, int, int]]) -> None:
    placer = LabelPlacer(BOUNDS, [Box(x - 8, y - 8, x + 8, y + 8) for x, y, _, _ in things])
    for x, y, width, height in things:
        placer.place((x, y), 8, (width, height))
    assert all(BOUNDS.holds(box) for box in placer.placed)
    assert not any(one.meets(other) for one, other in combinations(placer.placed, 2))
