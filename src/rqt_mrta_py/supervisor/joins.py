"""Joins: what stands for a task, such as an auction, by the messages that say so."""

from __future__ import annotations

from typing import Dict, Iterable, Tuple

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import MonitoredTopic, TopicJoin, normalise_id
from rqt_mrta_py.supervisor.values import text_of

__all__ = ["JoinTable", "join_tables"]

_MOST = 65_536


class JoinTable:
    """Which task each id stands for that a topic has named so far; the newest message of an id counts.

    Only the ids that were named last are kept, 65,536 of them: a stream without end must not fill the memory.

    Args:
        join: the topic.
    """

    def __init__(self, join: TopicJoin) -> None:
        self.join = join
        self._tasks: Dict[str, str] = {}

    def subscription(self) -> Subscription:
        """Ask for what is read here."""
        return Subscription(
            self.join.name, self.join.type, tuple(dict.fromkeys((self.join.field, self.join.task_field)))
        )

    def hear(self, heard: Heard) -> None:
        """Take in for which task an id stands from now on; a message without either id says nothing."""
        key = text_of(heard.fields, self.join.field)
        task = normalise_id(text_of(heard.fields, self.join.task_field))
        if not (key and task):
            return
        self._tasks.pop(key, None)
        self._tasks[key] = task
        if len(self._tasks) > _MOST:
            del self._tasks[next(iter(self._tasks))]

    def find(self, key: str) -> str:
        """Give the task that an id stands for; empty if none was named."""
        return self._tasks.get(key, "")


def join_tables(topics: Iterable[MonitoredTopic]) -> Tuple[JoinTable, ...]:
    """Make a table for each join of some topics; topics that share one share its table."""
    return tuple(JoinTable(join) for join in dict.fromkeys(topic.join for topic in topics if topic.join is not None))
