"""The team's side of an embedded run: one integer tick, everything in a defined order."""

from __future__ import annotations

from typing import Any, Iterator, Optional, Sequence, Set, Tuple

from rqt_mrta_py.app.run.team import Team, build_team
from rqt_mrta_py.app.run.watch import SUPERVISOR_TOPICS
from rqt_mrta_py.app.run.world_side import WorldSide
from rqt_mrta_py.hooks import AgentChange, AnyOutgoing, Codec
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission
from rqt_mrta_py.transport import Node

__all__ = ["EmbeddedRun"]


class EmbeddedRun:
    """A simulated mission, wired and ready to be stepped."""

    def __init__(
        self,
        mission: Mission,
        duration: Optional[float],
        codec: Codec,
        manager: PluginManager,
        *,
        change: Optional[AgentChange] = None,
    ) -> None:
        """Build the world and the team; nothing moves or is said yet.

        Args:
            mission: with a scenario and a seed.
            duration: of the mission, at most [s]; None: the scenario's own.
            codec: writes and reads messages.
            manager: plugins, loaded.
            change: puts another agent in the place of each; None: they stay as they are.

        Raises:
            UsageError: the mission says nothing of what is simulated, no time passes, or more than ROS can tell.
            SimError: the world cannot be built as the scenario wants it.
        """
        self._world = WorldSide(mission, duration, codec, manager)
        self._simulation = self._world.simulation
        self.clock = self._world.clock
        self.last_tick = self._world.last_tick
        self.bus = self._world.bus
        self._end = self._world.end
        self._paused: Set[str] = set()
        try:
            self._team: Team = build_team(mission, self._world.seed, self._simulation, self.bus, manager, change=change)
        except BaseException:
            self._world.close()
            raise
        self._members = self._team.members
        self._world.speak_through({member.id: member.driver_node for member in self._members.values()})

    @property
    def team_hears_supervisor(self) -> bool:
        """Tell whether a robot listens to what the supervisor says; then both must take turns in one process."""
        return any(
            pattern.match(topic) is not None
            for member in self._members.values()
            for pattern in member.patterns
            for topic in SUPERVISOR_TOPICS
        )

    def timed_parts(self) -> Iterator[Tuple[Any, str, str]]:
        """Name what a benchmark times: object, method, and the part of the work that it is."""
        yield self._simulation.world, "step", "physics"
        yield self._simulation.world, "ranges", "rays"
        yield self._simulation.sensing, "measure", "sensing"
        yield self._simulation.sensing.transforms, "due", "sensing"
        yield self._simulation, "act", "sensing"
        yield self.bus, "publish_each", "bus"
        yield self.bus, "publish_together", "bus"
        yield self.bus, "deliver", "bus"
        for member in self._members.values():
            yield member.host, "step", "robots"

    def close(self) -> None:
        """Free the world."""
        self._world.close()

    def step(self, tick: int) -> None:
        """Let one tick pass; ticks count from 0 without gaps up to ``last_tick``."""
        now = self.clock.stamp(tick)
        self._world.happen(tick, now)
        self._heed_faults()
        self._world.tell(tick, now)
        self.bus.deliver(now)
        self._decide(tick, now)
        self._world.act(now)

    def is_over(self, tick: int) -> bool:
        """Tell whether the mission ends with a tick that has passed, before ``last_tick``."""
        return self._end.is_over(self.clock.stamp(tick))

    def _heed_faults(self) -> None:
        for robot_id, offset in self._simulation.clock_offsets.items():
            member = self._members[robot_id]
            member.agent_node.clock_offset = member.driver_node.clock_offset = offset
        if self._simulation.stopped_robots != self._paused:
            self._pause_and_resume()

    def _pause_and_resume(self) -> None:
        for member in self._members.values():
            stopped = self._simulation.stopped(member.id)
            if stopped and member.id not in self._paused:
                self._paused.add(member.id)
                member.host.pause()
            elif member.id in self._paused and not stopped:
                self._paused.remove(member.id)
                member.agent_node.discard()
                member.driver_node.discard()
                member.host.resume()

    def _decide(self, tick: int, now: float) -> None:
        self.bus.publish_each(self._decisions(tick, now), now)
        self.bus.deliver(now, self._team.commands)

    def _decisions(self, tick: int, now: float) -> Iterator[Tuple[Node, Sequence[AnyOutgoing]]]:
        """Let one robot after the other decide what to say."""
        offsets, paused = self._simulation.clock_offsets, self._paused
        for name, member in self._members.items():
            if name not in paused:
                yield member.agent_node, member.host.step(tick, now + offsets.get(name, 0.0))
