"""Prim allocation: robots grow a minimum spanning forest together, and each walks its own tree.

M. G. Lagoudakis, M. Berhault, S. Koenig, P. Keskinocak and A. J. Kleywegt, Simple auctions with performance guarantees
for multi-robot task allocation, IROS 2004. The walk that takes the lightest subtree first is an improvement for open
paths (Sariel, Erdogan and Balch 2007).
"""

from __future__ import annotations

from typing import Dict, List, Tuple

import numpy as np

from mtrp_allocators.routes import Distances, Routes

__all__ = ["prim_lightest_first", "prim_original"]


def prim_original(ways: Distances) -> Routes:
    """Walk each tree depth-first, children in the order in which they joined (PRIM-ORG).

    Of total length it is at most twice the optimum.

    Args:
        ways: between all places.
    """
    return tuple(_walk(tree.children, {}) for tree in _forest(ways))


def prim_lightest_first(ways: Distances) -> Routes:
    """Walk each tree depth-first, the child with the lightest subtree first (PRIM-SD).

    A subtree weighs what its edges do, the one that joins it included; of equal weights the older child comes first.

    Args:
        ways: between all places.
    """
    return tuple(_walk(tree.children, _weights(tree)) for tree in _forest(ways))


class _Tree:
    """One robot's tree.

    Attributes:
        children: targets below each node in the order of joining; the root is -1.
        edges: what joins each target to the node above it [m], in the order of joining.
        parents: the node above each target.
    """

    def __init__(self) -> None:
        self.children: Dict[int, List[int]] = {-1: []}
        self.edges: Dict[int, float] = {}
        self.parents: Dict[int, int] = {}

    def join(self, target: int, parent: int, edge: float) -> None:
        self.children[parent].append(target)
        self.children[target] = []
        self.edges[target] = edge
        self.parents[target] = parent


def _forest(ways: Distances) -> List[_Tree]:
    """In every round the target that is nearest to any node of any tree joins that node.

    Of equal distances the smaller index wins, of robots, then of targets; then the older node.
    """
    robots, targets = ways.starts.shape
    trees = [_Tree() for _ in range(robots)]
    if not robots:
        return trees
    owner = ways.starts.argmin(axis=0)
    nearest = ways.starts.min(axis=0)
    parent = np.full(targets, -1)
    joined = np.zeros(targets, dtype=bool)
    for _ in range(targets):
        open_nearest = np.where(joined, np.inf, nearest)
        tied = np.flatnonzero(open_nearest == open_nearest.min())
        tied = tied[~joined[tied]]
        target = int(tied[np.argmin(owner[tied])])
        robot = int(owner[target])
        trees[robot].join(target, int(parent[target]), float(nearest[target]))
        joined[target] = True
        apart = ways.between[target]
        closer = (apart < nearest) | ((apart == nearest) & (robot < owner))
        nearest = np.where(closer, apart, nearest)
        parent = np.where(closer, target, parent)
        owner = np.where(closer, robot, owner)
    return trees


def _weights(tree: _Tree) -> Dict[int, float]:
    weights = dict(tree.edges)
    for target in reversed(list(tree.edges)):
        parent = tree.parents[target]
        if parent >= 0:
            weights[parent] += weights[target]
    return weights


def _walk(children: Dict[int, List[int]], weights: Dict[int, float]) -> Tuple[int, ...]:
    """Visit in the order of first visits; the sort keeps the order of joining where weights are equal or none."""
    order: List[int] = []
    waiting = [-1]
    while waiting:
        node = waiting.pop()
        if node >= 0:
            order.append(node)
        waiting.extend(sorted(children[node], key=lambda child: weights.get(child, 0.0))[::-1])
    return tuple(order)
