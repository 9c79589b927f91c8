"""Minimum cuts in the graph of a relaxed solution: which sets of targets it does not reach."""

from __future__ import annotations

from typing import TYPE_CHECKING, List

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["cut_off_sets"]

_SCALE = 1_000_000
"""Capacities are whole numbers of this part of one, for the algorithm counts in them."""

_TOLERANCE = 1e-5
"""By how much less than the demand may flow in before a set counts as cut off."""


def cut_off_sets(capacity: NDArray[np.float64], sources: NDArray[np.float64], demand: float) -> List[NDArray[np.intp]]:
    """Find sets of nodes into which less flows than each of them needs.

    Args:
        capacity: of the arcs between nodes, shape (nodes, nodes).
        sources: what can flow into each node from outside, shape (nodes,).
        demand: what must be able to reach every node.

    Returns:
        The nodes of each set, rising; a set for every node that is not reached and is in no set before.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import breadth_first_order, maximum_flow

    nodes = len(sources)
    whole = np.zeros((nodes + 1, nodes + 1), dtype=np.int32)
    whole[:nodes, :nodes] = np.rint(np.clip(capacity, 0.0, demand) * _SCALE)
    whole[nodes, :nodes] = np.rint(np.clip(sources, 0.0, demand) * _SCALE)
    np.fill_diagonal(whole, 0)
    graph = csr_array(whole)
    found: List[NDArray[np.intp]] = []
    passed = np.zeros(nodes, dtype=bool)
    for node in range(nodes):
        if passed[node]:
            continue
        flow = maximum_flow(graph, nodes, node)
        if flow.flow_value >= (demand - _TOLERANCE) * _SCALE:
            continue
        # Nodes from which the one can still be reached along what is left; backward, so along the turned arcs.
        left = whole - flow.flow.toarray()
        reaching = breadth_first_order(csr_array((left > 0).T.astype(np.int8)), node, return_predecessors=False)
        cut = np.sort(reaching[reaching < nodes])
        passed[cut] = True
        found.append(cut)
    return found
