"""Processor time of a supervisor beside a bare subscriber to the same topics, in one run."""

from __future__ import annotations

import sys
import time
from typing import Any, Dict, List, Tuple

from rqt_mrta_py.app.bench.live.session import LiveSession, Member, processor_seconds
from rqt_mrta_py.app.bench.live.team_load import TOPICS, topics
from rqt_mrta_py.hooks import BenchmarkTable

__all__ = ["measure_processor"]

# What anybody would write with rospy alone; a text, for rospy has one door in this package.
_BARE = """\
import sys, rospy
rospy.init_node("bare", disable_signals=True)
count = 0
def take(message):
    global count
    count += 1
subscribers = [rospy.Subscriber(topic, rospy.AnyMsg, take, tcp_nodelay=True) for topic in sys.argv[1:]]
print("ready", flush=True)
sys.stdin.read()
rospy.signal_shutdown("done")
"""

_CASES = (
    ("supervisor", ()),
    ("supervisor, recording", ("record",)),
    ("supervisor, pictures a second", ("pictures",)),
    ("supervisor, recording, pictures", ("record", "pictures")),
)
_SETTLING = 5.0
"""What passes before the clock is started [s]."""


def measure_processor(session: LiveSession, seconds: float, rate: float = 10.0) -> BenchmarkTable:
    """Let all hear the same, at the same time.

    Args:
        session: a graph.
        seconds: how long [s].
        rate: of each topic [Hz].
    """
    load = session.module("team_load", _LOAD, "--hearers", str(1 + len(_CASES)), "--rate", f"{rate:g}")
    load.line()
    members: Dict[str, Member] = {
        "bare rospy subscriber": session.join("bare", [sys.executable, "-c", _BARE, *topics()])
    }
    for number, (name, options) in enumerate(_CASES):
        arguments = ["_application:=border_patrol", f"__name:=supervisor{number}"]
        arguments.append(f"_pictures:={1.0 if 'pictures' in options else 0.0}")
        if "record" in options:
            arguments.append(f"_record:={session.folder / f'bags{number}'}")
        members[name] = session.node("supervisor", *arguments)
    load.line()
    load.tell("go")
    time.sleep(_SETTLING)
    before, began = _used(members), time.monotonic()
    time.sleep(seconds)
    used, passed = _used(members), time.monotonic() - began
    for member in (load, *members.values()):
        member.end()
    shares = {name: 100.0 * (used[name] - before[name]) / passed for name in members}
    bare = shares["bare rospy subscriber"]
    rows: List[Tuple[Any, ...]] = [
        (name, round(share, 2), round(1e4 * share / (TOPICS * rate), 1), round(share / bare, 2) if bare else None)
        for name, share in shares.items()
    ]
    return BenchmarkTable(
        title=f"Processor time of one process, {TOPICS} topics at {rate:g} Hz, {seconds:g} s, all at the same time",
        columns=("process", "% of a core", "us a message", "times bare"),
        rows=tuple(rows),
        notes=(
            "5 robots say pose, odometry, a scan of 36 rays, 3 motivations, 14 short texts each; without the process "
            "that draws pictures.",
        ),
    )


_LOAD = "rqt_mrta_py.app.bench.live.team_load"


def _used(members: Dict[str, Member]) -> Dict[str, float]:
    return {name: processor_seconds(member.process.pid) for name, member in members.items()}
