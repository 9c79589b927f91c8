"""A stream without end, and a process that records it until it is killed."""

from __future__ import annotations

import os
import random
import struct
from pathlib import Path
from typing import Iterator

from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import BagWriter, Compression

REPORT = struct.Struct("<QQ")
"""Number of a message and its receipt [ns]."""

_POOL = 200_000
_SECOND = 10**9


def endless(seed: int) -> Iterator[Stamped]:
    """A stream that depends on its seed alone: ten connections, messages of many lengths, up to 5 ms apart."""
    chance = random.Random(seed)
    connections = [
        Connection(f"/robot{number}/data", "std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", "string data\n", "/n")
        for number in range(10)
    ]
    pool = chance.getrandbits(8 * _POOL).to_bytes(_POOL, "little")
    receipt_ns, number = _SECOND, 0
    while True:
        begin = chance.randrange(_POOL - 5000)
        body = struct.pack("<Q", number) + pool[begin : begin + chance.choice((0, 50, 200, 700, 5000))]
        yield Stamped(chance.choice(connections), receipt_ns, struct.pack("<I", len(body)) + body)
        receipt_ns += chance.randrange(5_000_000)
        number += 1


def record_for_ever(path: Path, seed: int, compression: Compression) -> None:
    """Write, and tell number and receipt of each tenth message on stdout once it is written."""
    writer = BagWriter(path, compression)
    for number, stamped in enumerate(endless(seed)):
        writer.write(stamped)
        if number % 10 == 0:
            os.write(1, REPORT.pack(number, stamped.receipt_ns))
