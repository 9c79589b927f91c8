"""Fields that hold ids, and fields that do not."""

from __future__ import annotations

from typing import Optional

import pytest

from rqt_mrta_py.app.doctor.topics import field_fault
from rqt_mrta_py.transport.codec.definitions import Definition, parse_message

TEXTS = {
    "m/Bid": "std_msgs/Header header\nm/Robot robot\nm/Robot[] rivals\nstring[3] tags\nuint8 LIMIT=3\nfloat64 price\n",
    "m/Robot": "string name\n",
    "std_msgs/Header": "uint32 seq\ntime stamp\nstring frame_id\n",
}
BID = Definition.gather("m/Bid", lambda name: parse_message(name, TEXTS[name]))


@pytest.mark.parametrize(
    ("path", "fault"),
    [
        ("header/frame_id", None),
        ("robot/name", None),
        ("robot", "'robot' is of type m/Robot; give a field of type string"),
        ("price", "'price' is of type float64; give a field of type string"),
        ("tags", "'tags' is an array of string; give a field of type string"),
        ("header/stamp", "'header/stamp' is of type time; give a field of type string"),
        ("robots", "m/Bid has no field 'robots'; nearest is 'robot'"),
        ("LIMIT", "m/Bid has no field 'LIMIT'; accepted: header, robot, rivals, tags, price"),
        ("robot/nam", "m/Robot has no field 'nam' of 'robot/nam'; nearest is 'name'"),
        (
            "rivals/name",
            "'rivals/name' leads through 'rivals', which is an array of m/Robot; give a path that ends in a field of "
            "type string",
        ),
        (
            "price/unit",
            "'price/unit' leads through 'price', which is of type float64; give a path that ends in a field of "
            "type string",
        ),
    ],
)
def test_field_holds_an_id_where_a_path_ends_in_one_text(path: str, fault: Optional[str]) -> None:
    assert field_fault(BID, path) == fault
