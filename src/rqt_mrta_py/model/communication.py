"""Who speaks to whom: nodes and topics, with types and rates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Dict, List, NamedTuple, Optional, Tuple

__all__ = ["CommunicationGraph", "Flow", "TopicTraffic"]


class Flow(NamedTuple):
    """What one node says on one topic.

    Attributes:
        node: resolved name; empty if unknown.
        topic: resolved name.
        type: ``pkg/Msg``.
        messages: number of those heard; 0 also where nobody listened.
        rate: of its messages [Hz]; None if unknown.
    """

    node: str
    topic: str
    type: str
    messages: int = 0
    rate: Optional[float] = None


class TopicTraffic(NamedTuple):
    """What is said on one topic.

    Attributes:
        name: resolved.
        types: those that it carries, sorted; more than one is a misfit.
        messages: number of those heard.
        rate: of all of them together [Hz]; None if unknown.
    """

    name: str
    types: Tuple[str, ...]
    messages: int
    rate: Optional[float]


@dataclass(frozen=True)
class CommunicationGraph:
    """Nodes and topics, and what flows between them.

    Attributes:
        flows: what nodes say, by topic, node and type.
        subscriptions: pairs of a topic and a node that hears it, sorted; None if nobody knows, as in a bag.
    """

    flows: Tuple[Flow, ...]
    subscriptions: Optional[Tuple[Tuple[str, str], ...]] = None

    def restricted(self, wanted: Callable[[str], bool]) -> CommunicationGraph:
        """Give what is left with some of the topics; nodes that neither say nor hear any of them are not in it.

        Args:
            wanted: tells whether to keep a topic.
        """
        hearing = self.subscriptions
        if hearing is not None:
            hearing = tuple(pair for pair in hearing if wanted(pair[0]))
        return CommunicationGraph(tuple(flow for flow in self.flows if wanted(flow.topic)), hearing)

    @property
    def nodes(self) -> Tuple[str, ...]:
        """List the nodes that speak or hear, sorted."""
        speaking = {flow.node for flow in self.flows if flow.node}
        return tuple(sorted(speaking.union(node for _, node in self.subscriptions or ())))

    @property
    def topics(self) -> Tuple[TopicTraffic, ...]:
        """Sum the flows up by topic, sorted by name; topics that are only heard have no type."""
        by_name: Dict[str, List[Flow]] = {topic: [] for topic, _ in self.subscriptions or ()}
        for flow in self.flows:
            by_name.setdefault(flow.topic, []).append(flow)
        return tuple(_summed_up(name, by_name[name]) for name in sorted(by_name))


def _summed_up(name: str, flows: List[Flow]) -> TopicTraffic:
    rates = [flow.rate for flow in flows if flow.rate is not None]
    types = tuple(sorted({flow.type for flow in flows}))
    return TopicTraffic(name, types, sum(flow.messages for flow in flows), sum(rates) if rates else None)
