"""Orders for benchmarks: a task is done, appears, is done ...; each changes its state; a process of its own."""

from __future__ import annotations

import argparse
import json
import sys
import time
from typing import List, Optional, Sequence

from rqt_mrta_py.app.bench.live.team_load import say
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.model import Progress
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["TASK", "main"]

TASK = "report"
_TOPIC, _TYPE = "/mrta/task_progress", "rqt_mrta_py/TaskProgress"


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Publish for a time, once stdin says so; then print when each was published, on the monotonic clock [ns].

    Args:
        argv: arguments without the program's name; None for the process's own.
    """
    parser = argparse.ArgumentParser()
    parser.add_argument("--rate", type=float, default=100.0)
    parser.add_argument("--seconds", type=float, default=10.0)
    options = parser.parse_args(argv)
    codec = compose().codec()
    node = RosNode.start("order_load", codec)
    node.advertise(_TOPIC, _TYPE)
    connection = codec.connection(_TOPIC, _TYPE, node.name)
    orders = [
        Stamped(connection, 0, codec.encode(_TYPE, {"task_id": TASK, "progress": progress.code}))
        for progress in (Progress.DONE, Progress.APPEARED)
    ]
    say("ready")
    while not node.hearers(_TOPIC):
        time.sleep(0.05)
    say("heard")
    sys.stdin.readline()
    sent: List[int] = []
    began = time.monotonic()
    for number in range(round(options.rate * options.seconds)):
        left = began + number / options.rate - time.monotonic()
        if left > 0:
            time.sleep(left)
        sent.append(time.monotonic_ns())
        node.pass_on(orders[number % 2])
    time.sleep(1.0)
    say(json.dumps(sent))
    node.shut_down("done")
    return 0


if __name__ == "__main__":
    sys.exit(main())
