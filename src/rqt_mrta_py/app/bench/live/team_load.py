"""A team's sensors for benchmarks: 5 robots, 20 topics each, at any rate; a process of its own.

The robots are those of ``border_patrol``. Each tells pose, odometry, a scan of 36 rays, its motivations and short
texts, all at one moment; the robots follow one another evenly.
"""

from __future__ import annotations

import argparse
import json
import sys
import threading
import time
from typing import Any, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.hooks import Codec, Stamped
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["ROBOTS", "TOPICS", "main", "say", "topics"]

ROBOTS = 5
_TASKS = ("wander", "border_protection", "report")
_PER_ROBOT = 20

TOPICS = ROBOTS * _PER_ROBOT
"""How many topics there are."""


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Publish until stdin ends, or for a time; then print how much was published.

    Args:
        argv: arguments without the program's name; None for the process's own.
    """
    parser = argparse.ArgumentParser()
    parser.add_argument("--rate", type=float, default=10.0)
    parser.add_argument("--hearers", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=0.0)
    options = parser.parse_args(argv)
    codec = compose().codec()
    node = RosNode.start("team_load", codec)
    robots = [_messages(codec, robot) for robot in range(ROBOTS)]
    for message in (each for robot in robots for each in robot):
        node.advertise(message.connection.topic, message.connection.type)
    say("ready")
    everything = [each.connection.topic for robot in robots for each in robot]
    while min(len(node.hearers(topic)) for topic in everything) < options.hearers:
        time.sleep(0.05)
    say("heard")
    ended = threading.Event()
    if not sys.stdin.readline():
        return 0
    threading.Thread(target=_await_end, args=(ended,), daemon=True).start()
    counted, late = _publish(node, robots, options.rate, options.seconds, ended)
    say(json.dumps({"published": counted, "late": late}))
    if options.seconds and not ended.is_set():
        ended.wait()
    node.shut_down("done")
    return 0


def topics() -> List[str]:
    """List all topics."""
    names = ["pose", "odom", "scan", *(f"alliance/motivation/{task}" for task in _TASKS)]
    names += [f"data{number}" for number in range(_PER_ROBOT - len(names))]
    return [f"/robot{robot + 1}/{name}" for robot in range(ROBOTS) for name in names]


def _await_end(ended: threading.Event) -> None:
    sys.stdin.read()
    ended.set()


def say(line: str) -> None:
    """Tell the benchmark a line."""
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


def _publish(
    node: RosNode, robots: Sequence[Sequence[Stamped]], rate: float, seconds: float, ended: threading.Event
) -> Tuple[int, float]:
    """Publish; give how many messages, and how late the latest robot's turn came [s]."""
    turns = counted = 0
    late = 0.0
    began = time.monotonic()
    while not ended.is_set() and (not seconds or turns < round(seconds * rate * ROBOTS)):
        due = began + turns / (rate * ROBOTS)
        left = due - time.monotonic()
        if left > 0:
            time.sleep(left)
        late = max(late, -left)
        for message in robots[turns % ROBOTS]:
            node.pass_on(message)
            counted += 1
        turns += 1
    return counted, late


def _messages(codec: Codec, robot: int) -> List[Stamped]:
    name = f"robot{robot + 1}"
    said: List[Tuple[str, str, Mapping[str, Any]]] = [
        (
            "pose",
            "geometry_msgs/PoseStamped",
            {"header": {"frame_id": "map"}, "pose": {"position": {"x": 0.5 * robot}}},
        ),
        ("odom", "nav_msgs/Odometry", {"header": {"frame_id": f"{name}/odom"}}),
        ("scan", "sensor_msgs/LaserScan", {"range_max": 4.0, "ranges": [2.5] * 36}),
    ]
    said += [(f"alliance/motivation/{task}", "alliance_msgs/Motivation", {}) for task in _TASKS]
    said += [(f"data{number}", "std_msgs/String", {"data": "x" * 46}) for number in range(_PER_ROBOT - len(said))]
    return [
        Stamped(codec.connection(f"/{name}/{topic}", kind, "/team_load"), 0, codec.encode(kind, fields))
        for topic, kind, fields in said
    ]


if __name__ == "__main__":
    sys.exit(main())
