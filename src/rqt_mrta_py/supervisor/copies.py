"""Watches of a copied team: most of them are only shown, so each is copied when it is first touched."""

from __future__ import annotations

from typing import Dict, Iterable, Mapping, TypeVar

from rqt_mrta_py.supervisor.robots import RobotWatch
from rqt_mrta_py.supervisor.tasks import TaskWatch

__all__ = ["Copies", "watches_in"]

_Watch = TypeVar("_Watch", RobotWatch, TaskWatch)


class Copies(Dict[str, _Watch]):
    """Copies of watches by id; asking for one by its id makes it.

    Args:
        originals: by id, in the order in which they are shown; they do not change while the copies are used.
    """

    def __init__(self, originals: Mapping[str, _Watch]) -> None:
        super().__init__()
        self.originals: Mapping[str, _Watch] = originals

    def __missing__(self, watch_id: str) -> _Watch:
        copied: _Watch = self.originals[watch_id].fork()
        self[watch_id] = copied
        return copied


def watches_in(watches: Dict[str, _Watch]) -> Iterable[_Watch]:
    """Give watches in their order; of copies the originals where nothing was touched."""
    if isinstance(watches, Copies):
        return {**watches.originals, **watches}.values()
    return watches.values()
