"""On which topics a robot will speak, as far as it can be known before it does.

A way onto a topic takes a moment to open. Where the clock runs freely, what is said first on a topic that nobody has
foreseen reaches the others some ticks late, and they decide otherwise than in one process.
"""

from __future__ import annotations

from typing import Dict, Iterable, Sequence, Tuple

from rqt_mrta_py.app.live.ways import expanded
from rqt_mrta_py.app.run.watch import SUPERVISOR_TOPICS
from rqt_mrta_py.hooks import Subscription
from rqt_mrta_py.model import Mission
from rqt_mrta_py.sim.drivers import CMD_VEL
from rqt_mrta_py.transport.patterns import TopicPattern

__all__ = ["spoken_topics"]

_LOG = ("/rosout", "rosgraph_msgs/Log")


def spoken_topics(mission: Mission, robot: str, heard: Iterable[Subscription]) -> Sequence[Tuple[str, str]]:
    """Give topics on which a robot's agent will speak, with their types.

    It speaks where it hears its fellows, where the supervisor is told of it by its architecture, to its own drivers,
    and to the log.

    Args:
        mission: tells architecture and tasks.
        robot: id.
        heard: what its host wishes to hear; topics are resolved.
    """
    own, tasks = f"/{robot}", mission.task_ids
    found: Dict[str, str] = {}
    for wish in heard:
        among_fellows = TopicPattern(wish.topic).is_literal and not wish.topic.startswith(f"{own}/")
        if among_fellows and wish.type and wish.topic not in SUPERVISOR_TOPICS:
            found.setdefault(wish.topic, wish.type)
    architecture = mission.architecture
    for monitored in (*architecture.busy_robots, *architecture.idle_robots, *architecture.allocated_tasks):
        for topic in expanded(monitored.name, (robot,), tasks):
            found.setdefault(topic, monitored.type)
    found.setdefault(f"{own}/{CMD_VEL.topic}", CMD_VEL.type)
    found.setdefault(*_LOG)
    return tuple(found.items())
