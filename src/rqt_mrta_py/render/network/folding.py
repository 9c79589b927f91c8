"""Large teams on one picture: what all robots say in their own namespaces is shown once."""

from __future__ import annotations

from typing import Dict, FrozenSet, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple

from rqt_mrta_py.model import CommunicationGraph, Flow

__all__ = ["ROBOT", "Folded", "folded"]

ROBOT = "<robot>"
"""Stands for each robot's id in a name."""


class Folded(NamedTuple):
    """A graph that is small enough to be drawn.

    Attributes:
        graph: rates of topics that stand for several are means.
        counts: how many nodes or topics a name stands for, where it is more than one.
        left_out: how many topics there are besides, those of which the fewest messages were heard.
    """

    graph: CommunicationGraph
    counts: Mapping[str, int]
    left_out: int


def folded(graph: CommunicationGraph, robots: Sequence[str], most: int) -> Folded:
    """Fold a graph, if it has too many topics.

    Args:
        graph: as it is.
        robots: ids of the robots.
        most: topics that can be drawn.
    """
    counts: Dict[str, int] = {}
    if len(graph.topics) > most:
        graph, counts = _without_ids(graph, robots)
    topics = graph.topics
    if len(topics) <= most:
        return Folded(graph, counts, 0)
    loudest = sorted(topics, key=lambda topic: (-topic.messages, topic.name))[:most]
    kept = {topic.name for topic in loudest}
    flows = tuple(flow for flow in graph.flows if flow.topic in kept)
    hearing = graph.subscriptions
    if hearing is not None:
        hearing = tuple(pair for pair in hearing if pair[0] in kept)
    return Folded(CommunicationGraph(flows, hearing), counts, len(topics) - len(kept))


def _without_ids(graph: CommunicationGraph, robots: Sequence[str]) -> Tuple[CommunicationGraph, Dict[str, int]]:
    known = frozenset(robots)
    names: Dict[str, Set[str]] = {}

    def fold(name: str) -> str:
        short = _short(name, known)
        names.setdefault(short, set()).add(name)
        return short

    joined: Dict[Tuple[str, str, str], List[Flow]] = {}
    for flow in graph.flows:
        key = (fold(flow.topic), fold(flow.node) if flow.node else "", flow.type)
        joined.setdefault(key, []).append(flow)
    hearing = graph.subscriptions
    if hearing is not None:
        hearing = tuple(sorted({(fold(topic), fold(node)) for topic, node in hearing}))
    flows = tuple(_mean(key, joined[key], len(names[key[0]])) for key in sorted(joined))
    return CommunicationGraph(flows, hearing), {name: len(each) for name, each in names.items() if len(each) > 1}


def _mean(key: Tuple[str, str, str], flows: Iterable[Flow], topics: int) -> Flow:
    topic, node, type_name = key
    flows = list(flows)
    rates = [flow.rate for flow in flows if flow.rate is not None]
    rate: Optional[float] = sum(rates) / topics if rates else None
    return Flow(node, topic, type_name, sum(flow.messages for flow in flows), rate)


def _short(name: str, known: FrozenSet[str]) -> str:
    """Put the token in the place of the longest id that a name begins with."""
    parts = name.split("/")
    for length in range(len(parts) - 1, 1, -1):
        if "/".join(parts[1:length]) in known:
            return "/".join(["", ROBOT, *parts[length:]])
    return name
