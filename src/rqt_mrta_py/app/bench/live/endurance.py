"""Many messages for long: is any dropped, does memory grow?"""

from __future__ import annotations

import json
import time
from typing import List

from rqt_mrta_py.app.bench.live.session import LiveSession, resident_bytes
from rqt_mrta_py.app.bench.live.team_load import TOPICS
from rqt_mrta_py.hooks import BenchmarkTable

__all__ = ["measure_endurance"]

_LOOKS = 20
"""How often memory is looked at."""


def measure_endurance(session: LiveSession, seconds: float) -> BenchmarkTable:
    """Let a supervisor hear a thousand messages a second.

    Args:
        session: a graph.
        seconds: how long [s].
    """
    kept = min(30.0, seconds / 5.0)
    rate = 1000.0 / TOPICS
    arguments = ("--rate", f"{rate:g}", "--seconds", f"{seconds:g}")
    load = session.module("team_load", "rqt_mrta_py.app.bench.live.team_load", *arguments)
    load.line()
    supervisor = session.module("supervisor", "rqt_mrta_py.app.bench.live.watched_supervisor", "--kept", f"{kept:g}")
    supervisor.line()
    load.line()
    load.tell("go")
    sizes: List[float] = []
    for _ in range(_LOOKS):
        time.sleep(seconds / _LOOKS)
        sizes.append(resident_bytes(supervisor.process.pid) / 1e6)
    told = json.loads(load.line())
    time.sleep(1.0)
    counted = json.loads(supervisor.end()[-1])
    load.end()
    half = sizes[_LOOKS // 2]
    return BenchmarkTable(
        title=f"A thousand messages a second for {seconds:g} s",
        columns=("published", "heard", "dropped", "memory at half time [MB]", "at the end [MB]", "growth [MB]"),
        rows=(
            (
                told["published"],
                counted["heard"],
                told["published"] - counted["heard"],
                round(half, 1),
                round(sizes[-1], 1),
                round(sizes[-1] - half, 1),
            ),
        ),
        notes=(
            f"The last {kept:g} s are kept for snapshots. The latest turn of the {TOPICS} topics' publisher came "
            f"{1000.0 * told['late']:.0f} ms late.",
        ),
    )
