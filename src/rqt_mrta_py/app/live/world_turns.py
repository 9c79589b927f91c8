"""The world of a mission whose robots decide elsewhere, turn by turn; does no I/O."""

from __future__ import annotations

from collections import deque
from typing import Any, Callable, Deque, Dict, List, Sequence, Set, Tuple

from rqt_mrta_py.app.live.hold_back import agent_node
from rqt_mrta_py.app.live.tick_messages import Said, TickDone, TickNews
from rqt_mrta_py.app.run.world_side import WorldSide
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Heard, Stamped, Subscription, TeamHeard
from rqt_mrta_py.model import Mission, ScenarioEventKind
from rqt_mrta_py.transport import Batch, Dispatcher
from rqt_mrta_py.transport.patterns import resolve_topic

__all__ = ["WorldTurns", "refuse_radio"]

_RADIO_EVENTS = (
    ScenarioEventKind.RADIO_FAILS,
    ScenarioEventKind.RADIO_PARTITIONS,
    ScenarioEventKind.RADIO_CHANGES,
)


class WorldTurns:
    """Plays the world, and keeps the account of who said what.

    A tick is ``open``, then ``hear`` and ``answer`` as messages arrive, then ``close``. In lock step ``close`` waits
    until nobody is ``awaited`` any more; free-running it comes when the time has come.

    Attributes:
        robots: ids, in the team's order.
        command_topics: what is to be handed to ``hear``; where the mission may end early, how tasks go too.

    Args:
        world: of the mission; nothing has happened yet.
        lock_step: whether agents answer each tick, not only the first.
    """

    def __init__(self, world: WorldSide, lock_step: bool) -> None:
        self._world = world
        self._lock_step = lock_step
        self.robots = tuple(robot.id for robot in world.mission.application.robots)
        drivers = {robot: world.bus.node(f"/{robot}/driver", robot=robot) for robot in self.robots}
        world.speak_through(drivers)
        world.bus.tap(self._collect)
        self._said: List[Stamped] = []
        self._by_agents: Tuple[Said, ...] = ()
        self._absent: Set[str] = set()
        self._answers: Dict[str, TickDone] = {}
        self._tick = -1
        self._arrived: Dict[Tuple[str, str], Deque[Stamped]] = {}
        self._dispatcher = Dispatcher(world.bus.codec, lambda _heard, _text: None)
        self._hearings: List[_Hearing] = []
        ears = world.simulation.ears(self.robots)
        self.command_topics = (
            *(topic for ear in ears for topic in self._listen(ear.robots, ear.wish, ear.hear)),
            *self._listen_for_the_end(),
        )

    def open(self, tick: int) -> Tuple[Sequence[Stamped], TickNews]:
        """Begin a tick.

        Args:
            tick: from 0 without gaps up to the world's last one.

        Returns:
            What the simulation says, in order, and the news of the tick that come after it.
        """
        world = self._world
        now = world.clock.stamp(tick)
        self._tick = tick
        world.happen(tick, now)
        world.tell(tick, now)
        # The mission's end hears what an operator orders in the tick in which it is said.
        world.bus.deliver(now)
        said, self._said = self._said, []
        own = tuple(Said(each.connection.caller, each.connection.topic) for each in said)
        news = TickNews(
            tick,
            now,
            self._lock_step,
            stopped=frozenset(world.simulation.stopped_robots),
            clock_offsets=dict(world.simulation.clock_offsets),
            absent=frozenset(self._absent),
            manifest=(*self._by_agents, *own),
        )
        self._answers.clear()
        return said, news

    def end(self) -> TickNews:
        """End the mission: give the news that nobody decides any more, with what was said in the last tick."""
        tick = self._tick + 1
        absent = frozenset(self._absent)
        return TickNews(
            tick, self._world.clock.stamp(tick), self._lock_step, over=True, absent=absent, manifest=self._by_agents
        )

    @property
    def is_over(self) -> bool:
        """Tell whether the mission ends with the tick that was closed last, before the world's last one."""
        return self._world.end.is_over(self._world.clock.stamp(self._tick))

    def hear(self, stamped: Stamped) -> None:
        """Take in a command that has arrived."""
        key = (stamped.connection.caller, stamped.connection.topic)
        self._arrived.setdefault(key, deque()).append(stamped)

    def answer(self, done: TickDone) -> None:
        """Take in that an agent has taken its turn; answers of other ticks count for nothing."""
        if done.tick == self._tick and done.robot in self.robots:
            self._answers[done.robot] = done

    @property
    def awaited(self) -> Tuple[str, ...]:
        """Ids of robots whose agents have not answered, or whose announced commands have not all arrived."""
        return tuple(robot for robot in self.robots if not self._is_complete(robot))

    def close(self) -> None:
        """End the tick: act on what was commanded, and let the world go on."""
        now = self._world.clock.stamp(self._tick)
        self._absent = set(self.robots).difference(self._answers) if self._lock_step else set()
        self._by_agents = tuple(
            Said(agent_node(robot), topic)
            for robot in self.robots
            if self._lock_step and robot in self._answers
            for topic in self._answers[robot].topics
        )
        for arrived in self._arrived.values():
            for stamped in arrived:
                self._dispatcher.feed(stamped)
        self._arrived.clear()
        offsets = self._world.simulation.clock_offsets
        for hearing in self._hearings:
            hearing.tell(now, offsets)
        self._world.act(now)

    def _is_complete(self, robot: str) -> bool:
        done = self._answers.get(robot)
        if done is None:
            return False
        node = agent_node(robot)
        announced = [topic for topic in done.topics if topic in self.command_topics]
        return all(len(self._arrived.get((node, topic), ())) >= announced.count(topic) for topic in set(announced))

    def _collect(self, batch: Batch) -> None:
        self._said.extend(batch)

    def _listen_for_the_end(self) -> Sequence[str]:
        end = self._world.end
        if not end.is_awaited:
            return ()
        self._dispatcher.subscribe(end.SUBSCRIPTION, end.hear)
        return (end.SUBSCRIPTION.topic,)

    def _listen(self, robots: Sequence[str], wish: Subscription, tell: Callable[[TeamHeard], None]) -> Sequence[str]:
        hearing = _Hearing(robots, tell)
        self._hearings.append(hearing)
        topics = [resolve_topic(wish.topic, f"/{robot}/driver") for robot in robots]
        for row, topic in enumerate(topics):
            self._dispatcher.subscribe(wish._replace(topic=topic), hearing.listener(row))
        return topics


class _Hearing:
    """What drivers of one kind hear in a tick."""

    def __init__(self, robots: Sequence[str], tell: Callable[[TeamHeard], None]) -> None:
        self._robots = robots
        self._tell = tell
        self._heard: List[Tuple[int, Heard]] = []

    def listener(self, row: int) -> Callable[[Heard], None]:
        """Give who hears for one robot."""
        return lambda heard: self._heard.append((row, heard))

    def tell(self, now: float, offsets: Any) -> None:
        """Tell the simulation all that was heard."""
        if not self._heard:
            return
        rows = [row for row, _ in self._heard]
        receipts = [now + offsets.get(self._robots[row], 0.0) for row in rows]
        self._tell(TeamHeard(rows, receipts, [heard.fields for _, heard in self._heard]))
        self._heard.clear()


def refuse_radio(mission: Mission) -> None:
    """Refuse a mission whose scenario has a radio that loses or delays messages.

    Raises:
        UsageError: it has; names what it is.
    """
    scenario = mission.scenario
    if scenario is None:
        return
    what = [] if scenario.radio.kind == "perfect" else [f"the radio {scenario.radio.kind!r}"]
    kinds = dict.fromkeys(event.kind.value for event in scenario.events if event.kind in _RADIO_EVENTS)
    what.extend(f"the event {kind!r}" for kind in kinds)
    if what:
        raise UsageError(
            f"{mission.application.package}: its scenario has {' and '.join(what)}, and the radio between robots is "
            "simulated on the embedded bus only; run it without --ros, or take that out of the scenario"
        )
