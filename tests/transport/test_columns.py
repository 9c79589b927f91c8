"""Columns become the messages that their rows would become one by one, at first and ever after."""

from __future__ import annotations

import math
from typing import Any, Callable, Dict, List, Mapping, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport import Batch, RosCodec
from rqt_mrta_py.transport.batch import Run
from tests.transport.support import lookup

_KINDS = {
    "columns/Kinds": "\n".join(
        [
            "std_msgs/Header header",
            "bool flag",
            "int8 small",
            "uint64 wide",
            "int64 deep",
            "float32 single",
            "float64 d",
        ]
        + ["time t", "duration span", "uint8[] raw", "float32[3] three", "time[2] times", "bool[] flags", "string word"]
        + ["columns/Inner[] inners", "columns/Inner[2] two", "int16[] counts"]
    ),
    "columns/Inner": "string name\nuint16[] counts\nfloat64 value",
}


def codec_of_kinds() -> RosCodec:
    return RosCodec(lambda name: _KINDS.get(name) or lookup(name))


CODEC = codec_of_kinds()


def written(codec: RosCodec, type_name: str, columns: Mapping[str, Any], count: int) -> List[bytes]:
    """Serialise columns, and cut the messages apart."""
    page = codec.encode_columns(type_name, columns, count)
    connections = (CODEC.connection("/t", "std_msgs/Empty"),) * count
    return list(Batch(connections, 0, page.content, [Run(*run) for run in page.runs]).raws)


Maker = Callable[[int], "st.SearchStrategy[Any]"]
"""From the number of messages to the columns that a field may have."""


def numbers(elements: st.SearchStrategy[Any], dtype: Any) -> Maker:
    def make(count: int) -> st.SearchStrategy[Any]:
        return st.lists(elements, min_size=count, max_size=count).map(lambda values: np.array(values, dtype))

    return make


def rows(elements: st.SearchStrategy[Any], dtype: Any, width: int) -> Maker:
    def make(count: int) -> st.SearchStrategy[Any]:
        values = st.lists(elements, min_size=count * width, max_size=count * width)
        return values.map(lambda flat: np.array(flat, dtype).reshape(count, width))

    return make


def texts() -> Maker:
    # Few lengths, so that messages share layouts now and then; a NUL at the end and letters of several bytes.
    words = st.sampled_from(["", "map", "odom", "r\0", "käse", "robot1/base_link"])

    def make(count: int) -> st.SearchStrategy[Any]:
        each = st.lists(words, min_size=count, max_size=count)
        return words | each | each.map(tuple)

    return make


def shared(elements: st.SearchStrategy[Any]) -> Maker:
    return lambda count: elements


def any_of(*makers: Maker) -> Maker:
    return lambda count: st.one_of(*(make(count) for make in makers))


_REAL = st.floats(width=64)
_SINGLE = st.floats(width=32) | st.floats(-3e38, 3e38)
_WHOLE = st.integers(-(2**63), 2**63 - 1)
_TIME = st.floats(0, 2**32 - 1) | st.sampled_from([1.9999999999, 61.05, -1e-10, 0.5e-9, 1.5e-9])
_SPAN = st.floats(-(2**31), 2**31 - 1) | st.sampled_from([-1e-10, -0.25, 1.9999999999])

REAL = any_of(numbers(_REAL, np.float64), numbers(_WHOLE, np.int64), numbers(_SINGLE, ">f4"), shared(_REAL))
SINGLE = any_of(numbers(_SINGLE, np.float64), numbers(_WHOLE, np.int64), shared(_SINGLE))
TIME = any_of(
    numbers(_TIME, np.float64),
    numbers(st.floats(0, 2**31, width=32), np.float32),
    numbers(st.integers(0, 2**32 - 1), np.int64),
    shared(_TIME),
)
SPAN = any_of(numbers(_SPAN, np.float64), shared(_SPAN))
SEQ = any_of(numbers(st.integers(0, 2**32 - 1), np.int64), shared(st.integers(0, 2**32 - 1)))
POSE = {
    "position/x": REAL,
    "position/y": REAL,
    "orientation/z": REAL,
    "orientation/w": REAL,
}
HEADER = {"header/seq": SEQ, "header/stamp": TIME, "header/frame_id": texts()}


def within(path: str, fields: Mapping[str, Maker]) -> Dict[str, Maker]:
    return {f"{path}/{name}": maker for name, maker in fields.items()}


TRANSFORM = {**HEADER, "child_frame_id": texts(), "transform/translation/x": REAL, "transform/rotation/w": REAL}

TYPES: Dict[str, Dict[str, Maker]] = {
    "nav_msgs/Odometry": {
        **HEADER,
        "child_frame_id": texts(),
        **within("pose/pose", POSE),
        "pose/covariance": rows(_REAL, np.float64, 36),
        "twist/twist/linear/x": REAL,
        "twist/twist/angular/z": REAL,
    },
    "sensor_msgs/LaserScan": {
        **HEADER,
        "angle_min": SINGLE,
        "range_max": SINGLE,
        "ranges": any_of(rows(_SINGLE, np.float64, 3), rows(_SINGLE, np.float64, 0), rows(_WHOLE, np.int64, 2)),
    },
    "geometry_msgs/PoseStamped": {**HEADER, **within("pose", POSE)},
    "geometry_msgs/Twist": {"linear/x": REAL, "linear/y": REAL, "angular/z": REAL},
    "tf2_msgs/TFMessage": {**within("transforms/0", TRANSFORM), **within("transforms/1", TRANSFORM)},
    "columns/Kinds": {
        **HEADER,
        "flag": any_of(
            numbers(st.integers(0, 1), np.int64),
            numbers(st.booleans(), np.bool_),
            shared(st.sampled_from([True, 1, 0])),
        ),
        "small": any_of(numbers(st.integers(-128, 127), np.int64), shared(st.integers(-128, 127))),
        "wide": any_of(numbers(st.integers(0, 2**64 - 1), np.uint64), shared(st.integers(0, 2**64 - 1))),
        "deep": any_of(numbers(_WHOLE, np.int64), numbers(st.booleans(), np.bool_), shared(_WHOLE)),
        "single": SINGLE,
        "d": REAL,
        "t": TIME,
        "span": SPAN,
        "raw": rows(st.integers(0, 255), np.int64, 5),
        "three": rows(_SINGLE, np.float64, 3),
        "times": rows(_TIME, np.float64, 2),
        "flags": rows(st.booleans(), np.bool_, 3),
        "word": texts(),
        "inners/2/name": texts(),
        "inners/0/counts": rows(st.integers(0, 2**16 - 1), np.int64, 2),
        "inners/0/value": REAL,
        "two/1/value": REAL,
        "counts": rows(st.integers(-5, 5), np.int64, 1),
    },
}


def value_at(column: Any, row: int) -> Any:
    if isinstance(column, np.ndarray):
        return column.tolist()[row]
    return column[row] if isinstance(column, (list, tuple)) else column


def fields_of(columns: Mapping[str, Any], row: int) -> Dict[str, Any]:
    """Nest a row by hand: the only arrays of messages in these tests are the three named here."""
    fields: Dict[str, Any] = {}
    for path, column in columns.items():
        node: Any = fields
        *above, last = path.split("/")
        for name in above:
            if name.isdigit():
                node.extend({} for _ in range(len(node), int(name) + 1))
                node = node[int(name)]
            else:
                node = node.setdefault(name, [] if name in ("transforms", "inners", "two") else {})
        node[last] = value_at(column, row)
    return fields


@st.composite
def two_calls(draw: Any) -> Tuple[str, int, Dict[str, Any], Dict[str, Any]]:
    """Draw columns for one call and other numbers of the same form for the next."""
    type_name = draw(st.sampled_from(sorted(TYPES)))
    count = draw(st.integers(1, 4))
    chosen = draw(st.lists(st.sampled_from(sorted(TYPES[type_name])), unique=True))
    makers = {path: TYPES[type_name][path] for path in chosen}
    first = {path: draw(make(count)) for path, make in makers.items()}
    second = {path: draw(make(count)) for path, make in makers.items()}
    same = {path: column for path, column in first.items() if isinstance(column, (str, list, tuple))}
    return type_name, count, first, {**second, **same}


@settings(deadline=None)
@given(two_calls())
def test_columns_become_what_their_rows_become_one_by_one(
    drawn: Tuple[str, int, Dict[str, Any], Dict[str, Any]],
) -> None:
    type_name, count, *calls = drawn
    for columns in (*calls, *calls):
        expected = [CODEC.encode(type_name, fields_of(columns, row)) for row in range(count)]
        assert written(CODEC, type_name, columns, count) == expected


def kinds(**changes: Any) -> Dict[str, Any]:
    columns = {
        "header/stamp": np.array([1.0, 2.0]),
        "header/frame_id": ("a", "b"),
        "flag": np.array([0, 1]),
        "small": np.array([1, -1]),
        "wide": np.array([1, 2]),
        "single": np.array([1.0, 2.0]),
        "t": 3.0,
        "span": np.array([1.0, -2.0]),
        "raw": np.array([[1, 2], [3, 4]]),
        "three": np.zeros((2, 3)),
        "inners/1/name": ["x", "y"],
    }
    return {**columns, **{path.replace("__", "/"): column for path, column in changes.items()}}


BAD: List[Tuple[Dict[str, Any], str]] = [
    (
        {"small": np.array([1.0, math.nan])},
        "small: 1.0 does not fit; accepted is an integer from -128 to 127 (row 0 of 2)",
    ),
    ({"small": np.array([1, 128])}, "small: 128 does not fit; accepted is an integer from -128 to 127 (row 1 of 2)"),
    ({"small": 128}, "small: 128 does not fit; accepted is an integer from -128 to 127 (row 0 of 2)"),
    ({"small": 1.5}, "small: 1.5 does not fit; accepted is an integer from -128 to 127 (row 0 of 2)"),
    ({"wide": np.array([1, -2])}, f"wide: -2 does not fit; accepted is an integer from 0 to {2**64 - 1} (row 1 of 2)"),
    ({"flag": np.array([0, 2])}, "flag: 2 does not fit; accepted is True or False (row 1 of 2)"),
    ({"flag": np.array([0.0, 1.0])}, "flag: 0.0 does not fit; accepted is True or False (row 0 of 2)"),
    ({"flag": "yes"}, "flag: 'yes' does not fit; accepted is True or False (row 0 of 2)"),
    (
        {"single": np.array([math.inf, 1e39])},
        "single: 1e+39 does not fit; accepted is a number in the range of float32 (row 1 of 2)",
    ),
    (
        {"three": np.array([[0, 0, 0], [0, 0, -1e39]])},
        "three/2: -1e+39 does not fit; accepted is a number in the range of float32 (row 1 of 2)",
    ),
    ({"single": ("a", "b")}, "single: 'a' does not fit; accepted is a number in the range of float32 (row 0 of 2)"),
    *(
        (
            {"header__stamp": np.array([1.0, bad])},
            f"header/stamp: {bad} does not fit; accepted is finite seconds from 0 to 4294967296 (row 1 of 2)",
        )
        for bad in (-1.0, -1e-9, 2.0**32, math.nan, math.inf, -math.inf)
    ),
    ({"t": -1.0}, "t: -1.0 does not fit; accepted is finite seconds from 0 to 4294967296 (row 0 of 2)"),
    ({"t": True}, "t: True does not fit; accepted is finite seconds from 0 to 4294967296 (row 0 of 2)"),
    (
        {"t": np.array([True, True])},
        "t: True does not fit; accepted is finite seconds from 0 to 4294967296 (row 0 of 2)",
    ),
    (
        {"span": np.array([0.0, 2.0**31])},
        "span: 2147483648.0 does not fit; accepted is finite seconds from -2147483648 to 2147483648 (row 1 of 2)",
    ),
    (
        {"raw": np.array([[1, 2], [3, 256]])},
        "raw/1: 256 does not fit; accepted is an integer from 0 to 255 (row 1 of 2)",
    ),
    ({"raw": np.array([1, 2])}, "raw: 1 does not fit; accepted is a list of uint8 (row 0 of 2)"),
    (
        {"raw": np.zeros((2, 1, 1), np.int64)},
        "raw/0: [0] does not fit; accepted is an integer from 0 to 255 (row 0 of 2)",
    ),
    (
        {"small": np.zeros((2, 1), np.int64)},
        "small: [0] does not fit; accepted is an integer from -128 to 127 (row 0 of 2)",
    ),
    ({"three": np.zeros((2, 2))}, "three: 2 elements; accepted is a list of float32, 3 of them (row 0 of 2)"),
    ({"three": 1.0}, "three: 1.0 does not fit; accepted is a list of float32, 3 of them (row 0 of 2)"),
    ({"single": np.zeros(3)}, "single: 3 rows; accepted is one for each of 2 messages"),
    ({"header__frame_id": ("a",)}, "header/frame_id: 1 rows; accepted is one for each of 2 messages"),
    ({"header__frame_id": 1}, "header/frame_id: 1 does not fit; accepted is a string (row 0 of 2)"),
    ({"header__frame_id": np.zeros(2)}, "header/frame_id: 0.0 does not fit; accepted is a string (row 0 of 2)"),
    (
        {"header__frame_id": "\ud800"},
        "header/frame_id: '\\ud800' does not fit; accepted is a string that UTF-8 can express (row 0 of 2)",
    ),
    (
        {"inners__1__nope": 1},
        "inners/1/nope: columns/Inner has no such field; it has: name, counts, value (row 0 of 2)",
    ),
    ({"inners__name": 1}, "inners: {'1': {'name': 'x'}, 'name': 1} does not fit"),
    ({"header__0__seq": 1}, "header/0: std_msgs/Header has no such field; it has: seq, stamp, frame_id (row 0 of 2)"),
    ({"inners__10000__name": "z"}, "inners: "),
    ({"two__0__name": "z"}, "two: 1 elements; accepted is a list of columns/Inner, 2 of them (row 0 of 2)"),
    ({"": 1}, ": columns/Kinds has no such field"),
    ({"t__secs": 1}, "t/secs: a path that it begins with has a column too; accepted is one of the two"),
    ({"header": 1}, "header: a path that begins with it has a column too; accepted is one of the two"),
    *(
        ({"single": bad}, "single: ")
        for bad in (None, b"raw", [1.0, 2.0], {"a": 1}, np.array(1.0), np.array(["a", "b"]), np.array([1j, 2j]))
    ),
]


@pytest.mark.parametrize(("changes", "problem"), BAD)
def test_what_does_not_fit_is_refused_by_its_path_at_first_and_later(changes: Dict[str, Any], problem: str) -> None:
    codec = codec_of_kinds()
    for _ in range(2):
        with pytest.raises(TransportError) as caught:
            codec.encode_columns("columns/Kinds", kinds(**changes), 2)
        assert str(caught.value).startswith(f"columns/Kinds: {problem}")
        good = written(codec, "columns/Kinds", kinds(), 2)
        assert good == [codec.encode("columns/Kinds", fields_of(kinds(), row)) for row in range(2)]


def test_the_row_is_named_only_among_several() -> None:
    with pytest.raises(TransportError) as caught:
        CODEC.encode_columns("geometry_msgs/Twist", {"linear/x": "fast"}, 1)
    with pytest.raises(TransportError) as plain:
        CODEC.encode("geometry_msgs/Twist", {"linear": {"x": "fast"}})
    assert str(caught.value) == str(plain.value)


def test_shared_numbers_that_change_are_written_anew() -> None:
    for speed in (1.0, 2.0, 2, True, 0.0, -0.0):
        raws = written(CODEC, "geometry_msgs/Twist", {"linear/x": speed, "angular/z": np.ones(2)}, 2)
        assert raws == [CODEC.encode("geometry_msgs/Twist", {"linear": {"x": speed}, "angular": {"z": 1.0}})] * 2


def test_columns_are_read_where_they_lie_and_left_as_they_are() -> None:
    table = np.arange(12.0).reshape(4, 3)
    columns = {"linear/x": table[::2, 1], "linear/y": np.broadcast_to(np.float64(7.0), 2)}
    for _ in range(2):
        raws = written(CODEC, "geometry_msgs/Twist", columns, 2)
        assert raws == [CODEC.encode("geometry_msgs/Twist", {"linear": {"x": x, "y": 7.0}}) for x in (1.0, 7.0)]
    assert table.tolist() == np.arange(12.0).reshape(4, 3).tolist()


def test_no_messages_are_no_messages() -> None:
    assert written(CODEC, "geometry_msgs/Twist", {"linear/x": np.zeros(0), "linear/y": 1.0}, 0) == []
    with pytest.raises(TransportError, match="linear/x: 1 rows; accepted is one for each of 0 messages"):
        CODEC.encode_columns("geometry_msgs/Twist", {"linear/x": np.zeros(1)}, 0)


def test_more_forms_than_are_kept_are_written_all_the_same() -> None:
    codec = codec_of_kinds()
    for _ in range(2):
        for width in range(40):
            ranges = np.full((2, width), 0.5)
            raws = written(codec, "sensor_msgs/LaserScan", {"ranges": ranges}, 2)
            assert raws == [codec.encode("sensor_msgs/LaserScan", {"ranges": [0.5] * width})] * 2


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
