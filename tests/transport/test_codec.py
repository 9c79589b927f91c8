from __future__ import annotations

import math
import struct
from typing import Any, Dict, Mapping

import numpy as np
import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport import RosCodec
from rqt_mrta_py.transport.codec.values import Texts
from tests.transport.support import connection, lookup

MOTIVATION = {
    "header": {"seq": 7, "stamp": 61.05, "frame_id": "/robot1"},
    "task_id": "wander",
    "impatience": 1.5,
    "applicable": True,
    "motivation": 30.0,
    "threshold": 30,
    "active": True,
}
# Written by hand from the wire format: u32 lengths, little endian, time as seconds and nanoseconds.
MOTIVATION_BYTES = (
    b"\x07\x00\x00\x00" + b"\x3d\x00\x00\x00" + b"\x80\xf0\xfa\x02"
    b"\x07\x00\x00\x00/robot1"
    b"\x06\x00\x00\x00wander"
    b"\x00\x00\x00\x00\x00\x00\xf8\x3f"
    b"\x00\x00\x00\x01"
    b"\x00\x00\x00\x00\x00\x00\x3e\x40"
    b"\x00\x00\x00\x00\x00\x00\x3e\x40"
    b"\x01"
)


def roundtrip(codec: RosCodec, type_name: str, fields: Mapping[str, Any]) -> Dict[str, Any]:
    return codec.decode(codec.connection("/t", type_name), codec.encode(type_name, fields))


def test_encode_writes_the_bytes_of_the_wire_format(codec: RosCodec) -> None:
    assert codec.encode("alliance_msgs/Motivation", MOTIVATION) == MOTIVATION_BYTES


def test_decode_reads_the_bytes_of_the_wire_format(codec: RosCodec) -> None:
    assert codec.decode(codec.connection("/m", "alliance_msgs/Motivation"), MOTIVATION_BYTES) == {
        **MOTIVATION,
        "acquiescent": False,
        "suppressed": False,
        "resetted": False,
    }


def test_compile_gives_values_in_the_order_of_the_paths(codec: RosCodec) -> None:
    paths = ("active", "header/frame_id", "header", "task_id", "header/frame_id", "threshold")
    read = codec.compile(codec.connection("/m", "alliance_msgs/Motivation"), paths)
    header = {"seq": 7, "stamp": 61.05, "frame_id": "/robot1"}
    assert read(MOTIVATION_BYTES) == (True, "/robot1", header, "wander", "/robot1", 30.0)


def test_compile_reads_bytes_memoryview_and_bytearray_alike(codec: RosCodec) -> None:
    read = codec.compile(codec.connection("/m", "alliance_msgs/Motivation"), ("task_id",))
    assert read(MOTIVATION_BYTES) == read(bytes(bytearray(MOTIVATION_BYTES))) == ("wander",)


@pytest.mark.parametrize("paths", [(), ("header/stamp",), ("active",)])
@pytest.mark.parametrize("raw", [MOTIVATION_BYTES[:-1], MOTIVATION_BYTES + b"\0", b"", MOTIVATION_BYTES[:20]])
def test_compile_refuses_bytes_that_do_not_fit_whatever_is_read(codec: RosCodec, paths: Any, raw: bytes) -> None:
    read = codec.compile(codec.connection("/m", "alliance_msgs/Motivation"), paths)
    with pytest.raises(TransportError) as caught:
        read(raw)
    assert str(caught.value) == (
        f"alliance_msgs/Motivation: {len(raw)} bytes do not fit the definition with md5 "
        "f2769f911dab2069bd205e5da97d8fb9"
    )


@pytest.mark.parametrize(
    ("path", "message"),
    [
        ("nope", "no field 'nope'; fields of nav_msgs/Odometry are: header, child_frame_id, pose, twist"),
        ("pose/nope", "no field 'pose/nope'; fields of geometry_msgs/PoseWithCovariance are: pose, covariance"),
        ("header/stamp/secs", "no field 'header/stamp/secs'; stamp is a time, the path must end there"),
        ("pose/covariance/0", "no field 'pose/covariance/0'; covariance is an array, the path must end there"),
        ("", "no field ''"),
        ("/header", "no field '/header'"),
    ],
)
def test_compile_says_which_path_a_definition_lacks(codec: RosCodec, path: str, message: str) -> None:
    with pytest.raises(TransportError) as caught:
        codec.compile(codec.connection("/odom", "nav_msgs/Odometry"), (path,))
    assert str(caught.value).startswith(f"nav_msgs/Odometry: {message}")


def test_compile_reads_a_type_that_is_nowhere_installed_by_its_definition(codec: RosCodec) -> None:
    first = connection("/x", "gone_msgs/Thing", "uint16 a\nstring b")
    second = connection("/y", "gone_msgs/Thing", "string b\nuint16 a")
    assert codec.compile(first, ("b", "a"))(b"\x01\x00\x01\x00\x00\x00z") == ("z", 1)
    assert codec.compile(second, ("b", "a"))(b"\x01\x00\x00\x00z\x02\x00") == ("z", 2)


def test_compile_names_the_line_of_a_definition_that_cannot_be_understood(codec: RosCodec) -> None:
    with pytest.raises(TransportError, match="gone_msgs/Thing, line 1 of its definition: 'what' is no declaration"):
        codec.compile(connection("/x", "gone_msgs/Thing", "what"), ())


@pytest.mark.parametrize(
    "hostile",
    ["x/Y'); raise SystemExit('owned", "x(): pass\nraise SystemExit\ndef y/Y", "x/%s%d", "x\0/Y", "{x}/Y", ""],
)
def test_a_hostile_type_name_is_text_and_never_code(codec: RosCodec, hostile: str) -> None:
    package = hostile.partition("/")[0]
    text = f"uint8 a\nB[] b\nB c\n{'=' * 80}\nMSG: x/B\nstring s\n"
    made = connection("/x", hostile, text if package == "x" else "uint8 a\nstring s")
    rest = b"\1\0\0\0\0\0\0\0" if package == "x" else b""
    assert codec.compile(made, ("a",))(b"\7" + rest + b"\0\0\0\0") == (7,)
    assert codec.decode(made, b"\7" + rest + b"\0\0\0\0")["a"] == 7
    with pytest.raises(TransportError) as caught:
        codec.decode(made, b"ab")
    assert str(caught.value).startswith(f"{hostile}: 2 bytes do not fit")


def test_a_hostile_package_of_a_contained_type_is_text_and_never_code(codec: RosCodec) -> None:
    package = "x():raise(SystemExit)#"
    text = f"B[] b\n{'=' * 80}\nMSG: {package}/B\nstring s\n"
    made = connection("/x", f"{package}/Y", text)
    raw = b"\1\0\0\0\1\0\0\0z"
    assert codec.decode(made, raw) == {"b": [{"s": "z"}]}
    assert codec.compile(made, ())(raw) == ()


def test_contained_types_whose_names_look_alike_are_told_apart(codec: RosCodec) -> None:
    separator = "=" * 80
    text = f"a/b__c[] x\na__b/c[] y\n{separator}\nMSG: a/b__c\nuint8 u\n{separator}\nMSG: a__b/c\nstring s\n"
    raw = b"\1\0\0\0\7\1\0\0\0\1\0\0\0z"
    assert codec.decode(connection("/x", "x/Y", text), raw) == {"x": [{"u": 7}], "y": [{"s": "z"}]}


def test_missing_fields_take_their_types_zero(codec: RosCodec) -> None:
    empty = {"count": 0, "name": "", "values": []}
    assert roundtrip(codec, "odd/Arrays", {}) == {
        "bools": [],
        "signed": [],
        "chars": b"",
        "raw": b"",
        "four": b"\0\0\0\0",
        "floats": [],
        "three": [0.0, 0.0, 0.0],
        "wide": [],
        "words": [],
        "pair": ["", ""],
        "times": [],
        "spans": [0.0, 0.0],
        "inners": [],
        "two": [empty, empty],
        "plain": [],
        "plains": [{"x": 0, "t": 0.0, "flags": [False, False]}] * 2,
        "empties": [],
    }


def test_arrays_come_from_lists_tuples_numpy_and_bytes_alike(codec: RosCodec) -> None:
    plain = {
        "raw": [1, 2],
        "chars": [3],
        "floats": [0.5, 2.0],
        "wide": [-1, 2**40],
        "bools": [True, False],
        "three": [1, 2, 3],
    }
    others = {
        "raw": np.array([1, 2], dtype=np.uint8),
        "chars": b"\x03",
        "floats": np.array([0.5, 2.0], dtype=np.float64),
        "wide": (-1, np.int64(2**40)),
        "bools": np.array([1, 0], dtype=bool),
        "three": np.array([1, 2, 3], dtype=np.float32),
    }
    assert codec.encode("odd/Arrays", plain) == codec.encode("odd/Arrays", others)
    decoded = roundtrip(codec, "odd/Arrays", others)
    assert (decoded["raw"], decoded["chars"], decoded["wide"]) == (b"\x01\x02", b"\x03", [-1, 2**40])


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (0, (0, 0)),
        (61.05, (61, 50_000_000)),
        (1.0000000004, (1, 0)),
        (1.0000000006, (1, 1)),
        (1.9999999996, (2, 0)),
        (-1e-10, (0, 0)),
        (2**32 - 1, (2**32 - 1, 0)),
    ],
)
def test_times_are_rounded_to_the_nearest_nanosecond(codec: RosCodec, value: float, words: Any) -> None:
    assert struct.unpack("<II", codec.encode("std_msgs/Time", {"data": value})) == words


@pytest.mark.parametrize(
    ("value", "words"), [(-0.5, (-1, 500_000_000)), (-2, (-2, 0)), (2.25, (2, 250_000_000)), (-1e-10, (0, 0))]
)
def test_durations_may_be_negative(codec: RosCodec, value: float, words: Any) -> None:
    assert struct.unpack("<ii", codec.encode("std_msgs/Duration", {"data": value})) == words
    assert roundtrip(codec, "std_msgs/Duration", {"data": value})["data"] == round(value, 9)


def test_a_duration_whose_words_have_different_signs_is_their_sum(codec: RosCodec) -> None:
    raw = struct.pack("<ii", 1, -250_000_000)
    assert codec.decode(codec.connection("/d", "std_msgs/Duration"), raw) == {"data": 0.75}


def test_times_survive_a_round_trip_at_every_tick_of_a_day(codec: RosCodec) -> None:
    for tick in range(0, 20 * 86400, 997):
        stamp = 1 + tick / 20
        assert roundtrip(codec, "std_msgs/Time", {"data": stamp})["data"] == stamp


def test_floats_that_are_not_finite_travel(codec: RosCodec) -> None:
    decoded = roundtrip(codec, "odd/Arrays", {"floats": [math.nan, math.inf, -math.inf]})["floats"]
    assert math.isnan(decoded[0])
    assert decoded[1:] == [math.inf, -math.inf]


def test_text_that_is_no_utf8_is_read_with_its_bytes_shown(codec: RosCodec) -> None:
    raw = b"\x03\x00\x00\x00a\xffb"
    assert codec.decode(codec.connection("/s", "std_msgs/String"), raw) == {"data": "a\\xffb"}


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"nope": 1}, "nope: odd/Everything has no such field; it has: a_bool, a_byte, "),
        ({"inner": {"nope": 1}}, "inner/nope: odd/Inner has no such field; it has: count, name, values"),
        ({"inner": 3}, "inner: 3 does not fit; accepted is the fields of a odd/Inner by name"),
        ({"a_bool": "no"}, "a_bool: 'no' does not fit; accepted is True or False"),
        ({"a_bool": 2}, "a_bool: 2 does not fit; accepted is True or False"),
        ({"a_uint8": 256}, "a_uint8: 256 does not fit; accepted is an integer from 0 to 255"),
        ({"a_int64": 2**63}, f"a_int64: {2**63} does not fit; accepted is an integer from {-(2**63)} to {2**63 - 1}"),
        ({"a_char": -1}, "a_char: -1 does not fit; accepted is an integer from 0 to 255"),
        ({"a_int16": 1.0}, "a_int16: 1.0 does not fit; accepted is an integer from -32768 to 32767"),
        ({"a_float32": 1e39}, "a_float32: 1e+39 does not fit; accepted is a number in the range of float32"),
        ({"a_float64": "1"}, "a_float64: '1' does not fit; accepted is a number in the range of float64"),
        ({"a_float64": None}, "a_float64: None does not fit"),
        ({"a_string": b"x"}, "a_string: b'x' does not fit; accepted is a string"),
        ({"a_string": "\ud800"}, "a_string: '\\ud800' does not fit; accepted is a string that UTF-8 can express"),
        ({"a_time": -1}, "a_time: -1 does not fit; accepted is finite seconds from 0 to 4294967296"),
        ({"a_time": math.nan}, "a_time: nan does not fit"),
        ({"a_time": 2.0**32}, "a_time: 4294967296.0 does not fit"),
        ({"a_time": True}, "a_time: True does not fit"),
        ({"a_duration": math.inf}, "a_duration: inf does not fit; accepted is finite seconds from -2147483648 to "),
        ({"nothing": {"x": 1}}, "nothing/x: odd/Empty has no such field; it has: none"),
        (3, "the message: 3 does not fit; accepted is the fields of a odd/Everything by name"),
    ],
)
def test_encode_names_the_path_of_what_does_not_fit(codec: RosCodec, fields: Any, message: str) -> None:
    with pytest.raises(TransportError) as caught:
        codec.encode("odd/Everything", fields)
    assert str(caught.value).startswith(f"odd/Everything: {message}")


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"words": "abc"}, "words: 'abc' does not fit; accepted is a list of string"),
        ({"words": ["a", 1]}, "words/1: 1 does not fit; accepted is a string"),
        ({"wide": {1: 2}}, "wide: {1: 2} does not fit; accepted is a list of int64"),
        ({"wide": {1}}, "wide: {1} does not fit"),
        ({"raw": 5}, "raw: 5 does not fit; accepted is a list of uint8"),
        ({"raw": [256]}, "raw/0: 256 does not fit; accepted is an integer from 0 to 255"),
        ({"raw": "ab"}, "raw: 'ab' does not fit"),
        ({"four": b"abc"}, "four: 3 elements; accepted is a list of uint8, 4 of them"),
        ({"three": [1, 2]}, "three: 2 elements; accepted is a list of float64, 3 of them"),
        ({"three": None}, "three: None does not fit; accepted is a list of float64, 3 of them"),
        ({"floats": np.zeros((2, 2))}, "floats: array([[0., 0.],"),
        ({"bools": [True, "x"]}, "bools/1: 'x' does not fit; accepted is True or False"),
        ({"times": [1.0, -1.0]}, "times/1: -1.0 does not fit"),
        ({"inners": [{}, {"name": 1}]}, "inners/1/name: 1 does not fit; accepted is a string"),
        ({"two": [{}]}, "two: 1 elements; accepted is a list of odd/Inner, 2 of them"),
    ],
)
def test_encode_names_the_element_of_what_does_not_fit(codec: RosCodec, fields: Any, message: str) -> None:
    with pytest.raises(TransportError) as caught:
        codec.encode("odd/Arrays", fields)
    assert str(caught.value).startswith(f"odd/Arrays: {message}")


def test_encode_says_which_type_is_unknown(codec: RosCodec) -> None:
    with pytest.raises(TransportError, match="'no_msgs/No' is not known"):
        codec.encode("no_msgs/No", {})


def test_connection_carries_md5_and_the_text_that_its_reader_needs() -> None:
    made = RosCodec(lookup).connection("/robot1/odom", "nav_msgs/Odometry", "/robot1/driver", latched=True)
    assert (made.topic, made.type, made.caller, made.latched) == (
        "/robot1/odom",
        "nav_msgs/Odometry",
        "/robot1/driver",
        True,
    )
    assert made.md5 == "cd5e73d190d741a2f92e81eda573aca7"
    assert RosCodec({}.get).compile(made, ("pose/pose/position/x",))(bytes(700)) == (0.0,)


@pytest.mark.parametrize("nothing", ["", [], (), frozenset()])
def test_a_message_without_fields_is_still_no_other_empty_thing(codec: RosCodec, nothing: Any) -> None:
    assert codec.encode("odd/Empty", {}) == b""
    with pytest.raises(TransportError, match=r"odd/Empty: the message: .* does not fit"):
        codec.encode("odd/Empty", nothing)


def test_many_different_strings_do_not_pile_up() -> None:
    texts = Texts()
    for number in range(10_000):
        assert texts[f"s{number}"][4:] == f"s{number}".encode()
    assert len(texts) < 5000
    assert texts["long " * 100] == struct.pack("<I", 500) + b"long " * 100
    assert "long " * 100 not in texts


def test_a_huge_array_of_fixed_length_costs_nothing_until_it_is_written() -> None:
    codec = RosCodec(lambda name: f"uint8[{2**33}] many\nbool ok" if name == "odd/Huge" else None)
    with pytest.raises(TransportError, match=r"odd/Huge: many: 1 elements; accepted is a list of uint8, 8589934592 of"):
        codec.encode("odd/Huge", {"many": [1]})
