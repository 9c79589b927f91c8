"""What a supervisor says on a ROS 1 graph, as it also stands in its bag."""

from __future__ import annotations

import logging
from itertools import count
from typing import Dict, Iterator, Mapping, Optional, Tuple

from rqt_mrta_py.app.live.health import DIAGNOSTICS_TOPIC
from rqt_mrta_py.app.outputs.pictures import PICTURE_TOPIC
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.hooks import Connection, Outgoing, Stamped
from rqt_mrta_py.render import MARKERS_TOPIC
from rqt_mrta_py.supervisor.own_topics import ALLOCATION, EVENT, INCIDENT, ROBOT_STATE, TASK_STATE, TEAM_STATE
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["Voice"]

_log = logging.getLogger("rqt_mrta_py.app")

_PUBLISHED: Mapping[str, Tuple[str, bool]] = {
    ALLOCATION.name: (ALLOCATION.type, False),
    EVENT.name: (EVENT.type, False),
    INCIDENT.name: (INCIDENT.type, True),
    MARKERS_TOPIC: ("visualization_msgs/MarkerArray", False),
    PICTURE_TOPIC: ("sensor_msgs/CompressedImage", False),
    ROBOT_STATE.name: (ROBOT_STATE.type, True),
    "/mrta/task_progress": ("rqt_mrta_py/TaskProgress", False),
    TASK_STATE.name: (TASK_STATE.type, True),
    TEAM_STATE.name: (TEAM_STATE.type, True),
    DIAGNOSTICS_TOPIC: ("diagnostic_msgs/DiagnosticArray", False),
}
"""What a supervisor says besides /rosout: type by topic, and whether late subscribers get the last message."""


class Voice:
    """Publishes for a supervisor; whoever calls holds the node's lock.

    Args:
        node: that speaks.
    """

    def __init__(self, node: RosNode) -> None:
        self._node = node
        self._connections: Dict[str, Tuple[Connection, Iterator[int]]] = {}

    def open(self) -> None:
        """Tell the graph what will be published."""
        for topic, (type_name, latched) in _PUBLISHED.items():
            self._node.advertise(topic, type_name, latched)

    def is_heard(self, topic: str) -> bool:
        """Tell whether somebody listens to one of the topics that a supervisor speaks on."""
        return self._node.is_heard(topic, *_PUBLISHED[topic])

    def say(self, outgoing: Outgoing, receipt_ns: int) -> Optional[Stamped]:
        """Publish a message.

        Args:
            outgoing: the message.
            receipt_ns: when it counts as received by the supervisor itself [ns].

        Returns:
            The message as it was published; None if it cannot be, which is logged.
        """
        known = self._connections.get(outgoing.topic)
        if known is None:
            latched = outgoing.latched or _PUBLISHED.get(outgoing.topic, ("", False))[1]
            connection = self._node.codec.connection(outgoing.topic, outgoing.type, self._node.name, latched)
            known = self._connections[outgoing.topic] = (connection, count(1))
        connection, numbers = known
        fields = outgoing.fields
        if "header" in fields:
            fields = {**fields, "header": {**fields["header"], "seq": next(numbers)}}
        try:
            stamped = Stamped(connection, receipt_ns, self._node.codec.encode(outgoing.type, fields))
            self._node.pass_on(stamped)
        except MrtaError as error:
            _log.error("topic=%s a message cannot be published: %s", outgoing.topic, error)
            return None
        return stamped
