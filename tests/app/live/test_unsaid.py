"""Where the clock runs freely, a robot goes on saying what it can while a new way opens."""

from __future__ import annotations

from typing import Dict, FrozenSet, List, Tuple

from rqt_mrta_py.app.live.unsaid import Unsaid
from rqt_mrta_py.app.live.ways import Opening
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.transport.ros1.master import Graph


class Node:
    """Connects hearers when it is told to."""

    def __init__(self) -> None:
        self.connected: Dict[str, FrozenSet[str]] = {}

    def advertise(self, topic: str, type_name: str, latched: bool = False) -> None:
        raise AssertionError(topic)

    def hearers(self, topic: str) -> FrozenSet[str]:
        return self.connected.get(topic, frozenset())

    def refused(self, topic: str) -> FrozenSet[str]:
        return frozenset()

    def graph(self) -> Graph:
        raise AssertionError

    def reaches(self, node: str) -> bool:
        return True


def message(topic: str, text: str) -> Outgoing:
    return Outgoing(topic, "std_msgs/String", {"data": text})


def test_only_what_is_said_on_a_new_topic_waits_for_its_way() -> None:
    heard: List[Tuple[str, str, float]] = []
    node = Node()
    unsaid = Unsaid(
        lambda said, stamp: heard.append((said.topic, said.fields["data"], stamp)),  # type: ignore[union-attr]
        lambda topic: topic if topic.startswith("/") else f"/robot2/{topic}",
    )
    unsaid.say(message("motivation", "1"), 1.0)
    unsaid.await_opening(Opening(node, {"/robot2/report": frozenset({"/supervisor"})}))
    unsaid.look()
    unsaid.say(message("report", "there"), 1.1)
    unsaid.say(message("motivation", "2"), 1.1)
    unsaid.look()
    unsaid.say(message("/robot2/report", "still there"), 1.2)
    assert heard == [("motivation", "1", 1.0), ("motivation", "2", 1.1)]
    node.connected["/robot2/report"] = frozenset({"/supervisor"})
    unsaid.look()
    # In the order in which it was said, with the stamps of then.
    assert heard[2:] == [("report", "there", 1.1), ("/robot2/report", "still there", 1.2)]
    unsaid.say(message("report", "at once"), 1.3)
    assert heard[4:] == [("report", "at once", 1.3)]
