"""What the transport's tests share."""

from __future__ import annotations

import subprocess
from itertools import groupby
from pathlib import Path
from typing import Callable, Iterable, List, Optional, Sequence, Tuple

import pytest

from rqt_mrta_py.hooks import Connection, Outgoing, Stamped, Subscription
from rqt_mrta_py.transport import BagWriter, Batch, Node

ROOT = Path(__file__).resolve().parents[2]
ROS_PYTHON = "/usr/bin/python3"

# Types that no package declares: every kind of field that ROS has, and what only odd definitions hold.
ODD_TYPES = {
    "odd/Everything": "\n".join(
        [f"{name} a_{name}" for name in ("bool", "byte", "char", "int8", "int16", "int32", "int64")]
        + [f"{name} a_{name}" for name in ("uint8", "uint16", "uint32", "uint64", "float32", "float64", "string")]
        + ["time a_time", "duration a_duration", "odd/Inner inner", "Empty nothing"]
    ),
    "odd/Arrays": "\n".join(
        ["bool[] bools", "byte[] signed", "char[] chars", "uint8[] raw", "uint8[4] four", "float32[] floats"]
        + ["float64[3] three", "int64[] wide", "string[] words", "string[2] pair", "time[] times"]
        + ["duration[2] spans", "Inner[] inners", "Inner[2] two", "Fixed[] plain", "Fixed[2] plains", "Empty[] empties"]
    ),
    "odd/Inner": "uint8 count\nstring name\nfloat64[] values",
    "odd/Fixed": "int16 x\ntime t\nbool[2] flags",
    "odd/Empty": "",
}


def lookup(type_name: str) -> Optional[str]:
    """Find the text of a type of this repository."""
    package, _, message = type_name.partition("/")
    for folder in (ROOT / "msg" if package == "rqt_mrta_py" else ROOT / "plugins" / "messages" / package / "msg",):
        path = folder / f"{message}.msg"
        if path.exists():
            return path.read_text()
    return ODD_TYPES.get(type_name)


def connection(topic: str, type_name: str, definition: str, caller: str = "", md5: str = "0" * 32) -> Connection:
    return Connection(topic, type_name, md5, definition, caller)


def run_ros(arguments: Sequence[str], **options: object) -> subprocess.CompletedProcess[str]:
    """Run a ROS tool or script, which must succeed."""
    return subprocess.run(  # type: ignore[call-overload,no-any-return]
        arguments, check=True, capture_output=True, text=True, timeout=60, **options
    )


def require_ros(module: str) -> None:
    """Skip a test where ROS's own Python lacks a module."""
    found = subprocess.run([ROS_PYTHON, "-c", f"import {module}"], capture_output=True, check=False, timeout=60)
    if found.returncode:
        pytest.skip(f"ROS 1 is not on this machine: {ROS_PYTHON} has no {module}")


class ListLink:
    """A link that answers what it was told, and remembers what it was asked."""

    def __init__(self, answer: Callable[[str, str], Sequence[float]] = lambda sender, receiver: (0.0,)) -> None:
        self.answer = answer
        self.asked: List[Tuple[str, str, float]] = []

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        self.asked.append((sender, receiver, now))
        return self.answer(sender, receiver)


def text(topic: str, data: str = "", latched: bool = False) -> Outgoing:
    """Say a text."""
    return Outgoing(topic, "std_msgs/String", {"data": data}, latched)


def listen(node: Node, topic: str, into: List[str], type_name: str = "std_msgs/String") -> None:
    """Let a node note the texts that it hears."""
    node.subscribe(Subscription(topic, type_name, ("data",)), lambda heard: into.append(heard.fields["data"]))


def batches(stream: Iterable[Stamped]) -> List[Batch]:
    """Put neighbours that were received at one moment together."""
    together = []
    for receipt_ns, run in groupby(stream, lambda stamped: stamped.receipt_ns):
        connections, _, raws = zip(*run)
        together.append(Batch.of(connections, receipt_ns, raws))
    return together


def write_together(writer: BagWriter, stream: Iterable[Stamped]) -> None:
    """Write what was received at one moment in one go."""
    for batch in batches(stream):
        writer.write_batch(batch)
