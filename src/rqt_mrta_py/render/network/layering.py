"""Layers of a directed graph: each edge leads from a layer to the next one to the right.

After Sugiyama, Tagawa and Toda (1981), "Methods for visual understanding of hierarchical system structures". Cycles are
broken by the heuristic of Eades, Lin and Smyth (1993), "A fast and effective heuristic for the feedback arc set
problem".
"""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Sequence, Set, Tuple

__all__ = ["Layered", "layered"]

Edge = Tuple[int, int]


class Layered(NamedTuple):
    """A graph in layers.

    Attributes:
        layers: of vertices, from left to right. Where an edge passes a layer there is a vertex for it, numbered behind
            those of the graph.
        chains: for each edge the vertices that it passes, its ends included, from left to right.
        reversed_edges: numbers of the edges that lead from right to left.
    """

    layers: List[List[int]]
    chains: List[List[int]]
    reversed_edges: Set[int]


def layered(count: int, edges: Sequence[Edge]) -> Layered:
    """Put the vertices of a graph into layers.

    Args:
        count: of vertices, which are numbered from 0; of equally good ones the first counts.
        edges: pairs of different vertices.

    Returns:
        The layers, vertices in the order of their numbers.
    """
    place = {vertex: index for index, vertex in enumerate(_sequence(count, edges))}
    backwards = {number for number, (start, end) in enumerate(edges) if place[start] > place[end]}
    forward = [(end, start) if number in backwards else (start, end) for number, (start, end) in enumerate(edges)]
    levels = _levels(count, forward, sorted(range(count), key=place.__getitem__))
    layers: List[List[int]] = [[] for _ in range(max(levels, default=-1) + 1)]
    for vertex in range(count):
        layers[levels[vertex]].append(vertex)
    chains = []
    fresh = count
    for start, end in forward:
        chain = [start]
        for level in range(levels[start] + 1, levels[end]):
            layers[level].append(fresh)
            chain.append(fresh)
            fresh += 1
        chains.append([*chain, end])
    return Layered(layers, chains, backwards)


def _sequence(count: int, edges: Sequence[Edge]) -> List[int]:
    """Line vertices up so that few edges lead backwards: sinks last, sources first, then who sends most on balance."""
    ahead: List[Set[int]] = [set() for _ in range(count)]
    behind: List[Set[int]] = [set() for _ in range(count)]
    for start, end in edges:
        ahead[start].add(end)
        behind[end].add(start)
    left = list(range(count))
    first: List[int] = []
    last: List[int] = []
    while left:
        chosen = next((vertex for vertex in left if not ahead[vertex]), None)
        if chosen is not None:
            last.append(chosen)
        else:
            chosen = next((vertex for vertex in left if not behind[vertex]), None)
            if chosen is None:
                chosen = max(left, key=lambda vertex: (len(ahead[vertex]) - len(behind[vertex]), -vertex))
            first.append(chosen)
        left.remove(chosen)
        for other in ahead[chosen]:
            behind[other].discard(chosen)
        for other in behind[chosen]:
            ahead[other].discard(chosen)
    return first + last[::-1]


def _levels(count: int, forward: Sequence[Edge], order: Sequence[int]) -> List[int]:
    """Give each vertex the layer behind its last predecessor; one without any stands right before its successors."""
    after: Dict[int, List[int]] = {}
    for start, end in forward:
        after.setdefault(start, []).append(end)
    levels = [0] * count
    for vertex in order:
        for other in after.get(vertex, ()):
            levels[other] = max(levels[other], levels[vertex] + 1)
    entered = {end for _, end in forward}
    for vertex in order:
        if vertex not in entered and vertex in after:
            levels[vertex] = min(levels[other] for other in after[vertex]) - 1
    return levels
