"""How long it takes from a message that is published to the state that it changes."""

from __future__ import annotations

import json
from typing import Sequence

from rqt_mrta_py.app.bench.live.session import LiveSession
from rqt_mrta_py.app.bench.live.team_load import TOPICS
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import BenchmarkTable

__all__ = ["measure_latency"]

_ORDERS = 100.0
"""Messages that change a state [Hz]; 900 others a second come beside them."""


def measure_latency(session: LiveSession, seconds: float) -> BenchmarkTable:
    """Change a task's state a hundred times a second, among 900 other messages.

    Args:
        session: a graph.
        seconds: how long [s].

    Raises:
        UsageError: messages were lost, so that nobody can tell which changed what.
    """
    rate = 900.0 / TOPICS
    load = session.module("team_load", "rqt_mrta_py.app.bench.live.team_load", "--rate", f"{rate:g}")
    load.line()
    orders = session.module("order_load", "rqt_mrta_py.app.bench.live.order_load", "--seconds", f"{seconds:g}")
    orders.line()
    supervisor = session.module("supervisor", "rqt_mrta_py.app.bench.live.watched_supervisor")
    for member in (supervisor, load, orders):
        member.line()
    load.tell("go")
    orders.tell("go")
    sent = json.loads(orders.line())
    noticed = json.loads(supervisor.end()[-1])["noticed"]
    load.end()
    if len(sent) != len(noticed):
        raise UsageError(f"{len(sent)} orders were given, {len(noticed)} changes of state noticed")
    delays = sorted((after - before) / 1e6 for before, after in zip(sent, noticed))
    names = ("median", "90 %", "99 %", "99.9 %", "longest")
    values = [_percentile(delays, share) for share in (0.5, 0.9, 0.99, 0.999, 1.0)]
    return BenchmarkTable(
        title=f"From a message published to the state changed, 1000 messages a second, {seconds:g} s",
        columns=("changes", *(f"{name} [ms]" for name in names)),
        rows=((len(delays), *(round(value, 3) for value in values)),),
        notes=("100 messages a second change a task's state; 900 are a team's sensors and motivations.",),
    )


def _percentile(ordered: Sequence[float], share: float) -> float:
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]
