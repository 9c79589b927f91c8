"""One architecture or application in full, as plain data; ``docs/rooms/app.md`` says what every key holds."""

from __future__ import annotations

import dataclasses
from typing import Any, Dict, Iterator, List, Optional, Sequence

from rqt_mrta_py.app.catalogue.parameter_rows import template_rows
from rqt_mrta_py.model import (
    ROBOT_TOKEN,
    TASK_TOKEN,
    ApplicationSpec,
    ArchitectureSpec,
    LaunchTemplate,
    MonitoredTopic,
    ScenarioSpec,
    Task,
)

__all__ = ["describe_application", "describe_architecture"]

_SAYS = {
    "busy_robots": "robot {} is busy now",
    "idle_robots": "robot {} is idle now",
    "incoming_tasks": "task {} has arrived",
    "allocated_tasks": "task {} is being executed",
    "completed_tasks": "task {} is done",
    "failed_tasks": "task {} has failed",
    "bids": "a robot bids for task {}",
}
"""What one message of a topic means, by the element that names the topic."""


def describe_architecture(spec: ArchitectureSpec) -> Dict[str, Any]:
    """Describe an architecture: taxonomy, topics, parameters, launch files, panels."""
    return {
        "name": spec.package,
        "title": spec.name,
        "taxonomy": str(spec.taxonomy),
        "topics": [row for meaning in _SAYS for row in _topics(meaning, getattr(spec, meaning))],
        "robot_config": spec.robot_config_id,
        "parameters": template_rows(spec.configs),
        "launches": [launch.id for launch in spec.launches],
        "panels": list(spec.widgets),
        "configs": [config.id for config in spec.configs],
        "robot_launch": spec.robot_launch_id,
        "launch_files": [_launch(launch) for launch in spec.launches],
    }


def describe_application(
    spec: ApplicationSpec, tasks: Sequence[Task], scenario: Optional[ScenarioSpec], parameters: List[Dict[str, Any]]
) -> Dict[str, Any]:
    """Describe an application.

    Args:
        spec: as registered.
        tasks: of its mission.
        scenario: what is simulated of it; None if nothing.
        parameters: rows of its parameters.
    """
    return {
        "name": spec.package,
        "title": spec.name,
        "architecture": spec.architecture,
        "robots": [{"id": robot.id, "tasks": list(robot.tasks)} for robot in spec.robots],
        "tasks": [_task(task) for task in tasks],
        "parameters": parameters,
        "scenario": None if scenario is None else _scenario(scenario),
        "launch_files": [_launch(launch) for launch in spec.launches],
    }


def _topics(meaning: str, topics: Sequence[MonitoredTopic]) -> Iterator[Dict[str, Any]]:
    for topic in topics:
        yield {
            "meaning": meaning,
            "topic": topic.name,
            "type": topic.type,
            "field": topic.field,
            "timeout": topic.timeout,
            "horizon": topic.horizon,
            "queue_size": topic.queue_size,
            "robot_field": topic.robot_field or None,
            "task_field": topic.task_field or None,
            "join": None if topic.join is None else dataclasses.asdict(topic.join),
            "when": None if topic.condition is None else dataclasses.asdict(topic.condition),
            "says": _says(meaning, topic),
        }


def _says(meaning: str, topic: MonitoredTopic) -> str:
    """Say what a message means; an id is a field's or, where there is none, a part of the topic's name."""
    robot = ROBOT_TOKEN if ROBOT_TOKEN in topic.name else ""
    task = TASK_TOKEN if TASK_TOKEN in topic.name else ""
    if meaning.endswith("_robots"):
        told_by, beside, other = topic.field or robot, "task", topic.task_field or task
    else:
        told_by, beside, other = topic.task_field or topic.field or task, "robot", topic.robot_field or robot
    of_task = f" by {topic.join.name}" if topic.join is not None else ""
    if beside == "task":
        said, other = _SAYS[meaning].format(f"<{told_by}>"), f"<{other}>{of_task}" if other else ""
    else:
        said, other = _SAYS[meaning].format(f"<{told_by}>{of_task}"), f"<{other}>" if other else ""
    said = f"{said}; {beside} {other}" if other else said
    return said if topic.condition is None else f"{said}; if <{topic.condition.field}> is {topic.condition.value}"


def _launch(launch: LaunchTemplate) -> Dict[str, Any]:
    return {
        "id": launch.id,
        "includes": [
            {
                "file": include.file,
                "arguments": [
                    {
                        "name": argument.name,
                        "value": argument.value,
                        "default": argument.default,
                        "mandatory": not argument.default,
                    }
                    for argument in include.arguments
                ],
            }
            for include in launch.includes
        ],
    }


def _task(task: Task) -> Dict[str, Any]:
    place = None if task.place is None else {"x": task.place.x, "y": task.place.y, "yaw": task.place.yaw}
    return {
        "id": task.id,
        "kind": task.kind,
        "layers": list(task.layers),
        "place": place,
        "robots": task.robots,
        "perpetual": task.perpetual,
        "expected_duration": task.expected_duration,
        "predecessors": list(task.predecessors),
        "capabilities": list(task.capabilities),
        "data": dict(task.data),
        "resources": list(task.resources),
    }


def _scenario(scenario: ScenarioSpec) -> Dict[str, Any]:
    return {
        "world": scenario.world,
        "duration": scenario.duration,
        "control_rate": scenario.control_rate,
        "robots": [
            {"id": robot.id, "model": robot.model, "sensors": [sensor.kind for sensor in robot.sensors]}
            for robot in scenario.robots
        ],
        "events": [
            {"time": event.time, "kind": event.kind.value, "robot": event.robot, "task": event.task}
            for event in scenario.events
        ],
    }
