"""Writers that have learned the form of messages write what comes in any other form, and refuse what does not fit."""

from __future__ import annotations

import struct
from collections import defaultdict
from types import MappingProxyType
from typing import Any, Dict, Mapping

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport import RosCodec
from tests.transport.support import lookup

_OFTEN = 20
"""More often than a form must be said to be learned."""


def zeros_but(**at: float) -> bytes:
    """Give a Twist's six doubles on the wire, zero but for the named places."""
    return struct.pack("<6d", *(at.get(name, 0.0) for name in ("x", "y", "z", "roll", "pitch", "yaw")))


@pytest.fixture
def learned() -> RosCodec:
    """Give a codec that has heard two forms of a Twist and one of a TFMessage."""
    codec = RosCodec(lookup)
    for _ in range(_OFTEN):
        codec.encode("geometry_msgs/Twist", {"linear": {"x": 1.0, "y": 2.0}, "angular": {"z": 3.0}})
        codec.encode("tf2_msgs/TFMessage", {"transforms": [{"child_frame_id": "a"}]})
    for _ in range(_OFTEN):
        codec.encode("geometry_msgs/Twist", {"linear": {}})
    return codec


@pytest.mark.parametrize(
    ("fields", "raw"),
    [
        ({"linear": {"x": 4.0, "y": 5.0}, "angular": {"z": 6.0}}, zeros_but(x=4.0, y=5.0, yaw=6.0)),
        ({"angular": {"z": 6}, "linear": {"y": 5, "x": True}}, zeros_but(x=1.0, y=5.0, yaw=6.0)),
        ({"linear": {"x": 4.0, "z": 5.0}, "angular": {"z": 6.0}}, zeros_but(x=4.0, z=5.0, yaw=6.0)),
        ({"linear": {"x": 4.0}, "angular": {"x": 6.0, "y": 7.0}}, zeros_but(x=4.0, roll=6.0, pitch=7.0)),
        ({"linear": {}}, zeros_but()),
        ({"angular": {}}, zeros_but()),
        ({}, zeros_but()),
        ({"linear": MappingProxyType({"x": 4.0, "y": 5.0}), "angular": {"z": 6.0}}, zeros_but(x=4.0, y=5.0, yaw=6.0)),
    ],
)
def test_every_form_is_written_whatever_was_learned(learned: RosCodec, fields: Dict[str, Any], raw: bytes) -> None:
    assert learned.encode("geometry_msgs/Twist", fields) == raw


def test_a_mapping_that_makes_up_fields_is_asked_for_none(learned: RosCodec) -> None:
    linear: Mapping[str, float] = defaultdict(lambda: 9.0, {"x": 4.0, "z": 5.0})
    raw = learned.encode("geometry_msgs/Twist", {"linear": linear, "angular": {"z": 6.0}})
    assert raw == zeros_but(x=4.0, z=5.0, yaw=6.0)
    assert dict(linear) == {"x": 4.0, "z": 5.0}


@pytest.mark.parametrize(
    ("fields", "problem"),
    [
        ({"linear": {"x": 4.0, "q": 5.0}, "angular": {"z": 6.0}}, "linear/q"),
        ({"linear": {"x": 4.0, "y": "fast"}, "angular": {"z": 6.0}}, "linear/y"),
        ({"linear": 4.0, "angular": {"z": 6.0}}, "linear"),
    ],
)
def test_what_does_not_fit_is_refused_by_its_path_after_learning(
    learned: RosCodec, fields: Dict[str, Any], problem: str
) -> None:
    with pytest.raises(TransportError, match=f"^geometry_msgs/Twist: {problem}\\b") as raised:
        learned.encode("geometry_msgs/Twist", fields)
    with pytest.raises(TransportError) as plain:
        RosCodec(lookup).encode("geometry_msgs/Twist", fields)
    assert str(raised.value) == str(plain.value)


def test_elements_of_an_array_may_differ_from_the_first(learned: RosCodec) -> None:
    head, tail = bytes(12) + bytes(4), bytes(56)

    def transform(child: bytes, x: float = 0.0) -> bytes:
        return head + struct.pack("<I", len(child)) + child + struct.pack("<d", x) + tail[8:]

    fields = {"transforms": [{"child_frame_id": "b"}, {"transform": {"translation": {"x": 2.0}}}, {}]}
    raw = learned.encode("tf2_msgs/TFMessage", fields)
    assert raw == struct.pack("<I", 3) + transform(b"b") + transform(b"", 2.0) + transform(b"")
    assert learned.encode("tf2_msgs/TFMessage", {"transforms": []}) == bytes(4)
