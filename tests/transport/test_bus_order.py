"""When messages on the embedded bus are heard, and in which order."""

from __future__ import annotations

from typing import Dict, List, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.transport import Bus, RosCodec
from tests.transport.support import ListLink, listen, lookup, text


def test_delays_decide_when_a_message_is_due(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    listen(bus.node("/b", "robot2"), "/t", got)
    sender = bus.node("/a", "robot1")
    for name, delays in (("late", [0.3]), ("twice", [0.1, 0.2]), ("lost", []), ("now", [0.0])):
        link.answer = lambda _sender, _receiver, delays=delays: delays  # type: ignore[misc]
        sender.publish(text("/t", name), 1.0)
    rounds = []
    for now in (1.0, 1.09, 1.1, 1.25, 1.5):
        bus.deliver(now)
        rounds.append(list(got))
        got.clear()
    assert rounds == [["now"], [], ["twice"], ["twice"], ["late"]]
    assert link.asked == [("robot1", "robot2", 1.0)] * 4


def test_the_receipt_is_the_arrival(bus: Bus, link: ListLink) -> None:
    heard: List[Heard] = []
    link.answer = lambda sender, receiver: (0.25,)
    bus.node("/b", "robot2").subscribe(Subscription("/t"), heard.append)
    bus.node("/a", "robot1").publish(text("/t"), 1.0)
    bus.deliver(2.0)
    assert heard[0].receipt == 1.25


def test_the_receipt_is_by_the_clock_of_the_node_that_hears(bus: Bus) -> None:
    heard: List[Heard] = []
    nodes = [bus.node("/early", "robot1"), bus.node("/right", "robot2"), bus.node("/late", "robot3")]
    for node, offset in zip(nodes, (0.5, 0.0, -0.25)):
        node.subscribe(Subscription("/t"), heard.append)
        node.clock_offset = offset
    bus.node("/a").publish(text("/t"), 1.0)
    bus.deliver(2.0)
    assert [message.receipt for message in heard] == [1.5, 1.0, 0.75]


def test_time_never_goes_back(bus: Bus) -> None:
    node = bus.node("/a")
    node.publish(text("/t"), 2.0)
    message = r"the bus's time never goes back: it is 2\.0 s, told was "
    with pytest.raises(ValueError, match=message + r"1\.5 s"):
        node.publish(text("/t"), 1.5)
    with pytest.raises(ValueError, match=message + "nan s"):
        bus.deliver(float("nan"))
    with pytest.raises(ValueError, match=message + r"1\.0 s"):
        node.deliver(1.0)
    node.publish(text("/t"), 2.0)


def test_what_was_delayed_is_heard_before_what_arrives_at_its_moment_without_delay(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    listen(bus.node("/b", "robot2"), "/t", got)
    sender = bus.node("/a", "robot1")
    for data, delay, now in (("slow", 0.5, 1.0), ("quick", 0.0, 1.25), ("at once", 0.0, 1.5), ("later", 0.25, 1.5)):
        link.answer = lambda _sender, _receiver, delay=delay: (delay,)  # type: ignore[misc]
        sender.publish(text("/t", data), now)
    bus.deliver(1.5)
    assert got == ["quick", "slow", "at once"]
    bus.deliver(1.75)
    assert got[3:] == ["later"]


def test_equal_arrivals_keep_the_order_of_publishing(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    listen(bus.node("/c"), "/t", got)
    first, second = bus.node("/b"), bus.node("/a")
    link.answer = lambda sender, receiver: (0.5,)
    first.publish(text("/t", "1"), 1.0)
    second.publish(text("/t", "2"), 1.0)
    link.answer = lambda sender, receiver: (0.25,)
    first.publish(text("/t", "3"), 1.25)
    bus.deliver(2.0)
    assert got == ["1", "2", "3"]


def test_the_link_is_asked_once_for_each_node_and_in_the_order_of_nodes(bus: Bus, link: ListLink) -> None:
    nodes = [bus.node(f"/robot{i}/agent", f"robot{i}") for i in (2, 1, 3)]
    for node in (*nodes, bus.node("/supervisor")):
        node.subscribe(Subscription("/t"), lambda heard: None)
        node.subscribe(Subscription("/@task_id@"), lambda heard: None)
    nodes[1].publish(text("/t"), 1.0)
    assert link.asked == [("robot1", "robot2", 1.0), ("robot1", "robot3", 1.0), ("robot1", "", 1.0)]


def test_the_link_is_not_asked_within_a_robot_nor_among_nodes_of_none(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    link.answer = lambda sender, receiver: ()
    for name, robot in (("/driver", "robot1"), ("/supervisor", ""), ("/stranger", "robot2")):
        listen(bus.node(name, robot), "/t", got)
    bus.node("/agent", "robot1").publish(text("/t", "own"), 1.0)
    bus.node("/operator").publish(text("/t", "wired"), 1.0)
    bus.deliver(1.0)
    assert got == ["own", "wired"]
    assert link.asked == [
        ("robot1", "", 1.0),
        ("robot1", "robot2", 1.0),
        ("", "robot1", 1.0),
        ("", "robot2", 1.0),
    ]


def test_what_is_published_in_a_round_is_heard_in_the_next_whatever_the_order_of_nodes(bus: Bus) -> None:
    said: List[Tuple[str, str]] = []
    nodes = {name: bus.node(name) for name in ("/first", "/second")}

    def answer(name: str, heard: Heard) -> None:
        said.append((name, heard.fields["data"]))
        if heard.fields["data"] == "call":
            nodes[name].publish(text("/t", f"answer of {name}"), 1.0)

    for name, node in nodes.items():
        node.subscribe(Subscription("/t", "", ("data",)), lambda heard, name=name: answer(name, heard))  # type: ignore[misc]
    nodes["/first"].publish(text("/t", "call"), 1.0)
    bus.deliver(1.0)
    assert said == [("/first", "call"), ("/second", "call")]
    said.clear()
    bus.deliver(1.0)
    assert said == [(node, f"answer of {caller}") for node in ("/first", "/second") for caller in ("/first", "/second")]


def test_a_single_node_hears_only_what_was_published_before_it_was_asked(bus: Bus) -> None:
    got: List[str] = []
    node = bus.node("/a")

    def echo(heard: Heard) -> None:
        got.append(heard.fields["data"])
        node.publish(text("/t", heard.fields["data"] + "!"), 1.0)

    node.subscribe(Subscription("/t", "", ("data",)), echo)
    node.publish(text("/t", "a"), 1.0)
    node.deliver(1.0)
    node.deliver(1.0)
    assert got == ["a", "a!"]


def test_a_node_that_discards_hears_nothing_that_was_under_way(bus: Bus, link: ListLink) -> None:
    got: List[str] = []
    node = bus.node("/a", "robot1")
    listen(node, "/t", got)
    link.answer = lambda sender, receiver: (0.0, 0.5)
    node.publish(text("/t", "before"), 1.0)
    node.discard()
    bus.deliver(2.0)
    node.publish(text("/t", "after"), 2.0)
    bus.deliver(2.0)
    assert got == ["after"]


def test_a_node_may_discard_while_it_hears(bus: Bus) -> None:
    got: List[str] = []
    node = bus.node("/a")

    def once(heard: Heard) -> None:
        got.append(heard.fields["data"])
        node.discard()

    node.subscribe(Subscription("/t", "", ("data",)), once)
    for data in "ab":
        node.publish(text("/t", data), 1.0)
    bus.deliver(1.0)
    assert got == ["a"]


@pytest.mark.parametrize("delay", [-0.1, float("nan")])
def test_a_delay_into_the_past_is_a_mistake_of_the_link(bus: Bus, link: ListLink, delay: float) -> None:
    link.answer = lambda sender, receiver: (delay,)
    bus.node("/b", "robot1").subscribe(Subscription("/t"), lambda heard: None)
    with pytest.raises(ValueError, match="it must be 0 or more"):
        bus.node("/a").publish(text("/t"), 1.0)


ACTIONS = st.lists(
    st.tuples(st.sampled_from(["publish", "deliver", "discard"]), st.integers(0, 2), st.integers(0, 3)), max_size=30
)


@settings(deadline=None)
@given(ACTIONS)
def test_each_copy_is_heard_once_when_due_in_order_of_arrival_and_number(actions: List[Tuple[str, int, int]]) -> None:
    link = ListLink()
    bus = Bus(RosCodec(lookup), link)
    nodes = [bus.node(f"/n{i}", f"r{i}") for i in range(3)]
    heard: Dict[str, List[Tuple[float, int]]] = {node.name: [] for node in nodes}
    expected: Dict[str, List[Tuple[float, int]]] = {node.name: [] for node in nodes}
    pending: Dict[str, List[Tuple[float, int]]] = {node.name: [] for node in nodes}
    for node in nodes:
        node.subscribe(
            Subscription("/t"), lambda message, name=node.name: heard[name].append((message.receipt, message.ordinal))
        )
    now, number = 1.0, 0
    for action, who, ticks in actions:
        if action == "publish":
            link.answer = lambda sender, receiver, ticks=ticks: (ticks * 0.5,)  # type: ignore[misc]
            nodes[who].publish(text("/t"), now)
            for node in nodes:
                delay = 0.0 if node is nodes[who] else ticks * 0.5
                pending[node.name].append((now + delay, number))
            number += 1
        elif action == "discard":
            nodes[who].discard()
            pending[nodes[who].name].clear()
        else:
            now += ticks * 0.5
            bus.deliver(now)
            for name, waiting in pending.items():
                due = sorted(copy for copy in waiting if copy[0] <= now)
                expected[name].extend(due)
                pending[name] = [copy for copy in waiting if copy[0] > now]
    assert heard == expected
