"""How fast bags are reviewed: beside rosbag's ``Bag.read_messages``, and as they grow."""

from __future__ import annotations

import argparse
import resource
import shutil
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any, List, NamedTuple, Optional, Tuple

from rqt_mrta_py.app.bench.apart import apart
from rqt_mrta_py.app.bench.review_load import ARCHITECTURE, write_load
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.review.request import ReviewRequest
from rqt_mrta_py.app.review.review import review_bag
from rqt_mrta_py.app.review.skimming import Skimming
from rqt_mrta_py.config.mission import load_observed
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable
from rqt_mrta_py.transport import Compression, ConnectionList, read_bag_info, read_blocks

__all__ = ["add_arguments", "measure"]

_MB = 1_000_000
_BYTES = 127
"""What a message of the load takes in a bag, about [bytes]."""

_ROSBAG = """
import sys, time
import rosbag
wall, processor, count = time.perf_counter(), time.process_time(), 0
with rosbag.Bag(sys.argv[1]) as bag:
    for topic, message, stamp in bag.read_messages():
        count += 1
print(count, time.perf_counter() - wall, time.process_time() - processor)
"""


class _Speed(NamedTuple):
    """What one reading took.

    Attributes:
        messages: that were read.
        wall: [s].
        processor: [s].
        memory: the most that was held [bytes]; 0 if unknown.
        events: that came of it.
    """

    messages: int
    wall: float
    processor: float
    memory: int = 0
    events: int = 0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    parser.add_argument(
        "--messages",
        metavar="N",
        type=int,
        default=1_000_000,
        help="of the bag that rosbag reads too (default: 1000000)",
    )
    parser.add_argument(
        "--sizes", metavar="MB,...", type=_sizes, default=(), help="of further bags, for instance 10,100,1000,2000"
    )
    parser.add_argument(
        "--python",
        metavar="FILE",
        default="/usr/bin/python3",
        help="a Python that has rosbag (default: /usr/bin/python3)",
    )
    parser.add_argument(
        "--folder", metavar="DIR", type=Path, help="for the bags (default: the system's for such files)"
    )


def measure(options: argparse.Namespace) -> BenchmarkReport:
    """Write bags and read them."""
    folder = Path(tempfile.mkdtemp(prefix="mrta-bench-", dir=options.folder))
    try:
        tables = [_beside_rosbag(folder, options.messages, options.python)]
        if options.sizes:
            tables.append(_growing(folder, options.sizes))
    finally:
        shutil.rmtree(folder)
    return BenchmarkReport(tuple(tables))


def _beside_rosbag(folder: Path, messages: int, python: str) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    bag = folder / "load.bag"
    for compression in (Compression.NONE, Compression.LZ4):
        apart(_write, bag, messages, compression)
        stock = _read_by_rosbag(python, bag)
        supervised = apart(_supervise, bag)
        ours = apart(_review, bag, folder / "review")
        for name, speed in (
            ("rosbag.Bag.read_messages", stock),
            ("states and events", supervised),
            ("mrta review --pictures 0", ours),
        ):
            rows.append((compression.value, name, *_figures(speed, stock)))
        bag.unlink()
        shutil.rmtree(folder / "review")
    return BenchmarkTable(
        title="Reading bags of ALLIANCE's own messages on 20 topics, each a configured field",
        columns=("chunks", "reader", "messages", "messages / wall s", "messages / CPU s", "times", "MB held", "events"),
        rows=tuple(rows),
        notes=(
            "States and events are all that the supervisor derives, incidents and statistics among it; a review adds "
            "clocks, the communication graph and the page with its curves. Of what rosbag hands on nothing is made.",
            "Times: messages a second of processor time as a multiple of rosbag's, imports left out on both sides.",
        ),
    )


def _growing(folder: Path, sizes: Tuple[int, ...]) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    for size in sizes:
        bag = folder / f"{size}.bag"
        apart(_write, bag, size * _MB // _BYTES, Compression.NONE)
        length = bag.stat().st_size / _MB
        speed = apart(_review, bag, folder / "review")
        rows.append(
            (
                round(length),
                speed.messages,
                round(speed.wall, 2),
                round(speed.processor, 2),
                round(1000 * speed.processor / length, 2),
                round(speed.memory / _MB),
            )
        )
        bag.unlink()
        shutil.rmtree(folder / "review")
    return BenchmarkTable(
        title="Bags that grow, of the same messages",
        columns=("MB", "messages", "wall s", "CPU s", "CPU ms / MB", "MB held"),
        rows=tuple(rows),
    )


def _figures(speed: Optional[_Speed], stock: Optional[_Speed]) -> Tuple[Any, ...]:
    if speed is None:
        return (None,) * 6
    rate = speed.messages / speed.processor
    times = None if stock is None else round(rate / (stock.messages / stock.processor), 2)
    memory = round(speed.memory / _MB) if speed.memory else None
    return speed.messages, round(speed.messages / speed.wall), round(rate), times, memory, speed.events or None


def _read_by_rosbag(python: str, bag: Path) -> Optional[_Speed]:
    """Read a bag by rosbag; None where it is not there."""
    try:
        done = subprocess.run([python, "-c", _ROSBAG, str(bag)], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    count, wall, processor = done.stdout.split()
    return _Speed(int(count), float(wall), float(processor))


def _write(bag: Path, messages: int, compression: Compression) -> int:
    return write_load(bag, messages, compose().codec(), compression)


def _supervise(bag: Path) -> _Speed:
    """Derive states and events from a bag, and nothing else."""
    host = compose()
    codec = host.codec()
    mission = load_observed(host.registry, ARCHITECTURE)
    # Plugins are imported when they are first asked for.
    observation = Observation(mission, codec, host.manager, None, panels=False)
    processor, wall = time.process_time(), time.perf_counter()
    skimming, messages = Skimming(observation), 0
    for block in read_blocks(bag, ConnectionList()):
        skimming.feed(block)
        messages += len(block)
    events = len(observation.finish().events)
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    return _Speed(messages, wall, processor, memory, events)


def _review(bag: Path, folder: Path) -> _Speed:
    """Review a bag without pictures."""
    host = compose()
    messages = read_bag_info(bag).messages
    processor, wall = time.process_time(), time.perf_counter()
    request = ReviewRequest(bag, architecture=ARCHITECTURE, out=folder, pictures=0.0)
    result = review_bag(host, request, lambda passed, planned: None)
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    # In KiB.
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    return _Speed(messages, wall, processor, memory, len(result.record.events))


def _sizes(text: str) -> Tuple[int, ...]:
    parts = text.split(",")
    if not all(part.isdigit() and int(part) for part in parts):
        raise argparse.ArgumentTypeError(f"{text!r}: whole numbers of megabytes are expected, as in 10,100")
    return tuple(int(part) for part in parts)
