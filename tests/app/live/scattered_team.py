"""A team in lock step whose messages take any time to arrive: only those of one node on one topic keep their order."""

from __future__ import annotations

import random
from collections import deque
from functools import partial
from typing import Deque, Dict, Iterator, List, Sequence, Tuple

from rqt_mrta_py.app.live.agent_side import AgentSide
from rqt_mrta_py.app.live.hold_back import SIMULATION, HoldBack, agent_node
from rqt_mrta_py.app.live.tick_messages import TickDone, TickNews
from rqt_mrta_py.app.live.world_turns import WorldTurns
from rqt_mrta_py.app.run.hosts import HostMaker
from rqt_mrta_py.app.run.world_side import WorldSide
from rqt_mrta_py.hooks import Codec, Stamped
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission
from rqt_mrta_py.sim import PerfectLink
from rqt_mrta_py.transport import Batch, Bus, Node
from rqt_mrta_py.transport.patterns import TopicPattern, resolve_topic

WATCHER = "/supervisor"


class ScatteredTeam:
    """World, agents and a watcher, each of which knows only what has reached it."""

    def __init__(
        self,
        mission: Mission,
        duration: float,
        codec: Codec,
        manager: PluginManager,
        chance: int,
        *,
        lock_step: bool = True,
    ) -> None:
        self._codec = codec
        self._chance = random.Random(chance)
        self._world = WorldSide(mission, duration, codec, manager)
        self._turns = WorldTurns(self._world, lock_step)
        scenario = self._world.scenario
        models = manager.registered("mrta_register_robot_models")
        maker = HostMaker(
            mission, self._world.seed, scenario, {each.id: models[each.model] for each in scenario.robots}, manager
        )
        robots = self._turns.robots
        self._agents = {
            agent_node(robot): AgentSide(
                robot=robot,
                host=maker.host(robot),
                codec=codec,
                clock=self._world.clock,
                team=robots,
                resolve=partial(_resolved, node=agent_node(robot)),
            )
            for robot in robots
        }
        # Each process has a bus of its own, which counts and writes what the robot says.
        self._mouths: Dict[str, Tuple[Bus, Node]] = {}
        for name, agent in self._agents.items():
            bus = Bus(codec, PerfectLink())
            self._mouths[name] = (bus, bus.node(name, robot=agent.robot))
            bus.tap(self._hear_own)
        self._spoken: List[Stamped] = []
        self._ears = {
            **{name: [TopicPattern(topic) for topic in agent.topics] for name, agent in self._agents.items()},
            SIMULATION: [TopicPattern(topic) for topic in self._turns.command_topics],
            WATCHER: [TopicPattern("*")],
        }
        self._under_way: Dict[Tuple[str, str, str], Deque[Stamped]] = {}
        self._watcher = HoldBack(robots)

    def run(self) -> Iterator[Stamped]:
        """Give everything that was said, as the watcher puts it in order."""
        for tick in range(self._world.last_tick + 1):
            said, news = self._turns.open(tick)
            self._send(said)
            self._watcher.expect(news.manifest)
            waiting = list(self._agents)
            for agent in self._agents.values():
                agent.begin(news)
            answers: List[TickDone] = []
            while waiting or answers or self._turns.awaited:
                ready = [name for name in waiting if not self._agents[name].missing]
                if ready and self._chance.random() < 0.5:
                    name = self._chance.choice(ready)
                    waiting.remove(name)
                    answers.append(self._take_turn(name, news))
                elif answers and self._chance.random() < 0.5:
                    self._turns.answer(answers.pop(self._chance.randrange(len(answers))))
                else:
                    self._deliver_something()
            while self._watcher.missing:
                self._deliver_something()
            yield from self._heard(tick)
            self._turns.close()
            if self._turns.is_over:
                break
        self._watcher.expect(self._turns.end().manifest)
        while self._watcher.missing:
            self._deliver_something()
        yield from self._heard(tick + 1)

    def run_freely(self) -> Iterator[Stamped]:
        """Give everything that was said, if nobody waits but all that is said arrives before the next tick."""
        for tick in range(self._world.last_tick + 1):
            said, news = self._turns.open(tick)
            yield from said
            self._send(said)
            waiting = list(self._agents)
            for agent in self._agents.values():
                agent.begin(news)
            while waiting:
                ready = [name for name in waiting if not self._agents[name].missing]
                if ready and self._chance.random() < 0.3:
                    name = self._chance.choice(ready)
                    waiting.remove(name)
                    self._take_turn(name, news)
                    yield from self._spoken
                else:
                    self._deliver_something()
            while any(self._under_way.values()):
                self._deliver_something()
            self._turns.close()

    def close(self) -> None:
        self._world.close()

    def _heard(self, tick: int) -> Iterator[Stamped]:
        turn = self._watcher.take(self._world.clock.stamp_ns(tick - 1), self._world.clock.stamp_ns(tick))
        assert turn.others == ()
        yield from (*turn.agents, *turn.events, *turn.senses)

    def _take_turn(self, name: str, news: TickNews) -> TickDone:
        bus, node = self._mouths[name]
        self._spoken.clear()
        bus.publish_each([(node, self._agents[name].take_turn())], news.stamp)
        said = list(self._spoken)
        self._send(said)
        return TickDone(news.tick, self._agents[name].robot, tuple(each.connection.topic for each in said))

    def _hear_own(self, batch: Batch) -> None:
        self._spoken.extend(batch)

    def _send(self, said: Sequence[Stamped]) -> None:
        for stamped in said:
            topic, caller = stamped.connection.topic, stamped.connection.caller
            spoken_by = caller if caller in self._agents else SIMULATION
            told = Stamped(self._codec.connection(topic, stamped.connection.type, spoken_by), 0, stamped.raw)
            for hearer, patterns in self._ears.items():
                if any(pattern.match(topic) is not None for pattern in patterns):
                    self._under_way.setdefault((spoken_by, topic, hearer), deque()).append(told)

    def _deliver_something(self) -> None:
        keys = sorted(key for key, under_way in self._under_way.items() if under_way)
        if not keys:
            return
        key = self._chance.choice(keys)
        stamped = self._under_way[key].popleft()
        hearer = key[2]
        if hearer == SIMULATION:
            self._turns.hear(stamped)
        elif hearer == WATCHER:
            self._watcher.put(stamped)
        else:
            self._agents[hearer].hear(stamped)


def _resolved(topic: str, node: str) -> str:
    return resolve_topic(topic, node)
