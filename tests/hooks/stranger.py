"""A stranger's plugin: one small thing for every hook, each of which leaves a trace that only it can leave."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from dataclasses import replace
from typing import Any, BinaryIO, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import (
    AgentSetup,
    AllocationProblem,
    AllocationSign,
    AllocationStarted,
    AssemblyOutcome,
    AssemblyPlanner,
    AssemblyRequest,
    BehaviourSetup,
    BehaviourStep,
    Benchmark,
    BenchmarkTable,
    BlockPlacement,
    Chart,
    Command,
    Curve,
    CurveGroup,
    CurvePanel,
    Decision,
    ExporterSetup,
    Fact,
    Figure,
    FigureSetup,
    GroundsSetup,
    Heard,
    IncidentBoard,
    InterpreterSetup,
    Laboratory,
    Line,
    LinkSetup,
    MadeMission,
    MeasureSetup,
    MissionMaker,
    MissionRequest,
    MissionSetting,
    MonitorView,
    Outgoing,
    PanelSetup,
    ParameterProblem,
    Perception,
    PlannerSetup,
    RobotSensor,
    RobotSensorSetup,
    RuleSetup,
    SensorContext,
    SensorMoment,
    SensorReading,
    Situation,
    Stamped,
    Subscription,
    TeamMoment,
    TeamOutgoing,
    Verb,
    VerbTools,
    hookimpl,
)
from rqt_mrta_py.model import (
    Event,
    Ground,
    Mission,
    MissionRecord,
    Outcome,
    Pose,
    Severity,
    Task,
    Twist,
)
from tests.hooks.garden import CLAIM, MILEAGE, MOLE
from tests.sim.doubles import StillWorld


class Agent:
    """Claims what its allocator gives it, says what it would cost, and gives up at 2 s of the stream's clock.

    The second mole only repeats the claims that it hears.
    """

    rate = 10.0

    def __init__(self, setup: AgentSetup) -> None:
        self.robot_id = setup.robot_id
        self.tasks = setup.tasks
        self.evaluators = {task.id: setup.evaluators["stranger/after_a_while"](task) for task in setup.tasks}
        self.allocator = setup.allocators["stranger/first_come"]
        self.sensor: RobotSensor = setup.sensors["stranger/whiskers"](
            RobotSensorSetup(setup.robot_id, "mileage", timeout=0.5, horizon=1.0)
        )

    def subscriptions(self) -> Sequence[Subscription]:
        if self.robot_id == "mole1":
            return [self.sensor.subscription()]
        return [Subscription("/mole1/claim/dig", "std_msgs/String", ("data",))]

    def step(self, situation: Situation) -> Decision:
        if self.robot_id != "mole1":
            return Decision(None, [Outgoing("echo", "std_msgs/String", heard.fields) for heard in situation.heard])
        for heard in situation.heard:
            self.sensor.hear(heard)
        if situation.now >= 2.0:
            return Decision(None, [Outgoing("farewell/dig", "std_msgs/String", {"data": "too hard"})])
        readings = [self.sensor.read(situation.now)]
        if not (situation.applicable["dig"] and self.evaluators["dig"].is_applicable(situation.now, readings)):
            return Decision(None)
        costs = np.array([[situation.cost(task.id) for task in self.tasks]], dtype=np.float64)
        ((task_id, _),) = self.allocator(AllocationProblem((self.robot_id,), self.tasks, costs))
        claim = {"data": f"{situation.cost(task_id)} m"}
        return Decision(task_id, [Outgoing(f"claim/{task_id}", "std_msgs/String", claim)])


class AfterAWhile:
    def __init__(self, task: Task) -> None:
        self.task = task

    def is_applicable(self, now: float, sensors: Sequence[SensorReading]) -> bool:
        return now >= 1.3 and sensors[0].up_to_date


class Whiskers:
    """Up to date once they have felt something six times."""

    def __init__(self, setup: RobotSensorSetup) -> None:
        self.topic = setup.topic
        self.felt: List[Heard] = []

    def subscription(self) -> Subscription:
        return Subscription(self.topic, "std_msgs/Float64", ("data",))

    def hear(self, heard: Heard) -> None:
        self.felt.append(heard)

    def read(self, now: float) -> SensorReading:
        return SensorReading(self.topic, len(self.felt) >= 6, self.felt[-1] if self.felt else None)


class Tunnels:
    """Knows that a tunnel is twice as long as the way above it."""

    def __init__(self, setup: PlannerSetup) -> None:
        self.goal = Pose(0.0, 0.0)

    def path(self, start: Pose, goal: Pose) -> Optional[Sequence[Pose]]:
        return (goal,)

    def cost_field(self, goal: Pose) -> Tunnels:
        return self

    def at(self, place: Pose) -> Optional[float]:
        return 2.0 * abs(place.x)

    def observe(self, obstacles: Sequence[Any]) -> None:
        pass


class Earth:
    """Lets nothing through for a while."""

    def __init__(self, setup: LinkSetup) -> None:
        self.until = 1.0 + setup.parameters["delay"]

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        return [0.0] if now >= self.until else []


class Digging:
    def __init__(self, setup: BehaviourSetup) -> None:
        self.model = setup.model
        self.way = setup.navigator.cost_field(Pose(0.0, 0.0))

    def subscriptions(self) -> Sequence[Subscription]:
        return [MILEAGE]

    def applicable(self, task: Task, perception: Perception) -> bool:
        return perception.newest("mileage") is not None

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        heard = perception.newest("mileage")
        return None if heard is None else self.way.at(Pose(heard.fields["data"], 0.0))

    def start(self, task: Task, perception: Perception) -> None:
        pass

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        return BehaviourStep([Command("base", Twist(vx=self.model.max_speed))])


class Odometer:
    def __init__(self, context: SensorContext) -> None:
        self.topic = context.setup.topic

    rays = None

    def sense(self, moment: SensorMoment) -> Sequence[Outgoing]:
        return [Outgoing(self.topic, "std_msgs/Float64", {"data": moment.truth.x})]


class Noses:
    """Each mole smells how many moles smell with it."""

    rays = None

    def __init__(self, contexts: Sequence[SensorContext]) -> None:
        self.topic = contexts[0].setup.topic
        self.robots = [context.robot_id for context in contexts]

    def sense(self, moment: TeamMoment) -> Sequence[TeamOutgoing]:
        robots = tuple(self.robots[member] for member in moment.members)
        moles = {"data": np.full(len(robots), float(len(robots)))}
        return [TeamOutgoing(self.topic, "std_msgs/Float64", robots, moles)]


class Farewells:
    def __init__(self, setup: InterpreterSetup) -> None:
        self.known = (setup.robots, setup.tasks)

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription("/@robot_id@/farewell/@task_id@", "std_msgs/String", ("data",))]

    def hear(self, heard: Heard) -> Sequence[AllocationSign]:
        return [AllocationSign(heard.robot, heard.task, Outcome.GAVE_UP, heard.fields["data"])]


class AnyAllocation:
    def __init__(self, setup: RuleSetup) -> None:
        self.name = setup.mission.application.name
        self.causes = f"moles that dig for {setup.pace.brief:g} s or longer"

    def subscriptions(self) -> Sequence[Subscription]:
        return ()

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        pass

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        if isinstance(fact, AllocationStarted):
            board.open(fact.task, Severity.INFO, fact.time, f"somebody works in {self.name}", robots=[fact.robot])

    def wake(self, time: float, board: IncidentBoard) -> None:
        pass

    def finish(self, time: float, board: IncidentBoard) -> None:
        pass


class MileagePanel:
    def __init__(self, setup: PanelSetup) -> None:
        self.points: List[Heard] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription("/@robot_id@/mileage", "std_msgs/Float64", ("data",))]

    def hear(self, heard: Heard) -> None:
        self.points.append(heard)

    def view(self, start: float, end: float) -> CurvePanel:
        shown = [heard for heard in self.points if start <= heard.receipt <= end]
        times, values = tuple(heard.receipt for heard in shown), tuple(heard.fields["data"] for heard in shown)
        return CurvePanel("Mileage", "m", 3.0, None, (CurveGroup("mole1", (Curve("mileage", times, values),)),))


class Ledger:
    """Writes down who did what, and how far it was said to be."""

    def __init__(self, setup: ExporterSetup) -> None:
        self.lines: List[str] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription(CLAIM.name, CLAIM.type, ("data",))]

    def hear(self, heard: Heard) -> None:
        self.lines = [f"{heard.robot} {heard.task} {heard.fields['data']}"]

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        return {"ledger.txt": "\n".join([*self.lines, f"{len(record.allocations)} in all"]).encode("utf-8")}


class Transcript:
    """Writes down on how many topics how much was said, as it was recorded."""

    def __init__(self, setup: ExporterSetup) -> None:
        self.sizes: Dict[str, int] = {}

    def begin(self, record: MissionRecord, create: Callable[[str], BinaryIO]) -> None:
        self.file = create("transcript.txt")
        self.file.write(f"{len(record.allocations)} in all\n".encode())

    def take(self, stamped: Stamped) -> None:
        topic = stamped.connection.topic
        self.sizes[topic] = self.sizes.get(topic, 0) + len(stamped.raw)

    def end(self) -> None:
        for topic in sorted(self.sizes):
            self.file.write(f"{topic} {self.sizes[topic]}\n".encode())


class Chronicle:
    """Draws how far the mole had gone when."""

    def __init__(self, setup: FigureSetup) -> None:
        self.title = setup.mission.application.name
        self.points: List[Tuple[float, float]] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription("/@robot_id@/mileage", "std_msgs/Float64", ("data",))]

    def hear(self, heard: Heard) -> None:
        self.points.append((heard.receipt, heard.fields["data"]))

    def figures(self, record: MissionRecord) -> Sequence[Figure]:
        times, values = zip(*self.points)
        return [Figure("mileage", self.title, "t [s]", (Chart((Line("mole1", times, values),), "mileage [m]"),))]


class DearestClaim:
    """What the dearest claim was, of how many, and how many were allocated."""

    def __init__(self, setup: MeasureSetup) -> None:
        self.name = setup.mission.application.name
        self.claims: List[str] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription(CLAIM.name, CLAIM.type, ("data",))]

    def hear(self, heard: Heard) -> None:
        self.claims.append(f"{heard.robot} {heard.fields['data']}")

    def value(self, record: MissionRecord) -> Any:
        return {self.name: max(self.claims), "of": len(self.claims), "allocated": len(record.allocations)}


class Reasons:
    """Says what a claim is for, once."""

    def __init__(self, setup: GroundsSetup) -> None:
        self.place = setup.mission.application.name
        self.told = False

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription(CLAIM.name, CLAIM.type, ("data",))]

    def hear(self, heard: Heard) -> Sequence[Ground]:
        if self.told:
            return ()
        self.told = True
        cost = heard.fields["data"]
        return [Ground(heard.receipt, heard.task, f"{cost} away in {self.place}", heard.robot, {"cost": cost})]


class Neighbour:
    """Overhears the mileage."""

    def __init__(self, overheard: List[Heard]) -> None:
        self.overheard = overheard

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription("/@robot_id@/mileage", "std_msgs/Float64", ("data",))]

    def hear(self, heard: Heard) -> None:
        self.overheard.append(heard)


def first_come(problem: AllocationProblem) -> Sequence[Tuple[str, str]]:
    return [(task.id, robot) for task, robot in zip(problem.tasks, problem.robots)]


def _depth(parser: ArgumentParser) -> None:
    parser.add_argument("--depth", type=float, default=1.0)


def _dig(options: Namespace, tools: VerbTools) -> int:
    """Dig, and say who plans what is built on top."""
    planners = tools.registered("mrta_register_assembly_planners")
    sys.stdout.write(f"dug {options.depth} m below what {', '.join(planners)} plans\n")
    return 1


class Stranger:
    """The plugin; keeps what its observers, world, allocator and renderer got to see."""

    def __init__(self) -> None:
        self.world = StillWorld()
        self.views: List[MonitorView] = []
        self.problems: List[AllocationProblem] = []
        self.overheard: List[Heard] = []
        self.missions: List[Mission] = []
        self.events: List[Event] = []
        self.records: List[MissionRecord] = []

    @hookimpl
    def mrta_register_agents(self) -> Mapping[str, Any]:
        return {"stranger": Agent}

    @hookimpl
    def mrta_register_allocation_interpreters(self) -> Mapping[str, Any]:
        return {"stranger": Farewells}

    @hookimpl
    def mrta_register_allocation_paces(self) -> Mapping[str, Any]:
        return {"stranger": lambda mission, usual: replace(usual, brief=1.0 + len(mission.tasks))}

    @hookimpl
    def mrta_register_behaviours(self) -> Mapping[str, Any]:
        return {"digging": Digging}

    @hookimpl
    def mrta_register_sensory_evaluators(self) -> Mapping[str, Any]:
        return {"stranger/after_a_while": AfterAWhile}

    @hookimpl
    def mrta_register_robot_sensors(self) -> Mapping[str, Any]:
        return {"stranger/whiskers": Whiskers}

    @hookimpl
    def mrta_register_allocators(self) -> Mapping[str, Any]:
        def allocate(problem: AllocationProblem) -> Sequence[Tuple[str, str]]:
            self.problems.append(problem)
            return first_come(problem)

        return {"stranger/first_come": allocate}

    @hookimpl
    def mrta_register_links(self) -> Mapping[str, Any]:
        return {"earth": Earth}

    @hookimpl
    def mrta_register_exporters(self) -> Mapping[str, Any]:
        return {"ledger": Ledger, "transcript": Transcript}

    @hookimpl
    def mrta_register_figures(self) -> Mapping[str, Any]:
        return {"chronicle": Chronicle}

    @hookimpl
    def mrta_register_grounds_readers(self) -> Mapping[str, Any]:
        return {"stranger": Reasons}

    @hookimpl
    def mrta_register_message_observers(self) -> Mapping[str, Any]:
        return {"neighbour": lambda setup: Neighbour(self.overheard)}

    @hookimpl
    def mrta_register_assembly_planners(self) -> Mapping[str, Any]:
        def plan(request: AssemblyRequest) -> AssemblyOutcome:
            heights = enumerate(request.structure.heights, 1)
            cells = [(x, y, z + 1) for y, row in heights for x, each in enumerate(row, 1) for z in range(each)]
            return AssemblyOutcome(tuple(BlockPlacement(*cell, 1) for cell in cells))

        return {"molehill": AssemblyPlanner("crumb by crumb", plan, {})}

    @hookimpl
    def mrta_register_mission_makers(self) -> Mapping[str, Any]:
        def make(request: MissionRequest) -> MadeMission:
            return MadeMission(
                request.tasks_yaml.replace("distance: 0.6", f"distance: {request.settings['distance']}"),
                request.scenario_yaml.replace("duration: 180", f"duration: {len(request.team)}"),
            )

        setting = MissionSetting("distance", "of the protected border from walls [m]", "0.6")
        return {"border_patrol": MissionMaker((setting,), make, robots=3)}

    @hookimpl
    def mrta_register_verbs(self) -> Mapping[str, Any]:
        return {"dig-deeper": Verb("Dig on.", _depth, _dig)}

    @hookimpl
    def mrta_register_benchmarks(self) -> Mapping[str, Any]:
        def measure(options: Namespace, laboratory: Laboratory) -> BenchmarkTable:
            return BenchmarkTable("Holes", ("depth [m]",), ((options.depth,),))

        return {"holes": Benchmark("holes dug", _depth, measure)}

    @hookimpl
    def mrta_register_planners(self) -> Mapping[str, Any]:
        return {"tunnels": Tunnels}

    @hookimpl
    def mrta_register_worlds(self) -> Mapping[str, Any]:
        return {"burrow": lambda: self.world}

    @hookimpl
    def mrta_register_robot_models(self) -> Mapping[str, Any]:
        return {"mole": MOLE}

    @hookimpl
    def mrta_register_sensors(self) -> Mapping[str, Any]:
        return {"odometer": Odometer}

    @hookimpl
    def mrta_register_team_sensors(self) -> Mapping[str, Any]:
        return {"nose": Noses}

    @hookimpl
    def mrta_register_incident_rules(self) -> Mapping[str, Any]:
        return {"any_allocation": AnyAllocation}

    @hookimpl
    def mrta_register_statistics(self) -> Mapping[str, Any]:
        return {"gave_up": lambda record: sum(each.outcome is Outcome.GAVE_UP for each in record.allocations)}

    @hookimpl
    def mrta_register_measures(self) -> Mapping[str, Any]:
        return {"dearest_claim": DearestClaim}

    @hookimpl
    def mrta_register_monitor_panels(self) -> Mapping[str, Any]:
        return {"stranger/mileage": MileagePanel}

    @hookimpl
    def mrta_register_renderers(self) -> Mapping[str, Any]:
        def monitor(view: MonitorView) -> Any:
            self.views.append(view)
            return np.full((8, 16, 3), 200, dtype=np.uint8)

        return {"monitor": monitor}

    @hookimpl
    def mrta_check_parameters(
        self, architecture: str, robot_id: str, parameters: Mapping[str, Any], tasks: Sequence[Task]
    ) -> Sequence[ParameterProblem]:
        if architecture != "mrta_alliance" or robot_id != "robot2":
            return ()
        text = f"{parameters['spin_rate']} Hz is too much for {len(tasks)} tasks"
        return [ParameterProblem("spin_rate", text)]

    @hookimpl
    def mrta_on_mission_start(self, mission: Mission) -> None:
        self.missions.append(mission)

    @hookimpl
    def mrta_on_event(self, event: Event) -> None:
        self.events.append(event)

    @hookimpl
    def mrta_on_mission_end(self, record: MissionRecord) -> None:
        self.records.append(record)
