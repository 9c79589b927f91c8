"""The contract between host and plugins: what a plugin may import besides ``model``.

* ``specs``: every hook; ``hookimpl`` marks an implementation
* ``manager``: calls plugins in a defined order; ``loading`` imports them, ``contract`` and ``answers`` check them,
  ``patience`` interrupts them, ``trace`` writes their calls down; ``survey`` reads what they implement unimported
* ``stream``: messages, subscriptions, the codec's Protocol
* ``agent``, ``allocator``, ``behaviour``, ``evaluator``, ``navigator``, ``robot_sensor``: on the robot
* ``world``, ``robot_model``, ``robot_arm``, ``sensor``, ``link``: in simulation
* ``allocation``, ``pace``, ``incident``, ``oddity``, ``statistic``, ``measure``: in supervision; ``grounds``: why
* ``picture``, ``figure``, ``drawing``: in pictures; ``curve_trace`` collects what a panel will show
* ``parameters``: read and checked
* ``exporter``, ``observer``: what else hears a mission
* ``construction``: structures of blocks, and who plans them; ``mission_maker``: missions made of what users set
* ``verb``, ``benchmark``, ``laboratory``: on the command line
* ``task_orders``: what operators say of tasks

Errors that a plugin may raise to be told in one line stand here too.
"""

from __future__ import annotations

from rqt_mrta_py.errors import MissingDependencyError, MrtaError, SimError, UsageError
from rqt_mrta_py.hooks.agent import Agent, AgentFactory, AgentSetup, Decision, Situation, TaskReport
from rqt_mrta_py.hooks.allocation import (
    AllocationInterpreter,
    AllocationInterpreterFactory,
    AllocationSign,
    Applicability,
    InterpreterSetup,
)
from rqt_mrta_py.hooks.allocator import AllocationProblem, Allocator
from rqt_mrta_py.hooks.behaviour import (
    Behaviour,
    BehaviourFactory,
    BehaviourSetup,
    BehaviourStep,
    Command,
    Perception,
)
from rqt_mrta_py.hooks.benchmark import Benchmark, BenchmarkReport, BenchmarkTable
from rqt_mrta_py.hooks.construction import (
    AssemblyOutcome,
    AssemblyPlanner,
    AssemblyRequest,
    BlockPlacement,
    Structure,
    Voxel,
)
from rqt_mrta_py.hooks.curve_trace import CurveTrace, TeamTraces, nice_top
from rqt_mrta_py.hooks.drawing import Area, Drawing, DrawingPanel, Shape, Stroke, Tint, Words
from rqt_mrta_py.hooks.evaluator import SensorReading, SensoryEvaluator, SensoryEvaluatorFactory
from rqt_mrta_py.hooks.exporter import Exporter, ExporterFactory, ExporterSetup, MessageExporter
from rqt_mrta_py.hooks.figure import (
    Chart,
    Figure,
    FigureMaker,
    FigureMakerFactory,
    FigureSetup,
    Line,
    LineStyle,
)
from rqt_mrta_py.hooks.grounds import GroundsReader, GroundsReaderFactory, GroundsSetup
from rqt_mrta_py.hooks.incident import (
    AllocationEnded,
    AllocationStarted,
    ClockOff,
    ClockRight,
    Fact,
    IncidentBoard,
    IncidentRule,
    IncidentRuleFactory,
    RobotHeard,
    RobotSilent,
    RobotStateChanged,
    RuleSetup,
    TaskStateChanged,
    TopicHeard,
    TopicSilent,
)
from rqt_mrta_py.hooks.laboratory import AgentChange, Experiment, IdleTeam, Laboratory, TeamCost, Trial
from rqt_mrta_py.hooks.link import Link, LinkFactory, LinkSetup
from rqt_mrta_py.hooks.loading import load_plugin, load_plugins
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.hooks.measure import Measure, MeasureFactory, MeasureSetup
from rqt_mrta_py.hooks.mission_maker import MadeMission, MissionMaker, MissionRequest, MissionSetting
from rqt_mrta_py.hooks.navigator import CostField, Navigator, PlannerFactory, PlannerSetup
from rqt_mrta_py.hooks.observer import MessageObserverFactory, ObserverSetup
from rqt_mrta_py.hooks.oddity import (
    AllocationExpired,
    TaskApplicability,
    TaskClaimed,
    TaskEndTold,
    UnknownRobotNamed,
    UnknownTaskNamed,
)
from rqt_mrta_py.hooks.pace import AllocationPace, AllocationPaceFactory
from rqt_mrta_py.hooks.parameters import ParameterProblem, ParameterRangeError, read_fields, wrong_parameters
from rqt_mrta_py.hooks.picture import (
    BodySight,
    Curve,
    CurveGroup,
    CurvePanel,
    MonitorPanel,
    MonitorPanelFactory,
    MonitorView,
    PanelSetup,
    Renderer,
    RobotSight,
    ScenarioLabel,
    SceneView,
)
from rqt_mrta_py.hooks.robot_arm import ArmModel
from rqt_mrta_py.hooks.robot_model import GRIP_HALF_ANGLE, RobotModel
from rqt_mrta_py.hooks.robot_sensor import RobotSensor, RobotSensorFactory, RobotSensorSetup
from rqt_mrta_py.hooks.sensor import (
    RayPattern,
    Sensor,
    SensorContext,
    SensorFactory,
    SensorMoment,
    TeamMoment,
    TeamSensor,
    TeamSensorFactory,
)
from rqt_mrta_py.hooks.specs import PROJECT, HookSpecs, hookimpl
from rqt_mrta_py.hooks.statistic import Statistic
from rqt_mrta_py.hooks.stream import (
    EVERYTHING,
    AnyOutgoing,
    Codec,
    Column,
    Connection,
    FieldReader,
    Heard,
    Listener,
    Outgoing,
    OutgoingRows,
    Page,
    Sighting,
    Stamped,
    Subscription,
    TeamHeard,
    TeamOutgoing,
)
from rqt_mrta_py.hooks.task_orders import task_order
from rqt_mrta_py.hooks.verb import Verb, VerbFolder, VerbTools
from rqt_mrta_py.hooks.world import ArmWorld, Body, BodyState, Contact, PlacedRobot, World, WorldFactory, WorldSetup

__all__ = [
    "EVERYTHING",
    "GRIP_HALF_ANGLE",
    "PROJECT",
    "Agent",
    "AgentChange",
    "AgentFactory",
    "AgentSetup",
    "AllocationEnded",
    "AllocationExpired",
    "AllocationInterpreter",
    "AllocationInterpreterFactory",
    "AllocationPace",
    "AllocationPaceFactory",
    "AllocationProblem",
    "AllocationSign",
    "AllocationStarted",
    "Allocator",
    "AnyOutgoing",
    "Applicability",
    "Area",
    "ArmModel",
    "ArmWorld",
    "AssemblyOutcome",
    "AssemblyPlanner",
    "AssemblyRequest",
    "Behaviour",
    "BehaviourFactory",
    "BehaviourSetup",
    "BehaviourStep",
    "Benchmark",
    "BenchmarkReport",
    "BenchmarkTable",
    "BlockPlacement",
    "Body",
    "BodySight",
    "BodyState",
    "Chart",
    "ClockOff",
    "ClockRight",
    "Codec",
    "Column",
    "Command",
    "Connection",
    "Contact",
    "CostField",
    "Curve",
    "CurveGroup",
    "CurvePanel",
    "CurveTrace",
    "Decision",
    "Drawing",
    "DrawingPanel",
    "Experiment",
    "Exporter",
    "ExporterFactory",
    "ExporterSetup",
    "Fact",
    "FieldReader",
    "Figure",
    "FigureMaker",
    "FigureMakerFactory",
    "FigureSetup",
    "GroundsReader",
    "GroundsReaderFactory",
    "GroundsSetup",
    "Heard",
    "HookSpecs",
    "IdleTeam",
    "IncidentBoard",
    "IncidentRule",
    "IncidentRuleFactory",
    "InterpreterSetup",
    "Laboratory",
    "Line",
    "LineStyle",
    "Link",
    "LinkFactory",
    "LinkSetup",
    "Listener",
    "MadeMission",
    "Measure",
    "MeasureFactory",
    "MeasureSetup",
    "MessageExporter",
    "MessageObserverFactory",
    "MissingDependencyError",
    "MissionMaker",
    "MissionRequest",
    "MissionSetting",
    "MonitorPanel",
    "MonitorPanelFactory",
    "MonitorView",
    "MrtaError",
    "Navigator",
    "ObserverSetup",
    "Outgoing",
    "OutgoingRows",
    "Page",
    "PanelSetup",
    "ParameterProblem",
    "ParameterRangeError",
    "Perception",
    "PlacedRobot",
    "PlannerFactory",
    "PlannerSetup",
    "PluginManager",
    "RayPattern",
    "Renderer",
    "RobotHeard",
    "RobotModel",
    "RobotSensor",
    "RobotSensorFactory",
    "RobotSensorSetup",
    "RobotSight",
    "RobotSilent",
    "RobotStateChanged",
    "RuleSetup",
    "ScenarioLabel",
    "SceneView",
    "Sensor",
    "SensorContext",
    "SensorFactory",
    "SensorMoment",
    "SensorReading",
    "SensoryEvaluator",
    "SensoryEvaluatorFactory",
    "Shape",
    "Sighting",
    "SimError",
    "Situation",
    "Stamped",
    "Statistic",
    "Stroke",
    "Structure",
    "Subscription",
    "TaskApplicability",
    "TaskClaimed",
    "TaskEndTold",
    "TaskReport",
    "TaskStateChanged",
    "TeamCost",
    "TeamHeard",
    "TeamMoment",
    "TeamOutgoing",
    "TeamSensor",
    "TeamSensorFactory",
    "TeamTraces",
    "Tint",
    "TopicHeard",
    "TopicSilent",
    "Trial",
    "UnknownRobotNamed",
    "UnknownTaskNamed",
    "UsageError",
    "Verb",
    "VerbFolder",
    "VerbTools",
    "Voxel",
    "Words",
    "World",
    "WorldFactory",
    "WorldSetup",
    "hookimpl",
    "load_plugin",
    "load_plugins",
    "nice_top",
    "read_fields",
    "task_order",
    "wrong_parameters",
]
