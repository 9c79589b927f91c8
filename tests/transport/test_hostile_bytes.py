"""Bytes and definitions from strangers: every failure is a TransportError, and none takes the machine along."""

from __future__ import annotations

import resource
import struct
import sys
import time
from typing import Iterator, List, Optional, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport import RosCodec
from tests.transport.support import connection, lookup

CODEC = RosCodec(lookup)
LONGEST = b"\xff\xff\xff\xff"
SEPARATOR = "=" * 80


@pytest.fixture
def _short_and_small() -> Iterator[None]:
    """Hold a test to two seconds of CPU and 300 MB more memory than before it."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.process_time()
    yield
    assert time.process_time() - start < 2.0
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 300 * 1024


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="ru_maxrss is in kilobytes on Linux only")
@pytest.mark.usefixtures("_short_and_small")
@pytest.mark.parametrize(
    "definition",
    [
        "string a",
        "string[] a",
        "uint8[] a",
        "float64[] a",
        "bool[] a",
        "time[] a",
        "Empty[] a",
        "Small[] a",
        "Varying[] a",
        "Holder[] a",
    ],
)
@pytest.mark.parametrize("tail", [b"", b"\0" * 64, LONGEST * 16])
def test_a_hostile_length_is_refused_before_anything_is_allocated(definition: str, tail: bytes) -> None:
    text = (
        f"{definition}\n{SEPARATOR}\nMSG: x/Empty\n{SEPARATOR}\nMSG: x/Small\nuint8 a\n"
        f"{SEPARATOR}\nMSG: x/Varying\nstring a\n{SEPARATOR}\nMSG: x/Holder\nEmpty e\n"
    )
    made = connection("/t", "x/Y", text)
    for read in (CODEC.compile(made, ("a",)), CODEC.compile(made, ()), lambda raw: CODEC.decode(made, raw)):
        with pytest.raises(TransportError, match="bytes do not fit"):
            read(LONGEST + tail)


@pytest.mark.usefixtures("_short_and_small")
@pytest.mark.parametrize(
    ("definition", "message"),
    [
        (f"Empty[4000000000] a\n{SEPARATOR}\nMSG: x/Empty\n", "holds 4000000000 messages without content"),
        ("".join(f"T{i} a\nT{i} b\n{SEPARATOR}\nMSG: x/T{i}\n" for i in range(30)) + "uint8 x", "fields with those it"),
        ("float64[4000000000] a", "bytes do not fit"),
        ("time[4000000000] a", "bytes do not fit"),
        (f"Small[4000000000] a\n{SEPARATOR}\nMSG: x/Small\nuint8 a", "bytes do not fit"),
        ("string[4000000000] a", "bytes do not fit"),
        ("float64[9999999999] a\nfloat64[9999999999] b", "bytes do not fit"),
    ],
)
def test_a_hostile_definition_is_refused_before_anything_is_allocated(definition: str, message: str) -> None:
    made = connection("/t", "x/Y", definition)
    for paths in ((), ("a",)):
        with pytest.raises(TransportError, match=message):
            CODEC.compile(made, paths)(b"\0" * 100)


@pytest.mark.usefixtures("_short_and_small")
def test_a_definition_of_very_many_fields_is_refused_soon() -> None:
    made = connection("/t", "x/Y", "\n".join(f"uint8 a{number}" for number in range(50_000)))
    with pytest.raises(TransportError, match="50000 fields with those it contains; at most 4096 are accepted"):
        CODEC.compile(made, ())


def test_a_message_of_many_deeply_nested_arrays_is_read() -> None:
    parts = "".join(f"{SEPARATOR}\nMSG: x/T{i}\nT{i + 1}[] t\n" for i in range(28))
    made = connection("/t", "x/Y", f"T0[] t\n{parts}{SEPARATOR}\nMSG: x/T28\nuint8 x\n")
    decoded = CODEC.decode(made, struct.pack("<I", 1) * 29 + b"\x07")
    for _ in range(29):
        (decoded,) = decoded["t"]
    assert decoded == {"x": 7}


KINDS = ("odd/Everything", "odd/Arrays", "visualization_msgs/MarkerArray", "rqt_mrta_py/TeamState", "nav_msgs/Odometry")
SEEDS = {name: CODEC.encode(name, {}) for name in KINDS}


@settings(max_examples=200, deadline=None)
@given(
    name=st.sampled_from(KINDS),
    changes=st.lists(st.tuples(st.integers(0, 700), st.binary(min_size=1, max_size=8)), max_size=4),
    cut=st.integers(0, 700),
    noise=st.none() | st.binary(max_size=300),
)
def test_any_bytes_are_read_or_refused_with_a_transport_error(
    name: str, changes: List[Tuple[int, bytes]], cut: int, noise: Optional[bytes]
) -> None:
    raw = bytearray(SEEDS[name] if noise is None else noise)
    for place, patch in changes:
        raw[place : place + len(patch)] = patch
    made = CODEC.connection("/t", name)
    data = bytes(raw[: len(raw) - cut % 7])
    outcomes = []
    for read in (CODEC.compile(made, ()), lambda raw: CODEC.decode(made, raw)):
        try:
            read(data)
            outcomes.append("read")
        except TransportError:
            outcomes.append("refused")
    # Whether a message fits does not depend on what is read of it.
    assert outcomes[0] == outcomes[1]
