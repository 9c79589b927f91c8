"""A stranger's plugin: one small thing for every hook, each of which leaves a trace that only it can leave."""

from __future__ import annotations

from typing import Any, List, Mapping, Optional, Sequence

import numpy as np

from rqt_mrta_py.hooks import (
    AgentSetup,
    AllocationSign,
    AllocationStarted,
    BehaviourSetup,
    BehaviourStep,
    Command,
    Curve,
    CurveGroup,
    CurvePanel,
    Decision,
    Fact,
    Heard,
    IncidentBoard,
    InterpreterSetup,
    MonitorView,
    Outgoing,
    PanelSetup,
    ParameterProblem,
    Perception,
    PlannerSetup,
    RobotModel,
    RuleSetup,
    SensorContext,
    SensorMoment,
    SensorReading,
    Situation,
    Subscription,
    hookimpl,
)
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Arena,
    Event,
    Mission,
    MissionRecord,
    MonitoredTopic,
    Outcome,
    Pose,
    RobotSetup,
    ScenarioSpec,
    SensorSetup,
    Severity,
    Task,
    Taxonomy,
    Twist,
)
from tests.sim.doubles import StillWorld

MILEAGE = Subscription("mileage", "std_msgs/Float64", ("data",))
MOLE = RobotModel("mole", "differential", 0.4, 0.3, 0.2, 0.25, 5.0, 0.05, 0.25, 0.7, 1.0, 0.1)
CLAIM = MonitoredTopic("/@robot_id@/claim/@task_id@", "std_msgs/String", timeout=5.0)
SCENARIO = ScenarioSpec(
    arena=Arena(-3.0, -3.0, 3.0, 3.0),
    obstacles=(),
    robots=(RobotSetup("mole1", "mole", Pose(1.5, 0.0), (SensorSetup("odometer", "mileage", 10.0),)),),
    world="burrow",
    planner="tunnels",
    control_rate=10,
)
MISSION = Mission(
    application=ApplicationSpec("garden", "Garden", robots=(ApplicationRobot("mole1", ("dig",)),)),
    architecture=ArchitectureSpec(
        "stranger", "Stranger", Taxonomy.parse("ST-SR-IA"), busy_robots=(CLAIM,), widgets=("stranger/mileage",)
    ),
    tasks=(Task("dig", "digging"),),
    scenario=SCENARIO,
    seed=4,
)


class Agent:
    """Claims what its evaluator lets through, says what it would cost, and gives up at 2 s of the stream's clock."""

    rate = 10.0

    def __init__(self, setup: AgentSetup) -> None:
        self.evaluators = {task.id: setup.evaluators["stranger/after_a_while"](task) for task in setup.tasks}

    def subscriptions(self) -> Sequence[Subscription]:
        return ()

    def step(self, situation: Situation) -> Decision:
        if situation.now >= 2.0:
            return Decision(None, [Outgoing("farewell/dig", "std_msgs/String", {"data": "too hard"})])
        if not (situation.applicable["dig"] and self.evaluators["dig"].is_applicable(situation.now, ())):
            return Decision(None)
        return Decision("dig", [Outgoing("claim/dig", "std_msgs/String", {"data": f"{situation.cost('dig')} m"})])


class AfterAWhile:
    def __init__(self, task: Task) -> None:
        self.task = task

    def is_applicable(self, now: float, sensors: Sequence[SensorReading]) -> bool:
        return now >= 1.5


class Tunnels:
    """Goes straight to where a mole wants to go."""

    def __init__(self, setup: PlannerSetup) -> None:
        self.setup = setup

    def path(self, start: Pose, goal: Pose) -> Optional[Sequence[Pose]]:
        return (goal,)


class Digging:
    def __init__(self, setup: BehaviourSetup) -> None:
        self.model = setup.model

    def subscriptions(self) -> Sequence[Subscription]:
        return [MILEAGE]

    def applicable(self, task: Task, perception: Perception) -> bool:
        return perception.newest("mileage") is not None

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        heard = perception.newest("mileage")
        return None if heard is None else float(heard.fields["data"])

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


class Stranger:
    """The plugin; keeps what its observers, world and renderer got to see."""

    def __init__(self) -> None:
        self.world = StillWorld()
        self.views: List[MonitorView] = []
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
    def mrta_register_behaviours(self) -> Mapping[str, Any]:
        return {"digging": Digging}

    @hookimpl
    def mrta_register_sensory_evaluators(self) -> Mapping[str, Any]:
        return {"stranger/after_a_while": AfterAWhile}

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
    def mrta_register_incident_rules(self) -> Mapping[str, Any]:
        return {"any_allocation": AnyAllocation}

    @hookimpl
    def mrta_register_statistics(self) -> Mapping[str, Any]:
        return {"gave_up": lambda record: sum(each.outcome is Outcome.GAVE_UP for each in record.allocations)}

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
