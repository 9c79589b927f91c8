"""Topics are open before anything is said on them, for those who want to hear them and are alive."""

from __future__ import annotations

from typing import Dict, FrozenSet, List, Set, Tuple

import pytest

from rqt_mrta_py.app.live import ways
from rqt_mrta_py.app.live.ways import Ways, expanded
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.ros1.master import Graph


class Node:
    """Knows who subscribes; each look at a topic lets one more of them be connected."""

    def __init__(self, subscribers: Dict[str, Tuple[str, ...]], dead: FrozenSet[str] = frozenset()) -> None:
        self.subscribers = subscribers
        self.dead = dead
        self.refusals: FrozenSet[str] = frozenset()
        self.advertised: List[str] = []
        self.connected: Dict[str, Set[str]] = {}
        self.witness = "/witness"
        self.has_master = True

    def advertise(self, topic: str, type_name: str, latched: bool = False) -> None:
        self.advertised.append(topic)
        self.connected[topic] = set()

    def hearers(self, topic: str) -> FrozenSet[str]:
        now = frozenset(self.connected[topic])
        coming = {*self.subscribers.get(topic, ()), self.witness} - self.dead - now
        self.connected[topic].update(sorted(coming)[:1])
        return now

    def refused(self, topic: str) -> FrozenSet[str]:
        return self.refusals if topic == "/a" else frozenset()

    def graph(self) -> Graph:
        if not self.has_master:
            raise TransportError("no ROS master answers")
        return Graph({}, {"/rosout": (self.witness,)}, self.subscribers, {})

    def reaches(self, node: str) -> bool:
        return node not in self.dead


def test_topics_are_opened_together_and_once_and_all_who_want_to_hear_are_waited_for() -> None:
    node = Node({"/a": ("/robot1/agent", "/robot2/agent")})
    opened = Ways(node, ["/witness"], lambda: False)
    opened.open([("/a", "std_msgs/String", False), ("/b", "std_msgs/String", True), ("/a", "std_msgs/String", False)])
    assert node.advertised == ["/a", "/b"]
    assert node.connected["/a"] >= {"/robot1/agent", "/robot2/agent", "/witness"}
    assert node.connected["/b"] >= {"/witness"}
    opened.open([("/a", "std_msgs/String", False)])
    assert node.advertised == ["/a", "/b"]


def test_a_way_that_is_begun_is_not_waited_for() -> None:
    node = Node({"/a": ("/robot1/agent",)})
    opened = Ways(node, [], lambda: False)
    opening = opened.begin([("/a", "std_msgs/String", False)])
    assert opening is not None
    assert opening.topics == ("/a",)
    # Each look lets one more node be connected, and sees it at the next.
    assert [opening.is_over() for _ in range(3)] == [False, True, True]
    assert opened.begin([("/a", "std_msgs/String", False)]) is None


def test_those_who_have_died_are_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """A master knows the subscriptions of a node that was killed until another one takes its name."""
    monkeypatch.setattr(ways, "_DOUBT", 0.0)
    node = Node({"/a": ("/dead", "/robot1/agent")}, dead=frozenset({"/dead"}))
    Ways(node, [], lambda: False).open([("/a", "std_msgs/String", False)])
    assert "/robot1/agent" in node.connected["/a"]


def test_those_who_are_refused_are_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """A subscriber that takes the topic for something else held the first message back for 15 s."""
    monkeypatch.setattr(ways, "_PATIENCE", 600.0)
    node = Node({"/a": ("/robot1/agent", "/stranger")}, dead=frozenset({"/stranger"}))
    node.reaches = lambda name: True  # type: ignore[method-assign]  # it lives, and will never be connected
    node.refusals = frozenset({"/stranger"})
    Ways(node, [], lambda: False).open([("/a", "std_msgs/String", False)])
    assert "/robot1/agent" in node.connected["/a"]


def test_without_a_master_topics_are_opened_and_nobody_is_waited_for() -> None:
    node = Node({"/a": ("/robot1/agent",)})
    node.has_master = False
    Ways(node, [], lambda: False).open([("/a", "std_msgs/String", False)])
    assert node.advertised == ["/a"]


@pytest.mark.parametrize(
    ("topic", "topics"),
    [
        ("/clock", ["/clock"]),
        ("/@robot_id@/pose", ["/r1/pose", "/r2/pose"]),
        ("/@robot_id@/do/@task_id@", ["/r1/do/t", "/r2/do/t"]),
        ("*", []),
    ],
)
def test_a_pattern_stands_for_the_topics_of_the_robots_and_tasks_that_are_known(topic: str, topics: List[str]) -> None:
    assert list(expanded(topic, ["r1", "r2"], ["t"])) == topics
