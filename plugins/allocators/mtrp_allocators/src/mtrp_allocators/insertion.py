"""Sequential single-item auctions: one target is sold at a time, and robots bid by cheapest insertion.

M. G. Lagoudakis, E. Markakis, D. Kempe, P. Keskinocak, A. Kleywegt, S. Koenig, C. Tovey, A. Meyerson and S. Jain,
Auction-based multi-robot routing, RSS 2005.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Tuple

import numpy as np

from mtrp_allocators.routes import Distances, Routes

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["insertion_costs", "sell_for_makespan", "sell_for_sum"]


def sell_for_sum(ways: Distances) -> Routes:
    """Sell targets one by one, each robot bidding by how much its path grows (BidSumPath).

    Of total length it is at most twice the optimum.

    Args:
        ways: between all places.
    """
    return _sell(ways, by_path=False)


def sell_for_makespan(ways: Distances) -> Routes:
    """Sell targets one by one, each robot bidding how long its path would be (BidMaxPath).

    Args:
        ways: between all places.
    """
    return _sell(ways, by_path=True)


def insertion_costs(ways: Distances, robot: int, route: List[int]) -> Tuple[NDArray[np.float64], NDArray[np.intp]]:
    """Find the cheapest place in a route for every target.

    With the route's stops p_0 (the start), p_1, ..., p_n, target t costs

        min( min_i d(p_i, t) + d(t, p_i+1) - d(p_i, p_i+1),  d(p_n, t) )

    for after the last stop one way is enough.

    Args:
        ways: between all places.
        robot: whose route it is.
        route: its targets in the order of visiting.

    Returns:
        How much longer the route gets [m], and before which of its targets each goes; of equally cheap places the
        earliest. Both of shape (targets,).
    """
    stops = np.asarray(route, dtype=np.intp)
    to_stops = ways.between[stops]
    from_stops = np.vstack((ways.starts[robot][None], to_stops))
    legs = np.append(ways.starts[robot, stops[:1]], ways.between[stops[:-1], stops[1:]])
    growth = from_stops
    growth[:-1] += to_stops - legs[:, None]
    places = growth.argmin(axis=0)
    return growth[places, np.arange(growth.shape[1])], places


def _sell(ways: Distances, by_path: bool) -> Routes:
    """Give the best bid the target: of equal bids the robot with the smaller index, then the smaller target wins."""
    robots, targets = ways.starts.shape
    routes: List[List[int]] = [[] for _ in range(robots)]
    lengths = np.zeros(robots)
    growth = np.array(ways.starts)
    places = np.zeros(growth.shape, dtype=np.intp)
    for _ in range(targets if robots else 0):
        bids = growth + lengths[:, None] if by_path else growth
        robot, target = np.unravel_index(int(bids.argmin()), bids.shape)
        lengths[robot] += growth[robot, target]
        routes[robot].insert(int(places[robot, target]), int(target))
        growth[robot], places[robot] = insertion_costs(ways, int(robot), routes[robot])
        growth[:, [stop for route in routes for stop in route]] = np.inf
    return tuple(map(tuple, routes))
