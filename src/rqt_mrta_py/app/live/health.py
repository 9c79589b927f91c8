"""A supervisor's own health, as diagnostic_msgs/DiagnosticArray tells it: not the robots', which is its work."""

from __future__ import annotations

import os
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Outgoing

__all__ = ["DIAGNOSTICS_TOPIC", "Counts", "diagnostics", "memory_in_use"]

DIAGNOSTICS_TOPIC = "/diagnostics"
_TYPE = "diagnostic_msgs/DiagnosticArray"

_OK, _WARN, _ERROR = 0, 1, 2

_LONG_WAIT = 0.1
"""Longer than this nobody should wait to be heard [s]."""

_PAGE = os.sysconf("SC_PAGE_SIZE")

_Status = Tuple[int, str, Mapping[str, object]]


@dataclass(frozen=True)
class Counts:
    """What a supervisor has counted since it began.

    Attributes:
        heard: messages.
        topics: topics that brought any.
        unreadable: kinds of messages that could not be read.
        misfits: connections whose definitions do not fit.
        wrong_parameters: parameters that were not used, for they are of a wrong type.
        jumps: how often ROS time went back.
        master_lost: how often no master answered.
        mission: what is supervised; empty while nobody has said it.
        recorded: messages that are in the bag; None if nothing is recorded.
        backlog: messages that wait to be written.
        unrecorded: messages that found no room in the bag.
        recording: path of the bag.
        failure: why the recording has ended; empty if it goes on.
        drawn: pictures; None if none are drawn.
        undrawn: pictures left out, for one before them was not ready.
        picture_seconds: what the last one took [s].
        kept: messages that a snapshot would hold.
        kept_bytes: what they take in memory [bytes].
        kept_dropped: messages that went before their time.
        memory: that the process holds [bytes].
    """

    heard: int = 0
    topics: int = 0
    unreadable: int = 0
    misfits: int = 0
    wrong_parameters: int = 0
    jumps: int = 0
    master_lost: int = 0
    mission: str = ""
    recorded: Optional[int] = None
    backlog: int = 0
    unrecorded: int = 0
    recording: str = ""
    failure: str = ""
    drawn: Optional[int] = None
    undrawn: int = 0
    picture_seconds: float = 0.0
    kept: int = 0
    kept_bytes: int = 0
    kept_dropped: int = 0
    memory: int = 0


def diagnostics(
    node: str, now: float, counts: Counts, before: Counts, *, seconds: float, waits: Sequence[float]
) -> Outgoing:
    """Tell how a supervisor is.

    Args:
        node: its resolved name.
        now: the time [s].
        counts: what it has counted.
        before: what it had counted when this was told the last time.
        seconds: how long ago that is [s].
        waits: for the lock since then, each of whoever was served; where it is long, messages wait as long [s].
    """
    parts: Dict[str, _Status] = {
        "stream": _stream(counts, before, seconds),
        "hearing": _hearing(waits),
        "recording": _recording(counts, before),
        "pictures": _pictures(counts, before),
        "memory": _memory(counts, before),
    }
    status = [
        {
            "level": level,
            "name": f"{node.lstrip('/')}: {part}",
            "message": message,
            "hardware_id": "",
            "values": [{"key": key, "value": _text(value)} for key, value in values.items()],
        }
        for part, (level, message, values) in parts.items()
    ]
    return Outgoing(DIAGNOSTICS_TOPIC, _TYPE, {"header": {"stamp": now}, "status": status})


def memory_in_use() -> int:
    """Give what this process holds in memory [bytes]; 0 where the system does not tell."""
    try:
        return int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1]) * _PAGE
    except (OSError, ValueError, IndexError):
        return 0


def _stream(counts: Counts, before: Counts, seconds: float) -> _Status:
    rate = (counts.heard - before.heard) / seconds if seconds > 0 else 0.0
    values = {
        "mission": counts.mission,
        "messages": counts.heard,
        "messages a second": round(rate, 1),
        "topics": counts.topics,
        "unreadable": counts.unreadable,
        "misfits": counts.misfits,
        "wrong parameters": counts.wrong_parameters,
        "time went back": counts.jumps,
        "master lost": counts.master_lost,
    }
    if not counts.mission:
        return _WARN, "waits for somebody to say what the mission is", values
    if counts.heard == before.heard:
        return _WARN, "hears nothing", values
    wrong = counts.unreadable + counts.misfits + counts.wrong_parameters
    return (_WARN, "cannot read all that it hears", values) if wrong else (_OK, f"hears {rate:.0f}/s", values)


def _hearing(waits: Sequence[float]) -> _Status:
    longest = max(waits, default=0.0)
    values = {
        "wait, mean [ms]": _milliseconds(_mean(waits)),
        "wait, longest [ms]": _milliseconds(longest),
        "threads": threading.active_count(),
    }
    return (_WARN, "messages wait to be heard", values) if longest > _LONG_WAIT else (_OK, "keeps up", values)


def _recording(counts: Counts, before: Counts) -> _Status:
    if counts.recorded is None:
        return _OK, "off", {}
    values = {
        "bag": counts.recording,
        "messages": counts.recorded,
        "waiting": counts.backlog,
        "dropped": counts.unrecorded,
    }
    if counts.failure:
        return _ERROR, f"has ended: {counts.failure}", values
    return (_WARN, "drops messages", values) if counts.unrecorded > before.unrecorded else (_OK, "records", values)


def _pictures(counts: Counts, before: Counts) -> _Status:
    if counts.drawn is None:
        return _OK, "off", {}
    values = {
        "drawn": counts.drawn,
        "left out": counts.undrawn,
        "the last took [ms]": _milliseconds(counts.picture_seconds),
    }
    late = counts.undrawn > before.undrawn
    return (_WARN, "pictures take longer than their period", values) if late else (_OK, "draws", values)


def _memory(counts: Counts, before: Counts) -> _Status:
    values = {
        "resident [MB]": round(counts.memory / 1e6, 1),
        "messages kept for snapshots": counts.kept,
        "they take [MB]": round(counts.kept_bytes / 1e6, 1),
        "dropped from them": counts.kept_dropped,
    }
    short = counts.kept_dropped > before.kept_dropped
    return (_WARN, "snapshots reach less far back than wanted", values) if short else (_OK, "enough", values)


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values) if values else 0.0


def _milliseconds(seconds: float) -> float:
    return round(1000.0 * seconds, 2)


def _text(value: Any) -> str:
    return value if isinstance(value, str) else repr(value)
