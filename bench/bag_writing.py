"""How many messages a second a bag takes in: this project's writer beside the stock one of rosbags.

Both write the same messages in the same process, turn by turn, and the best of several turns counts; in every other
turn the stock writer goes first. The stock writer keeps up to a MiB in memory; this project's writes at least once a
second of the stream's time, so its bags of few robots are the larger ones. From a checkout:
``python -m bench.bag_writing``.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from itertools import chain
from pathlib import Path
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport import BagWriter, Batch, Compression

__all__ = ["BagWritingRow", "main", "measure_bag_writing"]

_MD5 = "992ce8a1687cec8c8bd883ec73ca41d1"
_RATE = 10
"""How often each connection speaks [Hz]."""

_BYTES = (52, 83, 207, 727)
"""Lengths of messages: a stamped number, a pose, a scan of 36 rays, an odometry; a quarter of the connections has each
[bytes]."""

_TURNS = 6

_Write = Callable[[Sequence[Batch], Compression, Path], None]


class BagWritingRow(NamedTuple):
    """One comparison.

    Attributes:
        compression: of the chunks.
        connections: number of them.
        messages: number of them.
        ours: messages a second of CPU time, this project's writer with a checkpoint each second of the stream.
        together: the same of ours, handed over in batches of a tick.
        stock: messages a second of CPU time, rosbags' writer as it comes.
        our_bytes: length of this project's bag [bytes].
        stock_bytes: length of rosbags' bag [bytes].
    """

    compression: str
    connections: int
    messages: int
    ours: float
    together: float
    stock: float
    our_bytes: int
    stock_bytes: int

    @property
    def ratio(self) -> float:
        """Tell how many times as fast as the stock writer this project's is, message by message."""
        return self.ours / self.stock


def measure_bag_writing(connections: int, messages: int, folder: Path) -> List[BagWritingRow]:
    """Measure each compression.

    Args:
        connections: number of publishers, each at 10 Hz of the stream's time.
        messages: number of messages in each bag.
        folder: for the bags, which are removed again.

    Returns:
        One row for each compression.

    Raises:
        TransportError: the folder cannot be written.
        MissingDependencyError: a library is not installed.
    """
    ticks = _ticks(connections, messages)
    writers: Tuple[_Write, ...] = (_write_ours, _write_together, _write_stock)
    rows = []
    for compression in Compression:
        best: Dict[_Write, float] = {}
        sizes: Dict[_Write, int] = {}
        for turn in range(_TURNS):
            for write in writers[:: 1 if turn % 2 == 0 else -1]:
                path = folder / "bag_writing.bag"
                start = time.process_time()
                write(ticks, compression, path)
                spent = time.process_time() - start
                best[write] = min(spent, best.get(write, spent))
                sizes[write] = path.stat().st_size
                path.unlink()
        ours, together, stock = (messages / best[write] for write in writers)
        lengths = sizes[_write_ours], sizes[_write_stock]
        rows.append(BagWritingRow(compression.value, connections, messages, ours, together, stock, *lengths))
    return rows


def _ticks(connections: int, messages: int) -> List[Batch]:
    known = tuple(
        Connection(f"/robot{number}/data", "std_msgs/String", _MD5, "string data\n", f"/robot{number}/driver")
        for number in range(connections)
    )
    lengths = [_BYTES[len(_BYTES) * number // connections] for number in range(connections)]
    # Compressible as messages are: mostly equal bytes, some of which change from message to message.
    body = bytes(range(256)) * 4
    ticks = []
    for first in range(0, messages, connections):
        speakers = known if first + connections <= messages else known[: messages - first]
        raws = [(first + at).to_bytes(8, "little") + body[: lengths[at] - 8] for at in range(len(speakers))]
        ticks.append(Batch.of(speakers, 10**9 + first // connections * (10**9 // _RATE), raws))
    return ticks


def _write_ours(ticks: Sequence[Batch], compression: Compression, path: Path) -> None:
    with BagWriter(path, compression) as writer:
        for tick in ticks:
            for stamped in tick:
                writer.write(stamped)


def _write_together(ticks: Sequence[Batch], compression: Compression, path: Path) -> None:
    with BagWriter(path, compression) as writer:
        for tick in ticks:
            writer.write_batch(tick)


def _write_stock(ticks: Sequence[Batch], compression: Compression, path: Path) -> None:
    from rosbags.rosbag1 import Writer

    writer = Writer(path)
    if compression is not Compression.NONE:
        writer.set_compression(Writer.CompressionFormat[compression.name])
    with writer:
        targets: Dict[int, Any] = {}
        for connection, receipt_ns, raw in chain.from_iterable(ticks):
            target = targets.get(id(connection))
            if target is None:
                target = targets[id(connection)] = writer.add_connection(
                    connection.topic,
                    "std_msgs/msg/String",
                    msgdef=connection.definition,
                    md5sum=connection.md5,
                    callerid=connection.caller,
                )
            writer.write(target, receipt_ns, raw)


def main(argv: Optional[Sequence[str]] = None) -> None:
    """Measure, and print a table.

    Args:
        argv: arguments without the program's name; None for the process's own.
    """
    parser = argparse.ArgumentParser(prog="python -m bench.bag_writing", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--connections", metavar="N", type=int, default=50, help="number of publishers (default: 50)")
    parser.add_argument("--messages", metavar="N", type=int, default=100_000, help="in each bag (default: 100000)")
    options = parser.parse_args(argv)
    if min(options.connections, options.messages) < 1:
        parser.error("--connections and --messages must be at least 1")
    with tempfile.TemporaryDirectory() as folder:
        rows = measure_bag_writing(options.connections, options.messages, Path(folder))
    print(f"Messages a second of CPU time: {options.messages} messages of {options.connections} connections")
    heads = ("BagWriter", "together", "rosbags", "ratio", "our MB", "their MB")
    print("compression ", *(f"{head:>{width}}" for head, width in zip(heads, (10, 10, 10, 6, 8, 8))))
    for row in rows:
        print(
            f"{row.compression:12} {row.ours:10.0f} {row.together:10.0f} {row.stock:10.0f} {row.ratio:6.2f} "
            f"{row.our_bytes / 1e6:8.2f} {row.stock_bytes / 1e6:8.2f}"
        )


if __name__ == "__main__":
    main()
