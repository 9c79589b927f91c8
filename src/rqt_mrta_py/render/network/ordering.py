"""Order within layers, so that few edges cross: sweeps by barycentres (Sugiyama, Tagawa and Toda 1981)."""

from __future__ import annotations

from bisect import bisect_right, insort
from typing import Dict, List, Mapping, Sequence, Tuple

__all__ = ["crossings", "ordered"]

_SWEEPS = 12


def ordered(layers: Sequence[Sequence[int]], chains: Sequence[Sequence[int]]) -> List[List[int]]:
    """Order the vertices of each layer.

    Args:
        layers: of vertices.
        chains: of each edge, one vertex a layer.

    Returns:
        The layers; of the orders that sweeps from left to right and back came by, the first with the fewest crossings.
    """
    steps = sorted({(before, after) for chain in chains for before, after in zip(chain, chain[1:])})
    neighbours: Tuple[Dict[int, List[int]], Dict[int, List[int]]] = ({}, {})
    for before, after in steps:
        neighbours[0].setdefault(after, []).append(before)
        neighbours[1].setdefault(before, []).append(after)
    current = best = [list(layer) for layer in layers]
    fewest = crossings(current, steps)
    for sweep in range(_SWEEPS):
        backwards = sweep % 2
        current = [list(layer) for layer in current]
        numbers = range(len(current) - 2, -1, -1) if backwards else range(1, len(current))
        for number in numbers:
            other = current[number + 1 if backwards else number - 1]
            current[number] = _by_barycentre(current[number], neighbours[backwards], other)
        found = crossings(current, steps)
        if found < fewest:
            best, fewest = current, found
        if not fewest:
            break
    return best


def crossings(layers: Sequence[Sequence[int]], steps: Sequence[Tuple[int, int]]) -> int:
    """Count how often edges between neighbouring layers cross.

    Args:
        layers: of vertices, in order.
        steps: pairs of vertices, from a layer to the next one.
    """
    level = {vertex: number for number, layer in enumerate(layers) for vertex in layer}
    place = {vertex: index for layer in layers for index, vertex in enumerate(layer)}
    by_level: Dict[int, List[Tuple[int, int]]] = {}
    for before, after in steps:
        by_level.setdefault(level[before], []).append((place[before], place[after]))
    total = 0
    for pairs in by_level.values():
        seen: List[int] = []
        for _, end in sorted(pairs):
            total += len(seen) - bisect_right(seen, end)
            insort(seen, end)
    return total


def _by_barycentre(layer: Sequence[int], neighbours: Mapping[int, Sequence[int]], other: Sequence[int]) -> List[int]:
    """Sort a layer by the mean place of each vertex's neighbours; who has none stays where it is."""
    place = {vertex: index for index, vertex in enumerate(other)}
    scale = len(other) / max(len(layer), 1)
    keys = {}
    for index, vertex in enumerate(layer):
        near = neighbours.get(vertex)
        keys[vertex] = sum(place[each] for each in near) / len(near) if near else index * scale
    return sorted(layer, key=keys.__getitem__)
