"""The load of the benchmark ``review``: what four ALLIANCE robots say on twenty topics, for as long as is asked for.

Each robot has a behaviour set for each of five tasks, the last robot for four: nineteen topics of motivations. On the
twentieth the robots announce what they carry out, in turn. Every topic brings ten messages a second. A robot keeps its
task for half a minute, acquiesces, rests for four seconds and takes the next one.
"""

from __future__ import annotations

from pathlib import Path
from typing import Dict, Iterator, List, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Codec, Column, Connection, Page, Stamped
from rqt_mrta_py.transport import BagWriter, Compression

__all__ = ["ARCHITECTURE", "TOPICS", "write_load"]

ARCHITECTURE = "mrta_alliance"
"""Whose topics they are: each is a configured field of its ``rqt_mrta.xml``."""

TOPICS = 20

_NS = 1_000_000_000
_RATE = 10
_ROBOTS = tuple(f"robot{number}" for number in range(1, 5))
_TASKS = ("patrol", "inspect", "report", "sweep", "deliver")
_PAIRS = tuple((robot, task) for robot in _ROBOTS for task in _TASKS)[: TOPICS - 1]
_HELD, _RESTING = 30.0, 4.0
"""How long a robot keeps a task, and how long it has none [s]."""
_BEGINNING = 100.0
"""Receipt of the first message [s]."""
_IMPATIENCE, _THRESHOLD = 1.0, 30.0
_SEGMENT = 500
"""How many ticks are made at a time."""


def write_load(path: Path, messages: int, codec: Codec, compression: Compression = Compression.NONE) -> int:
    """Write a bag of so many messages, in whole ticks of one message a topic.

    Args:
        path: of the bag.
        messages: about how many.
        codec: knows ALLIANCE's types.
        compression: of the chunks.

    Returns:
        How many it holds.

    Raises:
        TransportError: a type is not known, or the bag cannot be written.
    """
    ticks = max(1, round(messages / TOPICS))
    with BagWriter(path, compression, replace=True) as writer:
        for first in range(0, ticks, _SEGMENT):
            for stamped in _segment(np.arange(first, min(first + _SEGMENT, ticks)), codec):
                writer.write(stamped)
    return ticks * TOPICS


def _segment(ticks: NDArray[np.int64], codec: Codec) -> Iterator[Stamped]:
    """Make the messages of some ticks, by time of receipt."""
    rows: List[Tuple[int, Connection, bytes]] = []
    for place, (robot, task) in enumerate(_PAIRS):
        topic = f"/{robot}/alliance/motivation/{task}"
        connection = codec.connection(topic, "alliance_msgs/Motivation", f"/{robot}/alliance")
        receipts = _receipts(ticks, place)
        page = codec.encode_columns(connection.type, _motivations(ticks, receipts, robot, task), len(ticks))
        rows += zip(receipts.tolist(), [connection] * len(ticks), _cut(page))
    for turn, robot in enumerate(_ROBOTS):
        connection = codec.connection(
            "/alliance/inter_robot_communication", "alliance_msgs/InterRobotCommunication", f"/{robot}/alliance"
        )
        its = ticks[ticks % len(_ROBOTS) == turn]
        receipts = _receipts(its, TOPICS - 1)
        # A robot that rests goes on about what it did, as those do that have not heard of their own end.
        tasks = [_TASKS[chosen] for chosen in _chosen(its, robot).tolist()]
        columns: Dict[str, Column] = {
            "header/stamp": receipts / _NS - 0.002,
            "header/frame_id": f"/{robot}",
            "task_id": tasks,
            "expected_duration": 60.0,
        }
        if len(its):
            page = codec.encode_columns(connection.type, columns, len(its))
            rows += zip(receipts.tolist(), [connection] * len(its), _cut(page))
    rows.sort(key=lambda row: row[0])
    for receipt_ns, connection, raw in rows:
        yield Stamped(connection, receipt_ns, raw)


def _receipts(ticks: NDArray[np.int64], place: int) -> NDArray[np.int64]:
    """Give the receipts of a topic's messages [ns]: evenly, but for up to a millisecond."""
    jitter = (ticks * 7919 + place * 104729) % 1000 * 1000
    offset = round(_BEGINNING * _NS) + place * (_NS // _RATE // TOPICS)
    receipts: NDArray[np.int64] = ticks * (_NS // _RATE) + offset + jitter
    return receipts


def _phase(ticks: NDArray[np.int64], robot: str) -> Tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Give which of its turns a robot is at, and since when [s]; robots begin five seconds apart."""
    time = ticks / _RATE + 5.0 * _ROBOTS.index(robot)
    turn = np.floor(time / (_HELD + _RESTING))
    return turn.astype(np.int64), time - turn * (_HELD + _RESTING)


def _chosen(ticks: NDArray[np.int64], robot: str) -> NDArray[np.int64]:
    """Give which task a robot is about, by its place among all."""
    turn, _ = _phase(ticks, robot)
    chosen: NDArray[np.int64] = (turn + _ROBOTS.index(robot)) % (len(_TASKS) - 1)
    return chosen


def _motivations(ticks: NDArray[np.int64], receipts: NDArray[np.int64], robot: str, task: str) -> Dict[str, Column]:
    _, since = _phase(ticks, robot)
    chosen = _chosen(ticks, robot) == _TASKS.index(task)
    active = chosen & (since < _HELD)
    return {
        "header/seq": ticks,
        "header/stamp": receipts / _NS - 0.002,
        "header/frame_id": f"/{robot}",
        "task_id": task,
        "impatience": _IMPATIENCE,
        "acquiescent": chosen & (since >= _HELD),
        "suppressed": ~chosen & (since < _HELD),
        "resetted": np.zeros(len(ticks), np.bool_),
        "applicable": np.ones(len(ticks), np.bool_),
        "motivation": np.where(active, _THRESHOLD, np.minimum(_THRESHOLD, _IMPATIENCE * since)),
        "threshold": _THRESHOLD,
        "active": active,
    }


def _cut(page: Page) -> List[bytes]:
    """Cut a page into its messages."""
    raws: List[bytes] = []
    place = 0
    for count, size in page.runs:
        end = place + count * size
        raws += [page.content[begin : begin + size] for begin in range(place, end, size)]
        place = end
    return raws
