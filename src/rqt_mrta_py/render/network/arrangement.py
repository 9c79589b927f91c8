"""Where nodes and topics stand, whatever draws them."""

from __future__ import annotations

from typing import Dict, List, Mapping, NamedTuple, Sequence, Set

from rqt_mrta_py.model import CommunicationGraph
from rqt_mrta_py.render.network.layering import layered
from rqt_mrta_py.render.network.ordering import ordered
from rqt_mrta_py.render.network.placing import heights

__all__ = ["Arrangement", "Link", "Measures", "arranged", "links_of"]


class Link(NamedTuple):
    """A line between a node and a topic, by numbers of vertices: who says what, who hears it, or both."""

    node: int
    topic: int
    says: bool
    hears: bool


class Measures(NamedTuple):
    """Heights of vertices, and the gap between two of them [pixels]."""

    topic: float
    node: float
    gap: float
    passing: float = 4.0


class Arrangement(NamedTuple):
    """Where vertices stand.

    Attributes:
        layers: of vertices, from left to right, each in its order; where a link passes a layer there is a vertex for
            it, numbered behind nodes and topics.
        chains: for each link the vertices that it passes, its ends included, from left to right.
        reversed_links: numbers of the links that lead from right to left.
        sizes: height of each vertex [pixels].
        places: middle of each vertex [pixels].
    """

    layers: List[List[int]]
    chains: List[List[int]]
    reversed_links: Set[int]
    sizes: Mapping[int, float]
    places: Mapping[int, float]

    @property
    def bottom(self) -> float:
        """Where the lowest vertex ends [pixels]."""
        return max((self.places[vertex] + self.sizes[vertex] / 2.0 for vertex in self.places), default=0.0)


def links_of(graph: CommunicationGraph) -> List[Link]:
    """List the links of a graph, sorted; nodes are numbered first, then topics, both in the graph's order."""
    nodes = graph.nodes
    node_numbers = {node: number for number, node in enumerate(nodes)}
    topic_numbers = {topic.name: len(nodes) + number for number, topic in enumerate(graph.topics)}
    says = {(node_numbers[flow.node], topic_numbers[flow.topic]) for flow in graph.flows if flow.node}
    hears = {(node_numbers[node], topic_numbers[topic]) for topic, node in graph.subscriptions or ()}
    return [Link(*pair, pair in says, pair in hears) for pair in sorted(says | hears)]


def arranged(topics: Sequence[bool], links: Sequence[Link], measures: Measures) -> Arrangement:
    """Arrange nodes and topics in layers, from those who speak to those who hear.

    Args:
        topics: of each vertex whether it is a topic.
        links: between them.
        measures: of what is drawn.

    Returns:
        The same for the same graph.
    """
    found = layered(len(topics), [(each.node, each.topic) if each.says else (each.topic, each.node) for each in links])
    layers = ordered(found.layers, found.chains)
    sizes: Dict[int, float] = {
        vertex: measures.passing if vertex >= len(topics) else measures.topic if topics[vertex] else measures.node
        for layer in layers
        for vertex in layer
    }
    places = heights(layers, found.chains, sizes, measures.gap)
    return Arrangement(layers, found.chains, found.reversed_edges, sizes, places)
