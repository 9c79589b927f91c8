from __future__ import annotations

import math
from typing import Any, Dict, List

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.transport import RosCodec
from rqt_mrta_py.transport.codec.definitions import Definition, Field
from rqt_mrta_py.transport.codec.types import TypeLibrary
from rqt_mrta_py.transport.codec.wire import INTEGER_RANGES
from tests.transport.support import ODD_TYPES, lookup

TYPES = (
    "odd/Everything",
    "odd/Arrays",
    "sensor_msgs/LaserScan",
    "nav_msgs/Odometry",
    "visualization_msgs/MarkerArray",
    "diagnostic_msgs/DiagnosticArray",
    "tf2_msgs/TFMessage",
    "rqt_mrta_py/TeamState",
    "rqt_mrta_py/Incident",
)
LIBRARY = TypeLibrary(lookup)
CODEC = RosCodec(lookup)

_NANOSECOND_STAMPS = st.integers(0, 10**14)
"""Up to a day: as a float of seconds, each nanosecond of it is told apart."""


def primitives(type_name: str) -> st.SearchStrategy[Any]:
    if type_name in INTEGER_RANGES:
        return st.integers(*INTEGER_RANGES[type_name])
    return {
        "bool": st.booleans(),
        "float32": st.floats(width=32),
        "float64": st.floats(),
        "string": st.text(max_size=5),
        "time": _NANOSECOND_STAMPS.map(lambda ns: ns / 10**9),
        "duration": st.integers(-(10**14), 10**14).map(lambda ns: ns / 10**9),
    }[type_name]


def messages(definition: Definition, type_name: str, complete: bool = True) -> st.SearchStrategy[Dict[str, Any]]:
    def of(item: Field) -> st.SearchStrategy[Any]:
        element = primitives(item.type) if item.is_primitive else messages(definition, item.type, complete)
        if not item.is_array:
            return element
        if item.type in ("uint8", "char"):
            return st.binary(min_size=item.length or 0, max_size=6 if item.length is None else item.length)
        size = {"min_size": item.length, "max_size": item.length} if item.length is not None else {"max_size": 2}
        if item.length is not None and item.length > 8:
            return element.map(lambda value: [value] * item.length)
        return st.lists(element, **size)

    fields = {item.name: of(item) for item in definition.specs[type_name].fields}
    return st.fixed_dictionaries(fields) if complete else st.fixed_dictionaries({}, optional=fields)


def completed(definition: Definition, type_name: str, fields: Dict[str, Any]) -> Dict[str, Any]:
    """Put its zero in the place of whatever is left out."""

    def element(item: Field, value: Any = None) -> Any:
        if not item.is_primitive:
            return completed(definition, item.type, value or {})
        zeros = {"string": "", "bool": False, "time": 0.0, "duration": 0.0, "float32": 0.0, "float64": 0.0}
        return zeros.get(item.type, 0) if value is None else value

    def whole(item: Field) -> Any:
        value = fields.get(item.name)
        if not item.is_array:
            return element(item, value)
        return [element(item, part) for part in ([None] * (item.length or 0) if value is None else value)]

    return {item.name: whole(item) for item in definition.specs[type_name].fields}


@pytest.fixture(scope="module")
def store() -> Any:
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore

    made = get_typestore(Stores.ROS1_NOETIC)
    types: Dict[str, Any] = {}
    for name in [*ODD_TYPES, *TYPES]:
        for contained in LIBRARY.definition(name).specs.values():
            stored = contained.name.replace("/", "/msg/")
            if stored not in made.types:
                types.update(get_types_from_msg(contained.text, stored))
    made.register(types)
    return made


def as_rosbags(store: Any, definition: Definition, type_name: str, fields: Dict[str, Any]) -> Any:
    def value(item: Field, given_value: Any) -> Any:
        if not item.is_primitive:
            return as_rosbags(store, definition, item.type, given_value)
        if item.type in ("time", "duration"):
            ns = round(given_value * 10**9)
            name = f"builtin_interfaces/msg/{item.type.capitalize()}"
            return store.types[name](sec=ns // 10**9, nanosec=ns % 10**9)
        return given_value

    made: Dict[str, Any] = {}
    for item in definition.specs[type_name].fields:
        given_value = fields[item.name]
        if not item.is_array:
            made[item.name] = value(item, given_value)
        elif item.is_primitive and item.type not in ("string", "time", "duration"):
            kind = {"byte": "int8", "char": "uint8"}.get(item.type, item.type)
            made[item.name] = np.array(list(given_value), dtype=kind)
        else:
            made[item.name] = [value(item, element) for element in given_value]
    if not made:
        made["structure_needs_at_least_one_member"] = 0
    return store.types[type_name.replace("/", "/msg/")](**made)


def same(left: Any, right: Any) -> bool:
    if isinstance(left, dict):
        return left.keys() == right.keys() and all(same(left[key], right[key]) for key in left)
    if isinstance(left, list):
        return len(left) == len(right) and all(same(a, b) for a, b in zip(left, right))
    if isinstance(left, float) and math.isnan(left):
        return isinstance(right, float) and math.isnan(right)
    return bool(left == right) and type(left) is type(right)


@pytest.mark.parametrize("type_name", TYPES)
@settings(max_examples=25, deadline=None)
@given(data=st.data())
def test_codec_writes_the_bytes_that_rosbags_writes_and_reads_them_back(
    store: Any, type_name: str, data: st.DataObject
) -> None:
    definition = LIBRARY.definition(type_name)
    fields = data.draw(messages(definition, type_name))
    raw = CODEC.encode(type_name, fields)
    made = as_rosbags(store, definition, type_name, fields)
    assert raw == bytes(store.serialize_ros1(made, type_name.replace("/", "/msg/")))
    connection = CODEC.connection("/t", type_name)
    assert same(CODEC.decode(connection, raw), fields)
    names: List[str] = [item.name for item in definition.root.fields]
    paths = data.draw(st.lists(st.sampled_from(names), max_size=3))
    assert same(list(CODEC.compile(connection, paths)(raw)), [fields[path] for path in paths])


@pytest.mark.parametrize("type_name", TYPES)
@settings(max_examples=25, deadline=None)
@given(data=st.data())
def test_what_is_left_out_at_any_depth_is_zero(store: Any, type_name: str, data: st.DataObject) -> None:
    definition = LIBRARY.definition(type_name)
    fields = data.draw(messages(definition, type_name, complete=False))
    made = as_rosbags(store, definition, type_name, completed(definition, type_name, fields))
    assert CODEC.encode(type_name, fields) == bytes(store.serialize_ros1(made, type_name.replace("/", "/msg/")))
