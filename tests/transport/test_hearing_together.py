"""What a team hears together is what each of its nodes would have heard alone."""

from __future__ import annotations

from typing import Dict, List, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Heard, Outgoing, Subscription, TeamHeard
from rqt_mrta_py.transport import Bus, Node, RosCodec
from tests.transport.support import ListLink, lookup, text

WISH = Subscription("in", "std_msgs/String", ("data",))


def note(rounds: List[List[Tuple[int, float, str]]], heard: TeamHeard) -> None:
    rounds.append([(row, at, fields["data"]) for row, at, fields in zip(heard.rows, heard.receipts, heard.fields)])


class Drivers:
    """Two robots' drivers that hear together, and a bystander on a third robot."""

    def __init__(self, bus: Bus) -> None:
        self.bus = bus
        self.rounds: List[List[Tuple[int, float, str]]] = []
        self.nodes = [bus.node(f"/robot{i}/driver", f"robot{i}") for i in (1, 2)]
        self.bystander = bus.node("/bystander", "robot3")
        self.ear = bus.subscribe_together(self.nodes, WISH, lambda heard: note(self.rounds, heard))


@pytest.fixture
def drivers(bus: Bus) -> Drivers:
    return Drivers(bus)


def test_all_that_a_team_hears_in_a_round_is_told_at_once_by_arrival_then_sending(
    drivers: Drivers, link: ListLink
) -> None:
    link.answer = lambda sender, receiver: (0.5,)
    drivers.bystander.publish(text("/robot2/in", "slow"), 1.0)
    drivers.nodes[1].publish(text("/robot2/in", "own"), 1.25)
    drivers.nodes[0].publish(text("/robot1/in", "first"), 1.5)
    drivers.nodes[1].publish(text("/robot2/in", "second"), 1.5)
    drivers.bus.deliver(1.5)
    assert drivers.rounds == [[(1, 1.25, "own"), (1, 1.5, "slow"), (0, 1.5, "first"), (1, 1.5, "second")]]
    drivers.bus.deliver(2.0)
    assert len(drivers.rounds) == 1


def test_a_team_is_served_alone_if_that_is_wanted(drivers: Drivers) -> None:
    alone: List[Heard] = []
    drivers.bystander.subscribe(Subscription("/robot1/in"), alone.append)
    drivers.nodes[0].publish(text("in", "a"), 1.0)
    drivers.bus.deliver(1.0, (drivers.ear,))
    assert (drivers.rounds, alone) == ([[(0, 1.0, "a")]], [])


def test_a_message_that_is_said_again_is_read_once(bus: Bus) -> None:
    told: List[TeamHeard] = []
    node = bus.node("/robot1/driver", "robot1")
    bus.subscribe_together([node], WISH, told.append)
    said = (text("in", "on"),)
    for now in (1.0, 2.0):
        bus.publish_each([(node, said)], now)
        bus.deliver(now)
    bus.publish_each([(node, (text("in", "on"),))], 3.0)
    bus.deliver(3.0)
    first, second, third = (heard.fields[0] for heard in told)
    assert first is second
    assert first is not third
    assert first == third == {"data": "on"}


def test_what_follows_from_what_a_team_hears_is_heard_in_the_next_round(bus: Bus) -> None:
    got: List[str] = []
    node = bus.node("/a")

    def echo(heard: TeamHeard) -> None:
        got.extend(fields["data"] for fields in heard.fields)
        node.publish(text("in", heard.fields[0]["data"] + "!"), 1.0)

    bus.subscribe_together([node], WISH, echo)
    node.publish(text("in", "a"), 1.0)
    bus.deliver(1.0)
    assert got == ["a"]
    bus.deliver(1.0)
    assert got == ["a", "a!"]


def test_nodes_of_a_team_resolve_and_remap_the_topic_each_for_itself(bus: Bus) -> None:
    rounds: List[List[Tuple[int, float, str]]] = []
    nodes = [bus.node("/a/driver"), bus.node("/b/driver", "", {"in": "/elsewhere"})]
    bus.subscribe_together(nodes, WISH, lambda heard: note(rounds, heard))
    for topic in ("/b/in", "/elsewhere", "/a/in"):
        bus.node(f"/talker{topic}").publish(text(topic, topic), 1.0)
    bus.deliver(1.0)
    assert rounds == [[(1, 1.0, "/elsewhere"), (0, 1.0, "/a/in")]]
    with pytest.raises(TransportError, match="/a/driver"):
        bus.subscribe_together(nodes, Subscription("i n"), lambda heard: None)


def test_a_team_hears_the_latched_messages_that_are_there(bus: Bus) -> None:
    rounds: List[List[Tuple[int, float, str]]] = []
    nodes = [bus.node(f"/robot{i}/driver", f"robot{i}") for i in (1, 2)]
    nodes[1].publish(text("in", "latched", latched=True), 1.0)
    bus.subscribe_together(nodes, WISH, lambda heard: note(rounds, heard))
    bus.deliver(1.5)
    assert rounds == [[(1, 1.0, "latched")]]


def test_the_link_is_asked_for_each_node_of_a_team_at_its_place(bus: Bus, link: ListLink) -> None:
    nodes = [bus.node(f"/n{i}", f"robot{i}") for i in range(4)]
    bus.subscribe_together([nodes[3], nodes[1]], Subscription("/t"), lambda heard: None)
    for node in (nodes[2], nodes[0]):
        node.subscribe(Subscription("/t"), lambda heard: None)
    bus.node("/talker").publish(text("/t"), 1.0)
    assert [receiver for _, receiver, _ in link.asked] == ["robot0", "robot1", "robot2", "robot3"]


def test_a_team_that_asks_for_nothing_of_the_content_is_told_that_messages_came(bus: Bus) -> None:
    told: List[TeamHeard] = []
    node = bus.node("/a")
    bus.subscribe_together([node], Subscription("in"), told.append)
    node.publish(text("in", "a"), 1.0)
    bus.deliver(1.0)
    assert told == [TeamHeard([0], [1.0], [{}])]


ACTIONS = st.lists(
    st.tuples(st.sampled_from(["say", "hold", "deliver", "discard", "shift"]), st.integers(0, 2), st.integers(0, 3)),
    max_size=30,
)


def play(actions: List[Tuple[str, int, int]], together: bool) -> Dict[str, List[Tuple[float, str]]]:
    """Give what each of two nodes heard, from each other, themselves and a stranger, with and without delay."""
    link = ListLink()
    bus = Bus(RosCodec(lookup), link)
    nodes: List[Node] = [bus.node(f"/n{i}", f"r{i}") for i in range(3)]
    heard: Dict[str, List[Tuple[float, str]]] = {node.name: [] for node in nodes[:2]}
    if together:
        bus.subscribe_together(nodes[:2], Subscription("/t", "", ("data",)), lambda told: take_rows(told, heard))
    else:
        for node in nodes[:2]:
            node.subscribe(
                Subscription("/t", "", ("data",)),
                lambda message, name=node.name: heard[name].append((message.receipt, message.fields["data"])),
            )
    now = 1.0
    held = [(text("/t", f"held by {node.name}"),) for node in nodes]
    for number, (action, who, ticks) in enumerate(actions):
        link.answer = lambda sender, receiver, ticks=ticks: (ticks * 0.5,) * (ticks != 3)  # type: ignore[misc]
        if action == "say":
            nodes[who].publish(text("/t", str(number)), now)
        elif action == "hold":
            bus.publish_each([(nodes[who], held[who])], now)
        elif action == "discard":
            nodes[who].discard()
        elif action == "shift":
            nodes[who].clock_offset = ticks * 10.0
        else:
            now += ticks * 0.5
            bus.deliver(now)
    return heard


def take_rows(told: TeamHeard, heard: Dict[str, List[Tuple[float, str]]]) -> None:
    for row, receipt, fields in zip(told.rows, told.receipts, told.fields):
        heard[f"/n{row}"].append((receipt, fields["data"]))


@settings(deadline=None)
@given(ACTIONS)
def test_each_node_of_a_team_hears_what_it_would_have_heard_alone(actions: List[Tuple[str, int, int]]) -> None:
    assert play(actions, together=True) == play(actions, together=False)


def test_a_message_of_another_type_is_not_heard_by_a_team(drivers: Drivers) -> None:
    drivers.bystander.publish(Outgoing("/robot1/in", "std_msgs/Int8", {"data": 1}), 1.0)
    drivers.bus.deliver(1.0)
    assert drivers.rounds == []
