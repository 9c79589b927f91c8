"""Marks of hand-made messages; where fields stand is counted by hand."""

from __future__ import annotations

import struct

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport import Marker
from tests.transport.support import connection

HEADER = "Header header\nstring task_id\nfloat64 motivation\nbool active\n"
TEXT = f"{HEADER}{'=' * 80}\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"


def message(frame: bytes, task: bytes) -> bytes:
    header = struct.pack("<IIII", 7, 1, 2, len(frame)) + frame
    return header + struct.pack("<I", len(task)) + task + struct.pack("<d?", 1.5, True)


def test_marks_tell_lengths_and_the_fields_that_matter() -> None:
    marks = Marker(connection("/t", "x/Y", TEXT), ("task_id", "active")).mark(message(b"/r1", b"patrol"))
    assert marks is not None
    # Sequence 0-4, stamp 4-12, length 12-16 and text of the frame 16-19, length 19-23 and text of the task 23-29,
    # motivation 29-37, active 37.
    assert marks.layout == (12, 19)
    assert marks.said == ((19, 29), (37, 38))
    assert marks.places() == [12, 13, 14, 15, *range(19, 29), 37]


def test_a_nested_field_stands_where_its_message_does() -> None:
    marks = Marker(connection("/t", "x/Y", TEXT), ("header/stamp",)).mark(message(b"", b"a"))
    assert marks is not None
    assert marks.said == ((4, 12),)


def test_a_whole_message_within_matters_as_a_whole() -> None:
    marks = Marker(connection("/t", "x/Y", TEXT), ("header",)).mark(message(b"/r", b""))
    assert marks is not None
    assert marks.said == ((0, 4), (4, 12), (12, 18))


@pytest.mark.parametrize(
    "raw", [b"", message(b"/r1", b"patrol")[:-1], message(b"/r1", b"patrol") + b"\0", b"\xff" * 40]
)
def test_bytes_that_do_not_fit_have_no_marks(raw: bytes) -> None:
    assert Marker(connection("/t", "x/Y", TEXT), ("active",)).mark(raw) is None


def test_arrays_count_and_very_many_lengths_are_not_worth_it() -> None:
    where = connection("/t", "x/Y", "uint8[] data\nstring[2] names\nuint16 last\n")
    raw = struct.pack("<I", 3) + b"abc" + struct.pack("<I", 1) + b"x" + struct.pack("<I", 0) + struct.pack("<H", 5)
    marks = Marker(where, ("names", "last")).mark(raw)
    assert marks is not None
    assert (marks.layout, marks.said) == ((0, 7, 12), ((7, 16), (16, 18)))
    many = struct.pack("<I", 1000) + struct.pack("<I", 0) * 1000
    assert Marker(connection("/t", "x/Z", "string[] names\n"), ("names",)).mark(many) is None


def test_a_definition_that_makes_no_sense_is_one_clear_error() -> None:
    with pytest.raises(TransportError):
        Marker(connection("/t", "x/Y", "this is no field at all"), ("a",))
    marker = Marker(connection("/t", "x/Y", TEXT), ())
    assert marker.has("header/stamp")
    assert not marker.has("header/nothing")
    assert not marker.has("motivation/more")
