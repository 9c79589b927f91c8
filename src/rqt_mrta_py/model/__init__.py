"""What things are: robots, tasks, allocations, events, incidents, and the frozen specifications (stdlib only).

* ``ids``, ``names``, ``geometry``, ``taxonomy``, ``states``: small vocabularies
* ``task``, ``application``, ``architecture``, ``parameters``, ``scenario``, ``mission``: what is asked for
* ``record``, ``communication``, ``timing``: what was observed; ``explanation``: why; ``tolerance``: how much worse
  another mission may be
"""

from __future__ import annotations

from rqt_mrta_py.model.application import ApplicationRobot, ApplicationSpec
from rqt_mrta_py.model.architecture import (
    ArchitectureSpec,
    IncludeSpec,
    LaunchArgument,
    LaunchTemplate,
    MonitoredTopic,
    TopicCondition,
    TopicJoin,
)
from rqt_mrta_py.model.communication import CommunicationGraph, Flow, TopicTraffic
from rqt_mrta_py.model.explanation import Candidate, Explanation, Ground, Spell, Whereabouts
from rqt_mrta_py.model.geometry import Pose, Twist, wrap_angle
from rqt_mrta_py.model.ids import normalise_id, wire_id
from rqt_mrta_py.model.mission import Mission, MissionTexts
from rqt_mrta_py.model.names import ROBOT_TOKEN, TASK_TOKEN, is_legal_name, resolve_name
from rqt_mrta_py.model.parameters import (
    ArrayTemplate,
    ConfigTemplate,
    MapTemplate,
    ParameterTemplate,
    ParameterType,
    TemplateItem,
)
from rqt_mrta_py.model.record import (
    Allocation,
    Event,
    Evidence,
    Incident,
    MissionRecord,
    RobotInterval,
    RobotRecord,
    TaskInterval,
    TaskRecord,
)
from rqt_mrta_py.model.scenario import (
    MAPPED_TOPICS,
    Arena,
    Dispenser,
    LooseBody,
    MapKnowledge,
    Obstacle,
    RadioSetup,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    ScenarioSpec,
    SensorSetup,
)
from rqt_mrta_py.model.states import Outcome, Progress, RobotState, Severity, TaskState
from rqt_mrta_py.model.task import Task
from rqt_mrta_py.model.taxonomy import AllocationType, RobotType, TaskType, Taxonomy
from rqt_mrta_py.model.tolerance import Tolerance, Worse

__all__ = [
    "MAPPED_TOPICS",
    "ROBOT_TOKEN",
    "TASK_TOKEN",
    "Allocation",
    "AllocationType",
    "ApplicationRobot",
    "ApplicationSpec",
    "ArchitectureSpec",
    "Arena",
    "ArrayTemplate",
    "Candidate",
    "CommunicationGraph",
    "ConfigTemplate",
    "Dispenser",
    "Event",
    "Evidence",
    "Explanation",
    "Flow",
    "Ground",
    "Incident",
    "IncludeSpec",
    "LaunchArgument",
    "LaunchTemplate",
    "LooseBody",
    "MapKnowledge",
    "MapTemplate",
    "Mission",
    "MissionRecord",
    "MissionTexts",
    "MonitoredTopic",
    "Obstacle",
    "Outcome",
    "ParameterTemplate",
    "ParameterType",
    "Pose",
    "Progress",
    "RadioSetup",
    "RobotInterval",
    "RobotRecord",
    "RobotSetup",
    "RobotState",
    "RobotType",
    "ScenarioEvent",
    "ScenarioEventKind",
    "ScenarioSpec",
    "SensorSetup",
    "Severity",
    "Spell",
    "Task",
    "TaskInterval",
    "TaskRecord",
    "TaskState",
    "TaskType",
    "Taxonomy",
    "TemplateItem",
    "Tolerance",
    "TopicCondition",
    "TopicJoin",
    "TopicTraffic",
    "Twist",
    "Whereabouts",
    "Worse",
    "is_legal_name",
    "normalise_id",
    "resolve_name",
    "wire_id",
    "wrap_angle",
]
