"""What a recording keeps that is killed."""

from __future__ import annotations

import signal
import time

from rqt_mrta_py.app.bench.live.session import LiveSession, until
from rqt_mrta_py.app.bench.live.team_load import TOPICS
from rqt_mrta_py.hooks import BenchmarkTable
from rqt_mrta_py.transport import ChunkWalk

__all__ = ["measure_crash"]


def measure_crash(session: LiveSession, seconds: float) -> BenchmarkTable:
    """Record a thousand messages a second, kill the recorder, and see what is in the bag.

    Args:
        session: a graph.
        seconds: how long to record [s].
    """
    rate = 1000.0 / TOPICS
    load = session.module("team_load", "rqt_mrta_py.app.bench.live.team_load", "--rate", f"{rate:g}")
    load.line()
    bag = session.folder / "killed.bag"
    recorder = session.node("recorder", f"_record:={bag}", "_topics:=/robot*")
    load.line()
    load.tell("go")
    active = bag.with_name(f"{bag.name}.active")
    until(active.exists, "the recording")
    began = time.time()
    time.sleep(seconds)
    recorder.process.send_signal(signal.SIGKILL)
    killed = time.time()
    recorder.end()
    load.end()
    stamps = [stamped.receipt_ns / 1e9 for stamped in ChunkWalk(active)]
    expected = sum(stamp <= stamps[-1] for stamp in stamps)
    gap = max(after - before for before, after in zip(stamps, stamps[1:]))
    return BenchmarkTable(
        title=f"A recording of a thousand messages a second, killed with SIGKILL after {seconds:g} s",
        columns=("messages kept", "first after [s]", "lost at the end [s]", "longest gap [s]"),
        rows=((expected, round(max(stamps[0] - began, 0.0), 3), round(killed - stamps[-1], 3), round(gap, 3)),),
    )
