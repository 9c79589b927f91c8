"""World, robots and scenario events, tick by tick; the mission's loop calls it, it calls nobody."""

from __future__ import annotations

from typing import (
    TYPE_CHECKING,
    AbstractSet,
    Callable,
    Iterable,
    Iterator,
    List,
    Mapping,
    NamedTuple,
    Optional,
    Sequence,
    Set,
    Tuple,
    Union,
)

from rqt_mrta_py.config.scenario.events import event_problems
from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import (
    LinkFactory,
    Outgoing,
    PlacedRobot,
    RobotModel,
    SensorFactory,
    Subscription,
    TeamHeard,
    TeamSensorFactory,
    World,
    WorldFactory,
    WorldSetup,
)
from rqt_mrta_py.model import Pose, ScenarioEvent, ScenarioEventKind, ScenarioSpec
from rqt_mrta_py.sim.arms import Arms
from rqt_mrta_py.sim.body_labels import BodyLabels
from rqt_mrta_py.sim.body_placement import body_problems
from rqt_mrta_py.sim.dispensers import Dispensers
from rqt_mrta_py.sim.drivers import Drivers
from rqt_mrta_py.sim.faults import Faults
from rqt_mrta_py.sim.grippers import Grippers
from rqt_mrta_py.sim.magnets import Magnets
from rqt_mrta_py.sim.placement import placement_problems
from rqt_mrta_py.sim.radio import LinkRandom, PerfectLink, Radio, build_links
from rqt_mrta_py.sim.requirements import blind_sensors, missing_capabilities, missing_links, missing_names
from rqt_mrta_py.sim.scenario_events import in_order
from rqt_mrta_py.sim.schedule import first_tick_at
from rqt_mrta_py.sim.sensing import Said, Sensing
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot
from rqt_mrta_py.sim.world_answers import capabilities_of, poses_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["Ear", "Simulation"]


class Ear(NamedTuple):
    """What one kind of hardware hears.

    Attributes:
        robots: ids of those that have it, in the order of rows.
        wish: what each of them hears, in its own namespace.
        hear: to be told of it.
    """

    robots: Tuple[str, ...]
    wish: Subscription
    hear: Callable[[TeamHeard], None]


class Simulation:
    """A scenario under way.

    One tick is ``begin_tick``, ``sense``, ``act``, ``step``, in this order; what robots hear comes between ``sense``
    and ``act``, through ``ears``.

    A robot goes by its own clock: what it measures is stamped by it, and it judges by it how old a command is.

    Attributes:
        scenario: what is simulated.
        robots: by id, in the scenario's order.
        drivers: hear what the robots are commanded.
        grippers: hear what those of them are commanded that have one.
        arms, magnets: the same of those.
        sensing: their sensors.
        world: where they are; built.
        radio: between them; to be asked for each delivery.

    Args:
        scenario: what to simulate.
        models: robot models by name.
        sensors: factories of sensors of one robot by kind.
        team_sensors: factories of sensors of many robots by kind; taken where ``sensors`` has none of this kind.
        worlds: world factories by name.
        generators: one for each robot's sensors, by robot id.
        links: link factories by kind of radio; None: the perfect one alone.
        link_random: makes the generator of one sender and one receiver; None: there is no chance in the radio.

    Raises:
        SimError: something is missing, misplaced or set wrongly; one line for each problem, and nothing is built.
    """

    def __init__(
        self,
        *,
        scenario: ScenarioSpec,
        models: Mapping[str, RobotModel],
        sensors: Mapping[str, SensorFactory],
        team_sensors: Mapping[str, TeamSensorFactory],
        worlds: Mapping[str, WorldFactory],
        generators: Mapping[str, np.random.Generator],
        links: Optional[Mapping[str, LinkFactory]] = None,
        link_random: Optional[LinkRandom] = None,
    ) -> None:
        self.scenario = scenario
        if scenario.control_rate < 1:
            raise SimError(f"scenario: control_rate must be at least 1 Hz (got {scenario.control_rate!r})")
        links = {"perfect": PerfectLink.of} if links is None else links
        kinds = {**team_sensors, **sensors}
        _raise_if_any([*missing_names(scenario, models, kinds, worlds), *event_problems(scenario)])
        _raise_if_any(missing_links(scenario, links))
        placed = tuple(PlacedRobot(robot.id, models[robot.model], robot.start) for robot in scenario.robots)
        ground = (scenario.arena, scenario.obstacles, placed)
        _raise_if_any(placement_problems(*ground) or body_problems(scenario.bodies, *ground, scenario.dispensers))
        news: Set[str] = set()
        self.robots = {robot.id: SimulatedRobot(robot.id, models[robot.model], news) for robot in scenario.robots}
        self.drivers = Drivers(self.robots, news)
        self._dispensers = Dispensers(scenario, models)
        bodies = self._dispensers.bodies
        self.grippers = Grippers(self.robots, bodies, scenario.control_rate)
        self.arms = Arms(self.robots, scenario.control_rate)
        self.magnets = Magnets(self.robots, bodies, scenario.control_rate)
        self.sensing = Sensing(scenario, models, sensors, team_sensors, generators, bodies=bodies.values())
        self._body_labels = BodyLabels(bodies, scenario.control_rate)
        self._names = list(self.robots)
        self._events = in_order(scenario)
        self._next_event = 0
        self._clock_offsets: Mapping[str, float] = {}
        self._truth: Optional[NDArray[np.float64]] = None
        self._poses: Optional[Mapping[str, Pose]] = None
        built = build_links(scenario, self._events, links, self._pose, link_random or _no_chance)
        self.radio = Radio(built.first)
        self.world: World = worlds[scenario.world]()
        try:
            capabilities = capabilities_of(scenario.world, self.world)
            blind = blind_sensors(scenario, self.sensing.mounts, capabilities)
            _raise_if_any([*missing_capabilities(scenario, models, capabilities), *blind])
            self.world.reset(WorldSetup(scenario.arena, scenario.obstacles, placed, 1.0 / scenario.control_rate))
            self._dispensers.begin(self.world)
        except BaseException:
            self.world.close()
            raise
        self._faults = Faults(self.robots, self.world, self.radio, built.later)

    def begin_tick(self, tick: int, now: float) -> Sequence[ScenarioEvent]:
        """Make happen what is due by this tick; an event between two ticks happens at the later one.

        Args:
            tick: of the mission, from 0, growing.
            now: the time [s].

        Returns:
            What happened, by time, then file order.
        """
        first = self._next_event
        while self._next_event < len(self._events):
            event = self._events[self._next_event]
            if first_tick_at(event.time, self.scenario.control_rate) > tick:
                break
            self._faults.happen(event, now)
            if event.kind is ScenarioEventKind.ROBOT_REMOVED and event.robot is not None:
                self.grippers.forget(event.robot)
                self.magnets.forget(event.robot)
            self._next_event += 1
        if self._next_event > first:
            self.sensing.leave_out(self._faults.stopped)
        self._clock_offsets = self._faults.clock_offsets(now)
        self._dispensers.refill(tick, self.world, self._where_they_are, self._faults.removed)
        return self._events[first : self._next_event]

    def sense(self, tick: int, now: float) -> Iterator[Said]:
        """Let sensors measure; those of robots that are stopped do not.

        Args:
            tick: of the mission, from 0.
            now: the time [s].

        Yields:
            What drivers publish: sensors in the order of kind, topic, rate and parameters, then transforms, then what
            grippers hold, where arms are, and what magnets hold.
        """
        due = self.sensing.due(tick)
        if due:
            held = self._held()
            yield from self.sensing.sense(due, self._times(now), self._where_they_are(), self.world, held)
        yield from self.grippers.tell(tick)
        yield from self.arms.tell(tick, self.world)
        yield from self.magnets.tell(tick)

    def labels(self, tick: int, now: float) -> Iterator[Outgoing]:
        """Tell people where loose bodies are; arguments as of ``sense``."""
        return self._body_labels.due(tick, now, self.world, self._held())

    def ears(self, robots: Sequence[str]) -> List[Ear]:
        """Say what hardware hears, kind by kind: bases, then grippers, arms and magnets if there are any.

        Args:
            robots: ids, in the order that rows shall have.
        """
        ears = [Ear(tuple(robots), *self.drivers.listener(robots))]
        parts: Sequence[Union[Arms, Grippers, Magnets]] = (self.grippers, self.arms, self.magnets)
        for part in parts:
            having = tuple([robot for robot in robots if robot in part.robots])
            if having:
                ears.append(Ear(having, *part.listener(having)))
        return ears

    def act(self, now: float) -> None:
        """Command the world what robots were commanded, at a time [s]; what they do already is not said again."""
        for name, twist in self.drivers.commands(self._times(now)):
            self.world.command(name, "base", twist)
        self.arms.act(self.world)
        self.grippers.act(self.world, self._where_they_are, self.magnets.kept)
        self.magnets.act(self.world, self._where_they_are, self.grippers.kept)

    def step(self) -> None:
        """Let one tick pass in the world."""
        self.world.step()
        self._truth = self._poses = None

    def stopped(self, robot_id: str) -> bool:
        """Tell whether a robot stands still and silent; its host must be silent too."""
        return robot_id in self._faults.stopped

    @property
    def stopped_robots(self) -> AbstractSet[str]:
        """The robots that stand still and silent."""
        return self._faults.stopped

    def clock_offset(self, robot_id: str) -> float:
        """Give a robot's clock minus the true one [s], at the tick that was begun last.

        A clock that is set back never runs backwards: it runs at half speed until it shows what it should.
        """
        return self._clock_offsets.get(robot_id, 0.0)

    @property
    def clock_offsets(self) -> Mapping[str, float]:
        """As ``clock_offset``, by robot; those whose clocks were never set are left out."""
        return self._clock_offsets

    def close(self) -> None:
        """Free what the world holds; safe to call twice."""
        self.world.close()

    def _held(self) -> Mapping[str, str]:
        """Tell which robot at work holds what, by the body's id."""
        return {**self.grippers.held, **self.magnets.held} if self.magnets.robots else self.grippers.held

    def _pose(self, robot_id: str) -> Optional[Pose]:
        """Give a robot's true pose; None for anything else."""
        if self._poses is None:
            self._poses = {robot: Pose(*row) for robot, row in zip(self._names, self._where_they_are().tolist())}
        return self._poses.get(robot_id)

    def _where_they_are(self) -> NDArray[np.float64]:
        """Give every robot's true pose; the world is asked once a tick.

        Raises:
            SimError: the world answers what are no poses.
        """
        if self._truth is None:
            self._truth = poses_of(self.scenario.world, self.world, self._names)
        return self._truth

    def _times(self, now: float) -> NDArray[np.float64]:
        """Give the time on each robot's clock [s]."""
        import numpy as np

        offsets = self._clock_offsets
        return (
            np.array([now + offsets.get(name, 0.0) for name in self._names])
            if offsets
            else np.full(len(self._names), now)
        )


def _no_chance(sender: str, receiver: str) -> np.random.Generator:
    raise ValueError(f"no chance was given to the radio from {sender!r} to {receiver!r}")


def _raise_if_any(problems: Iterable[str]) -> None:
    lines = list(problems)
    if lines:
        raise SimError("\n".join(lines))
