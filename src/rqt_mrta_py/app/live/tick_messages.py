"""What simulation and agents tell one another of ticks, as values and as messages."""

from __future__ import annotations

from typing import Any, FrozenSet, Mapping, NamedTuple, Tuple

from rqt_mrta_py.hooks import Outgoing

__all__ = ["DONE_TOPIC", "DONE_TYPE", "TICK_TOPIC", "TICK_TYPE", "Said", "TickDone", "TickNews"]

TICK_TOPIC = "/mrta/simulation/tick"
TICK_TYPE = "rqt_mrta_py/SimulationTick"
DONE_TOPIC = "/mrta/simulation/done"
DONE_TYPE = "rqt_mrta_py/TickDone"


class Said(NamedTuple):
    """One line of a manifest: a message that was said.

    Attributes:
        caller: who said it, as on the embedded bus.
        topic: where, resolved.
    """

    caller: str
    topic: str


class TickNews(NamedTuple):
    """What the simulation tells of a tick.

    Attributes:
        tick: from 0.
        stamp: of the tick [s].
        lock_step: whether it waits for the agents' answers.
        over: whether the mission is over, so that nobody decides any more.
        stopped: ids of robots that stand still and are silent.
        clock_offsets: by robot: its clock minus the true one [s]; those that are right are left out.
        absent: ids of robots whose agents did not answer the tick before.
        manifest: what the simulation said in this tick, in order; in lock step before it what the agents said since
            the one before.
    """

    tick: int
    stamp: float
    lock_step: bool = False
    over: bool = False
    stopped: FrozenSet[str] = frozenset()
    clock_offsets: Mapping[str, float] = {}
    absent: FrozenSet[str] = frozenset()
    manifest: Tuple[Said, ...] = ()

    def message(self) -> Outgoing:
        """Give the message that tells this."""
        fields = {
            "tick": self.tick,
            "stamp": self.stamp,
            "lock_step": self.lock_step,
            "over": self.over,
            "stopped": sorted(self.stopped),
            "offset_robots": list(self.clock_offsets),
            "clock_offsets": list(self.clock_offsets.values()),
            "absent": sorted(self.absent),
            "callers": [said.caller for said in self.manifest],
            "topics": [said.topic for said in self.manifest],
        }
        return Outgoing(TICK_TOPIC, TICK_TYPE, fields)

    @classmethod
    def of(cls, fields: Mapping[str, Any]) -> TickNews:
        """Read a decoded message.

        Args:
            fields: of the message, nested builtins.
        """
        return cls(
            tick=fields["tick"],
            stamp=fields["stamp"],
            lock_step=fields["lock_step"],
            over=fields["over"],
            stopped=frozenset(fields["stopped"]),
            clock_offsets=dict(zip(fields["offset_robots"], fields["clock_offsets"])),
            absent=frozenset(fields["absent"]),
            manifest=tuple(map(Said, fields["callers"], fields["topics"])),
        )


class TickDone(NamedTuple):
    """What a robot's agent answers once it has taken its turn in a tick.

    Attributes:
        tick: which.
        robot: its id.
        topics: of all that the agent said in this tick, in order, resolved.
    """

    tick: int
    robot: str
    topics: Tuple[str, ...]

    def message(self) -> Outgoing:
        """Give the message that tells this."""
        fields = {"tick": self.tick, "robot_id": self.robot, "topics": list(self.topics)}
        return Outgoing(DONE_TOPIC, DONE_TYPE, fields)

    @classmethod
    def of(cls, fields: Mapping[str, Any]) -> TickDone:
        """Read a decoded message.

        Args:
            fields: of the message, nested builtins.
        """
        return cls(fields["tick"], fields["robot_id"], tuple(fields["topics"]))
