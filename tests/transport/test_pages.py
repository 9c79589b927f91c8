"""What is written column by column lies together, and is read for all messages at once where that is possible."""

from __future__ import annotations

import math
import struct

import numpy as np
import pytest

from rqt_mrta_py.transport import RosCodec
from tests.transport.support import lookup

CODEC = RosCodec(lookup)


def test_plain_numbers_are_read_for_all_messages_at_once() -> None:
    columns = {"header/frame_id": ("a", "b"), "ranges": np.array([[0.5, 0.1], [np.inf, 2.0]]), "angle_min": 0.25}
    for _ in range(2):
        page = CODEC.encode_columns("sensor_msgs/LaserScan", columns, 2)
        tenth = struct.unpack("<f", struct.pack("<f", 0.1))[0]
        assert page.read(("ranges",)) == [{"ranges": [0.5, tenth]}, {"ranges": [math.inf, 2.0]}]
        assert page.read(("angle_min", "ranges")) == [
            {"angle_min": 0.25, "ranges": [0.5, tenth]},
            {"angle_min": 0.25, "ranges": [math.inf, 2.0]},
        ]


@pytest.mark.parametrize("path", ["a_time", "a_string", "a_bool", "a_uint8", "a_float64", "inner", "inner/count"])
def test_what_no_column_says_in_plain_numbers_is_left_to_be_read_one_by_one(path: str) -> None:
    columns = {"a_time": 1.0, "a_string": "map", "a_bool": True, "a_uint8": np.ones(2, int), "a_int16": 1}
    assert CODEC.encode_columns("odd/Everything", columns, 2).read(("a_int16",)) == [{"a_int16": 1}] * 2
    assert CODEC.encode_columns("odd/Everything", columns, 2).read((path,)) is None


def test_messages_that_lie_apart_in_memory_come_in_the_order_of_rows() -> None:
    """The first and the last are alike, so they are written together."""
    columns = {"header/frame_id": ("a", "longer", "b"), "angle_min": np.array([1.0, 2.0, 3.0])}
    for _ in range(2):
        page = CODEC.encode_columns("sensor_msgs/LaserScan", columns, 3)
        scans = [
            {"header": {"frame_id": name}, "angle_min": x} for name, x in (("a", 1.0), ("longer", 2.0), ("b", 3.0))
        ]
        raws = [CODEC.encode("sensor_msgs/LaserScan", scan) for scan in scans]
        assert page.content == b"".join(raws)
        assert list(page.runs) == [(1, len(raws[0])), (1, len(raws[0]) + 5), (1, len(raws[0]))]
        assert page.read(("angle_min",)) is None


def test_a_page_is_not_read_any_more_once_its_sheet_is_written_anew() -> None:
    pages = [CODEC.encode_columns("geometry_msgs/Twist", {"linear/x": np.array([x, x])}, 2) for x in (1.0, 2.0)]
    assert pages[0].read(("linear/x",)) is None
    assert pages[1].read(("linear/x",)) == [{"linear/x": 2.0}] * 2
