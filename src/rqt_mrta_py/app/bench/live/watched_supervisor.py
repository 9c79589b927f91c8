"""A supervisor for benchmarks, that tells how many messages it heard and when a task changed its state."""

from __future__ import annotations

import argparse
import json
import sys
import time
from typing import Any, List, Optional, Sequence

from rqt_mrta_py.app.bench.live.order_load import TASK
from rqt_mrta_py.app.bench.live.team_load import say
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.live.live_supervisor import LiveSupervisor
from rqt_mrta_py.app.live.options import LiveOptions
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import hookimpl
from rqt_mrta_py.model import Event
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["main"]


class _Stopwatch:
    """A plugin that notes when events of one task are noticed."""

    def __init__(self) -> None:
        self.noticed: List[int] = []

    @hookimpl
    def mrta_on_event(self, event: Event) -> None:
        if event.kind == "task_state" and event.task == TASK:
            self.noticed.append(time.monotonic_ns())


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Supervise until stdin ends; then print what was counted.

    Args:
        argv: arguments without the program's name; None for the process's own.
    """
    parser = argparse.ArgumentParser()
    parser.add_argument("--kept", type=float, default=30.0)
    options = parser.parse_args(argv)
    host = compose()
    stopwatch = _Stopwatch()
    host.manager.register(stopwatch, "bench_stopwatch")
    node = RosNode.start("supervisor", host.codec())
    mission = load_mission(host.registry, "border_patrol", seed=None)
    said = [0]
    pass_on = node.pass_on

    def counted(stamped: Any) -> None:
        said[0] += 1
        pass_on(stamped)

    node.pass_on = counted  # type: ignore[method-assign]  # what it says itself counts as heard too
    supervisor = LiveSupervisor(node, host, LiveOptions(pictures=0.0, snapshot_seconds=options.kept))
    supervisor.open()
    supervisor.begin(mission, None, announce=True)
    say("ready")
    with rare_collections():
        sys.stdin.read()
    with node.lock:
        _ = supervisor.now
        heard = supervisor.heard - said[0]
    say(json.dumps({"heard": heard, "noticed": stopwatch.noticed}))
    supervisor.finish()
    node.shut_down("done")
    return 0


if __name__ == "__main__":
    sys.exit(main())
