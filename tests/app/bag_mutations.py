"""Bags made hostile: flipped, cut, overwritten, swapped; lengths and counts that lie, definitions that are wrong."""

from __future__ import annotations

import dataclasses
import random
import re
import struct
from pathlib import Path
from typing import Callable, List, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import BagWriter, Compression, RosCodec

__all__ = ["HOSTILE_DEFINITIONS", "HOSTILE_TEXTS", "MUTATIONS", "injected", "mutated", "recording"]

SECOND = 10**9
KINDS = ("InterRobotCommunication", "Motivation")
_LENGTHS = [0, 1, 3, 4, 255, 2**16, 2**20 + 1, 2**30, 2**30 + 1, 2**31 - 1, 2**31, 2**32 - 1]
_FIELD = re.compile(
    rb"(count|chunk_count|conn_count|size|conn|ver|time|index_pos|chunk_pos|start_time|end_time)=", re.DOTALL
)
_WIDTH = {b"time": 8, b"index_pos": 8, b"chunk_pos": 8, b"start_time": 8, b"end_time": 8}
_RECORD = re.compile(rb"\x04\0\0\0op=[\x02-\x07]", re.DOTALL)

HOSTILE_TEXTS = (
    "</script><script>alert(1)</script>",
    '"><img src=x onerror=alert(1)>',
    "<svg/onload=alert(1)>",
    "../../../../tmp/outside",
    "/etc/passwd",
    "..",
    "a\nb\tc",
    "\x1b[31mred\x07",
    "\u202eright to left",
    "nul\0nul",
    "{{7*7}} ${jndi} %s %n",
    "'; DROP TABLE robots; --",
    "=1+1",
    " ",
    "x" * 5000,
)
"""Ids and topics as nobody would choose them who means well."""

HOSTILE_DEFINITIONS = (
    "",
    "string",
    "string task_id\nstring task_id\n",
    "std_msgs/Header header\n",
    "Header header\nfloat64[4000000000] task_id\n",
    "Unknown header\n",
    "Header header\nstring[] task_id\nduration expected_duration\n",
    "Header header\nfloat64 task_id\nduration expected_duration\n",
    "A a\n" + "=" * 80 + "\nMSG: alliance_msgs/A\nA a\n",
    "uint8[2147483647] header\n",
    "string class\nstring import\nstring __class__\n",
    "string a=\nint32 b = 99999999999\n",
    "#" * 100_000,
    "\0\xff\n",
    "".join(f"T{i} a\nT{i} b\n{'=' * 80}\nMSG: x/T{i}\n" for i in range(30)) + "uint8 x\n",
)
"""What a connection may say of its messages, and does not hold."""


def _definition(root: Path, type_name: str) -> Optional[str]:
    package, _, name = type_name.partition("/")
    path = root / "plugins" / "messages" / package / "msg" / f"{name}.msg"
    return path.read_text(encoding="utf-8") if path.exists() else None


def injected(root: Path, path: Path) -> None:
    """Record robots whose ids, tasks, topics and nodes are the hostile texts, and one definition full of them.

    Args:
        root: of the checkout.
        path: of the bag.
    """
    codec = RosCodec(lambda type_name: _definition(root, type_name))
    spoken, moved = (codec.connection("/alliance/inter_robot_communication", f"alliance_msgs/{kind}") for kind in KINDS)
    with BagWriter(path) as writer:
        for tick in range(3):
            for number, text in enumerate(HOSTILE_TEXTS):
                time = SECOND * (tick + 1) + number
                header = {"seq": tick, "stamp": time / SECOND, "frame_id": text}
                fields = {"header": header, "task_id": text}
                comment = "".join(f"# {line}\n" for line in text.splitlines())
                caller = f"/{text}"
                speaks = dataclasses.replace(spoken, caller=caller, definition=comment + spoken.definition)
                moves = dataclasses.replace(moved, topic=f"/{text}/alliance/motivation/{text}", caller=caller)
                said = {**fields, "expected_duration": 60.0}
                moving = {**fields, "motivation": float(tick), "threshold": 10.0}
                writer.write(Stamped(speaks, time, codec.encode(speaks.type, said)))
                writer.write(Stamped(moves, time, codec.encode(moves.type, moving)))


def recording(root: Path, path: Path, compression: Compression, rng: random.Random, hostile: bool) -> bytes:
    """Record two ALLIANCE robots for some seconds.

    Args:
        root: of the checkout.
        path: of the bag.
        compression: of its chunks.
        rng: decides what is hostile.
        hostile: whether ids, topics, callers and definitions are.

    Returns:
        The bag's bytes.
    """
    codec = RosCodec(lambda type_name: _definition(root, type_name))

    def connection(topic: str, kind: str, caller: str) -> Connection:
        made = codec.connection(topic, f"alliance_msgs/{kind}", caller)
        if hostile and rng.random() < 0.5:
            definition = rng.choice(HOSTILE_DEFINITIONS) if rng.random() < 0.5 else made.definition
            text = rng.choice(HOSTILE_TEXTS)
            name = topic if rng.random() < 0.5 else f"/{text}/alliance/motivation/{text}"
            return dataclasses.replace(made, topic=name, definition=definition, caller=rng.choice([caller, text]))
        return made

    def said(text: str) -> str:
        return rng.choice(HOSTILE_TEXTS) if hostile and rng.random() < 0.3 else text

    messages: List[Stamped] = []
    for number, robot in enumerate(("robot1", "robot2")):
        speaks = connection(
            "/alliance/inter_robot_communication", "InterRobotCommunication", f"/{robot}/alliance/high_level"
        )
        moves = connection(f"/{robot}/alliance/motivation/patrol", "Motivation", f"/{robot}/alliance/high_level")
        for tick in range(16):
            time = SECOND + tick * SECOND // 2 + number
            header = {"seq": tick, "stamp": time / SECOND, "frame_id": said(f"/{robot}")}
            task = said("patrol" if number else "inspect")
            motivation = {
                "header": header,
                "task_id": task,
                "motivation": float(tick),
                "threshold": 10.0,
                "active": True,
            }
            messages.append(Stamped(moves, time, codec.encode("alliance_msgs/Motivation", motivation)))
            if tick % 3 == number:
                spoken = {"header": header, "task_id": task, "expected_duration": 60.0}
                raw = codec.encode("alliance_msgs/InterRobotCommunication", spoken)
                messages.append(Stamped(speaks, time + 5, raw))
    with BagWriter(path, compression) as writer:
        for stamped in sorted(messages, key=lambda each: each.receipt_ns):
            writer.write(stamped)
    return path.read_bytes()


def _flip(rng: random.Random, data: bytearray) -> None:
    for _ in range(rng.choice([1, 1, 2, 8, 64])):
        data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)


def _flip_headers(rng: random.Random, data: bytearray) -> None:
    """Flip bits near the beginnings of records, where they matter."""
    places = [match.start() for match in _RECORD.finditer(data)]
    for _ in range(rng.choice([1, 2, 4])):
        place = rng.choice(places) + rng.randrange(-40, 60)
        if 0 <= place < len(data):
            data[place] ^= 1 << rng.randrange(8)


def _cut(rng: random.Random, data: bytearray) -> None:
    del data[rng.randrange(len(data)) :]


def _cut_out(rng: random.Random, data: bytearray) -> None:
    begin = rng.randrange(len(data))
    del data[begin : begin + rng.choice([1, 4, 100, 5000])]


def _overwrite(rng: random.Random, data: bytearray) -> None:
    begin = rng.randrange(len(data))
    length = min(rng.choice([1, 4, 100, 5000]), len(data) - begin)
    data[begin : begin + length] = rng.choice([bytes(length), b"\xff" * length, rng.randbytes(length)])


def _insert(rng: random.Random, data: bytearray) -> None:
    begin, origin = rng.randrange(len(data)), rng.randrange(len(data))
    data[begin:begin] = data[origin : origin + rng.choice([1, 4, 100, 5000])]


def _swap_chunks(rng: random.Random, data: bytearray) -> None:
    """Exchange, repeat or leave out whole chunks, so that no position in the index is right any more."""
    begins = _chunks(data)
    if len(begins) < 3:
        return _insert(rng, data)
    one, other = sorted(rng.sample(range(len(begins) - 1), 2))
    a, b = data[begins[one] : begins[one + 1]], data[begins[other] : begins[other + 1]]
    a, b = rng.choice([(b, a), (a, a), (b, bytearray()), (a + b, a)])
    data[begins[other] : begins[other + 1]] = b
    data[begins[one] : begins[one + 1]] = a
    return None


def _lie_of_a_length(rng: random.Random, data: bytearray) -> None:
    """Replace the length of a header, a field or of data."""
    places = [match.start() for match in _RECORD.finditer(data)]
    place = rng.choice(places) + rng.choice([0, -4, 12, 8])
    claimed = rng.choice([*_LENGTHS, rng.getrandbits(32)])
    if 0 <= place <= len(data) - 4:
        data[place : place + 4] = struct.pack("<I", claimed)


def _lie_of_a_count(rng: random.Random, data: bytearray) -> None:
    """Replace a number that a header gives: counts, sizes, connections, positions, times."""
    found = rng.choice(list(_FIELD.finditer(data)))
    width = _WIDTH.get(found.group(1), 4)
    claimed = rng.choice([*_LENGTHS, rng.getrandbits(8 * width), len(data), len(data) + 1, 13])
    data[found.end() : found.end() + width] = (claimed % 2 ** (8 * width)).to_bytes(width, "little")


def _claim_nothing(rng: random.Random, data: bytearray) -> None:
    """Let records have no length."""
    for match in rng.choices(list(_RECORD.finditer(data)), k=rng.choice([1, 3, 20])):
        place = match.start() + rng.choice([-4, 0, 9])
        if 0 <= place <= len(data) - 4:
            data[place : place + 4] = bytes(4)


def _nothing(rng: random.Random, data: bytearray) -> None:
    """Leave the bag as it is: what is in it is hostile enough."""


MUTATIONS: Sequence[Tuple[str, Callable[[random.Random, bytearray], None]]] = (
    ("flip", _flip),
    ("flip_headers", _flip_headers),
    ("cut", _cut),
    ("cut_out", _cut_out),
    ("overwrite", _overwrite),
    ("insert", _insert),
    ("swap_chunks", _swap_chunks),
    ("lie_of_a_length", _lie_of_a_length),
    ("lie_of_a_count", _lie_of_a_count),
    ("claim_nothing", _claim_nothing),
    ("nothing", _nothing),
)


def mutated(rng: random.Random, whole: bytes) -> bytes:
    """Make a bag hostile in one, two or three ways."""
    data = bytearray(whole)
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        if len(data) > 100 and _RECORD.search(data) and _FIELD.search(data):
            rng.choice(MUTATIONS)[1](rng, data)
    return bytes(data)


def _chunks(data: bytearray) -> List[int]:
    """Find where chunks begin: their first field is ``compression``."""
    return [match.start() - 8 for match in re.finditer(rb"compression=(none|bz2|lz4)", data) if match.start() >= 8]
