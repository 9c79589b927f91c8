"""Line-ups: connections whose messages come together again and again, and what is to be told of them."""

from __future__ import annotations

from itertools import groupby
from operator import attrgetter
from typing import Callable, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Connection, Sighting
from rqt_mrta_py.transport.routes import Route

__all__ = ["LineUps", "Stretch"]

_MOST = 64
"""How many line-ups are remembered; the oldest makes room."""


class Stretch(NamedTuple):
    """Neighbours in a line-up: any number that are only sighted, all at once, or one message that somebody hears.

    Attributes:
        end: the row after the last.
        ordinals: of their topics.
        sightings: whom to tell that they came.
        heard: where the one goes that somebody hears.
    """

    end: int
    ordinals: Tuple[Iterator[int], ...]
    sightings: Tuple[Sighting, ...]
    heard: Optional[Route]


class _LineUp:
    __slots__ = ("connections", "stretches")

    def __init__(self, connections: Tuple[Connection, ...]) -> None:
        # Kept here, so that no other tuple can take over its identity.
        self.connections = connections
        self.stretches: Optional[Tuple[Stretch, ...]] = None


class LineUps:
    """Remembers line-ups by the identity of their tuples, and what is to be told of each.

    Args:
        route: finds the route of a connection.
        watchers: asked whom to tell of the messages of several connections.
    """

    def __init__(
        self, route: Callable[[Connection], Route], watchers: Sequence[Callable[[Sequence[Connection]], Sighting]]
    ) -> None:
        self._route = route
        self._watchers = watchers
        self._known: Dict[int, _LineUp] = {}

    def stretches(self, connections: Tuple[Connection, ...]) -> Tuple[Stretch, ...]:
        """Divide a line-up into stretches.

        Args:
            connections: of a batch.

        Returns:
            All of it, in its order; nothing of one that comes for the first time, for it may never come again.
        """
        known = self._known.get(id(connections))
        if known is None:
            if len(self._known) >= _MOST:
                del self._known[next(iter(self._known))]
            self._known[id(connections)] = _LineUp(connections)
            return ()
        if known.stretches is None:
            known.stretches = tuple(self._divide(connections))
        return known.stretches

    def _divide(self, connections: Tuple[Connection, ...]) -> Iterator[Stretch]:
        end = 0
        for heard, group in groupby(map(self._route, connections), attrgetter("heard")):
            routes = list(group)
            if heard:
                for route in routes:
                    end += 1
                    yield Stretch(end, (), (), route)
            else:
                members = connections[end : end + len(routes)]
                end += len(routes)
                yield Stretch(end, tuple([route.ordinals for route in routes]), self._sightings(routes, members), None)

    def _sightings(self, routes: List[Route], connections: Sequence[Connection]) -> Tuple[Sighting, ...]:
        if len(routes) == 1:
            return routes[0].sightings
        return tuple([sighting(connections) for sighting in self._watchers])
