"""Writes down what the robots of a mission have learned, for the next one."""

from __future__ import annotations

from typing import Dict, Mapping, Sequence

from mrta_l_alliance.memory import Memory, written
from mrta_l_alliance.messages import MEMORY_FIELDS, MEMORY_TOPICS, MEMORY_TYPE, memory_of
from rqt_mrta_py.hooks import ExporterSetup, Heard, Subscription
from rqt_mrta_py.model import MissionRecord

__all__ = ["MemoryExporter", "team_memory"]

_SUBSCRIPTION = Subscription(MEMORY_TOPICS, MEMORY_TYPE, MEMORY_FIELDS)


def team_memory(memories: Mapping[str, Memory]) -> Memory:
    """Join what robots know: of each robot what it knows of itself, else what the first who knows most knows of it.

    Args:
        memories: by robot.
    """
    joined = Memory()
    for observer in sorted(memories):
        for robot, task, performance in memories[observer]:
            own = memories.get(robot, Memory()).known.get((robot, task))
            if own is None and performance.attempts > joined.of(robot, task).attempts:
                joined = joined.including(robot, task, performance)
            elif own is not None and observer == robot:
                joined = joined.including(robot, task, own)
    return joined


class MemoryExporter:
    """Writes ``team.yaml``, and ``<robot>.yaml`` for each robot that said what it knows.

    Each file is one line, the value of the parameter ``learning/memory``.

    Args:
        setup: not needed.
    """

    def __init__(self, setup: ExporterSetup) -> None:
        self._memories: Dict[str, Memory] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: the robots' memories."""
        return (_SUBSCRIPTION,)

    def hear(self, heard: Heard) -> None:
        """Take in what a robot knows; one that contradicts itself is passed over."""
        memory = memory_of(heard.fields)
        if memory is not None:
            self._memories[heard.robot] = memory

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        """Give the memories by file name; none where no robot said anything."""
        if not self._memories:
            return {}
        files = {"team.yaml": _file(team_memory(self._memories))}
        for robot in sorted(self._memories):
            files.setdefault(f"{robot}.yaml", _file(self._memories[robot]))
        return files


def _file(memory: Memory) -> bytes:
    return f"{written(memory)}\n".encode()
