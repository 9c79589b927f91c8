"""Bids as grounds, by the topics and fields that an architecture's file names."""

from __future__ import annotations

import math
from typing import Dict, List, Sequence, Tuple

from rqt_mrta_py.hooks import GroundsReader, Heard, Subscription
from rqt_mrta_py.model import ArchitectureSpec, Ground
from rqt_mrta_py.supervisor.joins import JoinTable, join_tables
from rqt_mrta_py.supervisor.readers import TopicReader, task_readers

__all__ = ["bid_grounds"]


def bid_grounds(architecture: ArchitectureSpec) -> Sequence[GroundsReader]:
    """Make readers of an architecture's bids, in the order in which one message shall be taken in.

    Args:
        architecture: declares them; of one that does not, nothing is read.
    """
    tables = join_tables(architecture.bids)
    readers: List[GroundsReader] = [_Joined(table) for table in tables]
    joins = {table.join: table for table in tables}
    return [*readers, *(_Bids(reader) for reader in task_readers(architecture.bids, joins))]


class _Joined:
    """Hears for a table what stands for a task."""

    def __init__(self, table: JoinTable) -> None:
        self._table = table

    def subscriptions(self) -> Sequence[Subscription]:
        return (self._table.subscription(),)

    def hear(self, heard: Heard) -> Sequence[Ground]:
        self._table.hear(heard)
        return ()


class _Bids:
    """Reads the bids of one topic; one that is told again is no new ground."""

    def __init__(self, reader: TopicReader) -> None:
        self._reader = reader
        self._newest: Dict[Tuple[str, str], float] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        wish = self._reader.subscription()
        return (wish._replace(fields=tuple(dict.fromkeys((*wish.fields, self._reader.topic.bid_field)))),)

    def hear(self, heard: Heard) -> Sequence[Ground]:
        if not self._reader.counts(heard):
            return ()
        amount = heard.fields.get(self._reader.topic.bid_field)
        task, robot = self._reader.task_of(heard), self._reader.robot_of(heard)
        if not task or isinstance(amount, bool) or not isinstance(amount, (int, float)) or not math.isfinite(amount):
            return ()
        if self._newest.get((task, robot)) == amount:
            return ()
        self._newest[task, robot] = amount
        return (Ground(heard.receipt, task, f"bids {amount:.6g}", robot, {"bid": amount}),)
