"""Who hears what on the embedded bus: subscriptions and topics, each looked up once for all that are alike."""

from __future__ import annotations

import logging
from itertools import count
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Set, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, Subscription
from rqt_mrta_py.transport.embedded.inbox import Hearing, Inbox
from rqt_mrta_py.transport.fitting import reader_for
from rqt_mrta_py.transport.patterns import TopicPattern

__all__ = ["Ear", "Receiver", "Topic", "Wiring"]

_LOG = logging.getLogger(__name__)

_Tokens = Tuple[str, str]
"""What ``@robot_id@`` and ``@task_id@`` stand for."""


class Ear(NamedTuple):
    """A subscription of a node.

    Attributes:
        place: of the node among all nodes, and of the subscription among the node's.
        node: resolved name.
        robot: id of the robot that the node runs on; empty if on none.
        inbox: of the node, or of the team that it hears with.
        topic: resolved, perhaps with tokens, or EVERYTHING.
        subscription: as the node made it.
        hearer: see Hearing.
    """

    place: Tuple[int, int]
    node: str
    robot: str
    inbox: Inbox
    topic: str
    subscription: Subscription
    hearer: Any


class Receiver(NamedTuple):
    """A node that hears a topic, by itself or with a team, with the subscriptions that mean it."""

    robot: str
    inbox: Inbox
    hearings: Tuple[Hearing, ...]


class Topic:
    """A topic that somebody publishes.

    Attributes:
        name: resolved.
        ordinals: numbers its messages from 0.
        receivers: of its messages, by type and definition, for the wiring's version.
        groups: the subscriptions that mean it, with what the tokens stand for.
        kept: whether messages of it are kept for late subscribers.
    """

    __slots__ = ("groups", "kept", "name", "ordinals", "receivers")

    def __init__(self, name: str) -> None:
        self.name = name
        self.ordinals: Iterator[int] = count()
        self.receivers: Dict[Tuple[str, str], Tuple[Receiver, ...]] = {}
        self.groups: List[Tuple[_Group, _Tokens]] = []
        self.kept = False

    @property
    def unnoticed(self) -> bool:
        """Tell whether nobody can ever tell more of its messages so far than their number."""
        return not (self.groups or self.kept)


class _Group:
    """All ears with the same topic, and the topics that they mean."""

    __slots__ = ("ears", "meant", "pattern")

    def __init__(self, pattern: TopicPattern) -> None:
        self.pattern = pattern
        self.ears: List[Ear] = []
        self.meant: List[Tuple[Topic, _Tokens]] = []


class Wiring:
    """Joins ears and topics, whichever come first.

    Attributes:
        version: changes with everybody who begins to hear, and with every topic that begins to be kept.

    Args:
        codec: reads the messages.
    """

    def __init__(self, codec: Codec) -> None:
        self.version = 0
        self._codec = codec
        self._topics: Dict[str, Topic] = {}
        self._groups: Dict[str, _Group] = {}
        # Groups that may mean more than one topic; the others are found by its name.
        self._patterns: List[_Group] = []
        self._refused: Set[Tuple[Tuple[int, int], str, str]] = set()

    def topic(self, name: str) -> Topic:
        """Give a topic by its name, and make it when it is first asked for."""
        topic = self._topics.get(name)
        if topic is None:
            topic = self._topics[name] = Topic(name)
            literal = self._groups.get(name)
            for group in self._patterns if literal is None else (literal, *self._patterns):
                self._meet(group, topic)
        return topic

    def add(self, ear: Ear) -> List[Tuple[Topic, _Tokens]]:
        """Take in a new ear.

        Returns:
            The topics that it means, so far, with what the tokens stand for.
        """
        group = self._groups.get(ear.topic)
        if group is None:
            group = self._groups[ear.topic] = _Group(TopicPattern(ear.topic))
            if group.pattern.is_literal:
                topics = [self._topics[ear.topic]] if ear.topic in self._topics else []
            else:
                self._patterns.append(group)
                topics = list(self._topics.values())
            for topic in topics:
                self._meet(group, topic)
        group.ears.append(ear)
        self.version += 1
        for topic, _ in group.meant:
            topic.receivers.clear()
        return group.meant

    def keep(self, topic: Topic) -> None:
        """Take in that messages of a topic are kept for late subscribers from now on."""
        if not topic.kept:
            topic.kept = True
            self.version += 1

    def receivers(self, topic: Topic, connection: Connection) -> Tuple[Receiver, ...]:
        """Tell who hears a publisher, in the order of nodes, each with its subscriptions in their order.

        Args:
            topic: of the publisher.
            connection: of the publisher.
        """
        key = (connection.type, connection.definition)
        found = topic.receivers.get(key)
        if found is None:
            found = topic.receivers[key] = self._receivers(topic, connection)
        return found

    def hearing(self, ear: Ear, tokens: _Tokens, connection: Connection) -> Optional[Hearing]:
        """Join an ear and a publisher of a topic that it means.

        Returns:
            How it hears; None where it cannot, which is logged once.
        """
        try:
            paths, reader = reader_for(self._codec, connection, ear.subscription)
        except TransportError as error:
            self._refuse(ear, connection, str(error))
            return None
        return Hearing(ear.hearer, tokens[0], tokens[1], paths, reader)

    def _receivers(self, topic: Topic, connection: Connection) -> Tuple[Receiver, ...]:
        ears = [(ear, tokens) for group, tokens in topic.groups for ear in group.ears]
        nodes: Dict[Tuple[int, int], Tuple[Ear, List[Hearing]]] = {}
        for ear, tokens in sorted(ears, key=lambda item: item[0].place):
            hearing = self.hearing(ear, tokens, connection)
            if hearing is not None:
                nodes.setdefault((ear.place[0], id(ear.inbox)), (ear, []))[1].append(hearing)
        return tuple(Receiver(ear.robot, ear.inbox, tuple(hearings)) for ear, hearings in nodes.values())

    def _refuse(self, ear: Ear, connection: Connection, reason: str) -> None:
        key = (ear.place, connection.topic, connection.type)
        if key not in self._refused:
            self._refused.add(key)
            _LOG.warning("a subscription is not served node=%s topic=%s reason=%s", ear.node, connection.topic, reason)

    @staticmethod
    def _meet(group: _Group, topic: Topic) -> None:
        tokens = group.pattern.match(topic.name)
        if tokens is not None:
            group.meant.append((topic, tokens))
            topic.groups.append((group, tokens))
