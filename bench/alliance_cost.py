"""What ALLIANCE costs: processor time and messages of a team, by robots and behaviour sets.

No world: hosts with their agents, on the embedded bus, with behaviours that are always applicable and do nothing. Every
robot has a behaviour set for every task. Optionally a bag is written of it all. From a checkout:
``PYTHONPATH=plugins/architectures/mrta_alliance/src python -m bench.alliance_cost``.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from mrta_alliance.agent import AllianceAgent

from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.hooks import AgentSetup, AnyOutgoing, BehaviourStep, Perception, Subscription
from rqt_mrta_py.model import Task
from rqt_mrta_py.robot import HostSetup, RobotHost
from rqt_mrta_py.transport import BagWriter, Batch, Bus, Node, RosCodec

__all__ = ["AllianceCostRow", "main", "measure_alliance_cost"]

_SPIN_RATE = 10
"""Of agents, and of control [Hz]."""


class AllianceCostRow(NamedTuple):
    """What one team costs.

    Attributes:
        robots: number of them.
        sets: behaviour sets of each.
        seconds: of the mission [s].
        cpu: processor time of agents, hosts and bus, a robot and mission second [s].
        speed: mission seconds a second of processor time [1].
        messages: published, a robot and mission second; 0 where nobody counts them.
    """

    robots: int
    sets: int
    seconds: float
    cpu: float
    speed: float
    messages: float


class _Idle:
    """A behaviour that is always applicable and does nothing."""

    def subscriptions(self) -> Sequence[Subscription]:
        return ()

    def applicable(self, task: Task, perception: Perception) -> bool:
        return True

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        return None

    def start(self, task: Task, perception: Perception) -> None:
        pass

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        return BehaviourStep()


class _NoLoss:
    """A link that delivers everything at once."""

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        return (0.0,)


def measure_alliance_cost(robots: int, sets: int, seconds: float, bag: Optional[Path] = None) -> AllianceCostRow:
    """Measure one team, after a warm-up of four mission seconds in which everybody takes up a task.

    Args:
        robots: number of them.
        sets: number of tasks, each a behaviour set of each robot.
        seconds: of the mission that are measured [s].
        bag: where to write a bag; None: nobody wants what nobody hears.
    """
    with ExitStack() as stack:
        bus = Bus(RosCodec(_definition), _NoLoss())
        counted = [0]
        if bag is not None:
            writer = stack.enter_context(BagWriter(bag))

            def write(batch: Batch) -> None:
                counted[0] += len(batch)
                writer.write_batch(batch)

            bus.tap(write)
        team = _team(bus, robots, sets)
        warm = 4 * _SPIN_RATE
        for tick in range(warm):
            _step(bus, team, tick)
        stack.enter_context(rare_collections())
        begun, said = time.process_time(), counted[0]
        last = warm + round(seconds * _SPIN_RATE)
        for tick in range(warm, last):
            _step(bus, team, tick)
        cpu = time.process_time() - begun
    share = robots * seconds
    return AllianceCostRow(robots, sets, seconds, cpu / share, seconds / cpu, (counted[0] - said) / share)


def _team(bus: Bus, robots: int, sets: int) -> List[Tuple[Node, RobotHost]]:
    tasks = tuple(Task(f"task{number}", "idle", perpetual=True) for number in range(sets))
    names = tuple(f"robot{number}" for number in range(robots))
    members: List[Tuple[Node, RobotHost]] = []
    for place, name in enumerate(names):
        setup = AgentSetup(name, names, tasks, _parameters(place, tasks), np.random.default_rng(place))
        agent = AllianceAgent(setup)
        host = RobotHost(HostSetup(name, agent, {"idle": _Idle()}, tasks, _SPIN_RATE))
        node = bus.node(f"/{name}/agent", name)
        for subscription, callback in host.listeners():
            node.subscribe(subscription, callback)
        members.append((node, host))
    return members


def _parameters(place: int, tasks: Sequence[Task]) -> Dict[str, Any]:
    """Give parameters with which each robot soon takes up a task of its own, as far as there are enough."""
    sets = {
        f"behaviour_set{index}": {
            "task_id": task.id,
            "task_expected_duration": 600.0,
            "motivational_behaviour": {
                "threshold": 30.0,
                "acquiescence": {"yielding_delay": 20.0, "giving_up_delay": 300.0},
                "impatience": {"fast_rate": 3.0 if index == place % len(tasks) else 0.3},
            },
        }
        for index, task in enumerate(tasks)
    }
    rates = {"spin_rate": float(_SPIN_RATE), "broadcast_rate": 2.0, "timeout_duration": 3.0, "buffer_horizon": 10.0}
    return {**rates, "behaviour_sets": {"size": len(tasks), **sets}}


def _step(bus: Bus, team: Sequence[Tuple[Node, RobotHost]], tick: int) -> None:
    now = 1.0 + tick / _SPIN_RATE
    bus.deliver(now)

    def said() -> Iterator[Tuple[Node, Sequence[AnyOutgoing]]]:
        for node, host in team:
            yield node, host.step(tick, now)

    bus.publish_each(said(), now)


def _definition(type_name: str) -> Optional[str]:
    package, _, message = type_name.partition("/")
    root = Path(__file__).resolve().parents[1]
    folder = root / "msg" if package == "rqt_mrta_py" else root / "plugins" / "messages" / package / "msg"
    path = folder / f"{message}.msg"
    return path.read_text() if path.exists() else None


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(prog="python -m bench.alliance_cost", description=main.__doc__)
    parser.add_argument("--robots", type=int, nargs="+", default=[10, 30, 100])
    parser.add_argument("--sets", type=int, nargs="+", default=[10, 30, 100])
    parser.add_argument("--seconds", type=float, default=4.0)
    parser.add_argument("--bag", action="store_true", help="write a bag as well")
    options = parser.parse_args(arguments)
    print("robots  sets  us CPU/robot s  mission s/CPU s  messages/robot s")
    for robots in options.robots:
        for sets in options.sets:
            with tempfile.TemporaryDirectory() as folder:
                bag = Path(folder) / "mission.bag" if options.bag else None
                row = measure_alliance_cost(robots, sets, options.seconds, bag)
            print(f"{robots:6} {sets:5} {row.cpu * 1e6:15.0f} {row.speed:16.1f} {row.messages:17.1f}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
