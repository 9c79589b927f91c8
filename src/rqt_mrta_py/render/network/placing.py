"""Heights within layers: each vertex as near as may be to the middle of its neighbours, and none upon another."""

from __future__ import annotations

from typing import Dict, List, Mapping, Sequence

__all__ = ["heights"]

_ROUNDS = 10


def heights(
    layers: Sequence[Sequence[int]], chains: Sequence[Sequence[int]], sizes: Mapping[int, float], gap: float
) -> Dict[int, float]:
    """Place vertices.

    Args:
        layers: of vertices, from top to bottom.
        chains: of each edge, one vertex a layer.
        sizes: height of each vertex [pixels].
        gap: between two that stand one above the other [pixels].

    Returns:
        The middle of each vertex, the uppermost edge of all being 0 [pixels].
    """
    near: Dict[int, List[int]] = {}
    for chain in chains:
        for before, after in zip(chain, chain[1:]):
            near.setdefault(before, []).append(after)
            near.setdefault(after, []).append(before)
    places: Dict[int, float] = {}
    for layer in layers:
        y = 0.0
        for vertex in layer:
            places[vertex] = y + sizes[vertex] / 2.0
            y += sizes[vertex] + gap
    for number in range(_ROUNDS):
        for layer in layers if number % 2 == 0 else reversed(layers):
            wishes = [
                sum(places[each] for each in near[vertex]) / len(near[vertex]) if vertex in near else places[vertex]
                for vertex in layer
            ]
            places.update(zip(layer, _apart(wishes, [sizes[vertex] for vertex in layer], gap)))
    top = min((places[vertex] - sizes[vertex] / 2.0 for vertex in places), default=0.0)
    return {vertex: place - top for vertex, place in places.items()}


def _apart(wishes: Sequence[float], sizes: Sequence[float], gap: float) -> List[float]:
    """Give the places in order that differ least from what is wished, in the sum of squares, and keep apart.

    Distances taken off, places only have to increase, so this is isotonic regression: pools of neighbours that would
    change their order share their mean (Ayer et al. 1955).
    """
    offsets = [0.0]
    for before, after in zip(sizes, sizes[1:]):
        offsets.append(offsets[-1] + (before + after) / 2.0 + gap)
    pools: List[List[float]] = []
    for wish, offset in zip(wishes, offsets):
        pools.append([wish - offset, 1.0])
        while len(pools) > 1 and pools[-2][0] > pools[-1][0]:
            mean, weight = pools.pop()
            total = pools[-1][1] + weight
            pools[-1][:] = [(pools[-1][0] * pools[-1][1] + mean * weight) / total, total]
    means = [mean for mean, weight in pools for _ in range(round(weight))]
    return [mean + offset for mean, offset in zip(means, offsets)]
