"""Occupied cells as boxes."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.model import Obstacle, Pose
from rqt_mrta_py.robot.mapping.boxes import boxes


def cells(*rows: str) -> np.ndarray:
    """Give a grid in which # is occupied, the first row lowest."""
    return np.array([[cell == "#" for cell in row] for row in rows], dtype=np.bool_)


def test_a_block_of_cells_is_one_box() -> None:
    """Columns 1 to 3 and rows 0 and 1 of 0.5 m, from the corner (-1, 2)."""
    found = boxes(cells(".###", ".###", "...."), -1.0, 2.0, 0.5, 0.3)
    assert found == (Obstacle("seen0", Pose(0.25, 2.5), (1.5, 1.0, 0.3)),)


def test_pieces_that_differ_from_row_to_row_are_boxes_of_their_own() -> None:
    found = boxes(cells("##.", "#..", "#.#"), 0.0, 0.0, 1.0, 1.0)
    assert [(box.pose.x, box.pose.y, box.size) for box in found] == [
        (1.0, 0.5, (2.0, 1.0, 1.0)),
        (0.5, 2.0, (1.0, 2.0, 1.0)),
        (2.5, 2.5, (1.0, 1.0, 1.0)),
    ]


def test_no_cells_are_no_boxes() -> None:
    assert boxes(cells("...", "..."), 0.0, 0.0, 1.0, 1.0) == ()


@given(st.lists(st.text(".#", min_size=5, max_size=5), min_size=1, max_size=6))
def test_boxes_cover_the_occupied_cells_once_each_and_no_other(rows: list) -> None:
    occupied = cells(*rows)
    covered = np.zeros(occupied.shape, dtype=int)
    for box in boxes(occupied, 0.0, 0.0, 1.0, 1.0):
        left, low = round(box.pose.x - box.size[0] / 2), round(box.pose.y - box.size[1] / 2)
        covered[low : low + round(box.size[1]), left : left + round(box.size[0])] += 1
    assert covered.tolist() == occupied.astype(int).tolist()
