"""How definitions that differ are told apart."""

from __future__ import annotations

from typing import List

import pytest

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport import RosCodec
from rqt_mrta_py.transport.ros1.misfits import Misfit, Misfits, difference

_INNER = f"{'=' * 80}\nMSG: my_msgs/Inner\n"


def way(type_name: str, definition: str, caller: str = "/talker", md5: str = "0" * 32) -> Connection:
    return Connection("/topic", type_name, md5, definition, caller)


def test_comments_and_spaces_make_no_difference() -> None:
    ours = way("my_msgs/Outer", "# what it is\nInner[] inners   # many\nint8 LIMIT = 5\n" + _INNER + "float32 x\n")
    theirs = way("my_msgs/Outer", "int8 LIMIT=5\nmy_msgs/Inner[]  inners\n\n" + _INNER + "\n# none\nfloat32 x")
    assert difference(ours, theirs, "known here") == ""


def test_difference_names_the_type_whose_field_differs() -> None:
    ours = way("my_msgs/Outer", "Inner inner\nstring name\n" + _INNER + "float32[3] x\n")
    theirs = way("my_msgs/Outer", "Inner inner\nstring name\n" + _INNER + "float64[3] x\n")
    assert difference(ours, theirs, "known here").split("\n") == [
        "--- known here",
        "+++ /talker",
        "@@ -4,2 +4,2 @@",
        " MSG: my_msgs/Inner",
        "-float32[3] x",
        "+float64[3] x",
    ]


@pytest.mark.parametrize("definition", ["no definition at all", "", "uint8[999999999999] x"])
def test_definition_that_cannot_be_understood_is_compared_as_it_stands(definition: str) -> None:
    assert difference(way("std_msgs/String", "string data"), way("std_msgs/String", definition), "a").endswith(
        f"+{definition}" if definition else ""
    )


def test_connections_that_fit_are_not_reported() -> None:
    told: List[Misfit] = []
    codec = RosCodec(lambda type_name: None)
    misfits = Misfits(codec, told.append)
    misfits.check(codec.connection("/news", "std_msgs/String", "/a"))
    misfits.check(codec.connection("/news", "std_msgs/String", "/b"))
    misfits.check(way("my_msgs/Unknown", "int8 x"))
    assert told == []
