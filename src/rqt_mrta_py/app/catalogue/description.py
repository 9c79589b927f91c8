"""One registered architecture or application in full, as plain data."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple

from rqt_mrta_py.model import (
    ApplicationSpec,
    ArchitectureSpec,
    ArrayTemplate,
    ConfigTemplate,
    MapTemplate,
    MonitoredTopic,
    ParameterTemplate,
    ScenarioSpec,
    Task,
    TemplateItem,
)

__all__ = ["describe_application", "describe_architecture"]

_MEANINGS = ("busy_robots", "idle_robots", "incoming_tasks", "allocated_tasks", "completed_tasks", "failed_tasks")


def describe_architecture(spec: ArchitectureSpec) -> Dict[str, Any]:
    """Describe an architecture: taxonomy, topics, parameters with types, defaults and tool tips, panels."""
    return {
        "name": spec.package,
        "title": spec.name,
        "taxonomy": str(spec.taxonomy),
        "topics": [row for meaning in _MEANINGS for row in _topics(meaning, getattr(spec, meaning))],
        "robot_config": spec.robot_config_id,
        "parameters": [row for config in spec.configs for row in _parameters(config)],
        "launches": [launch.id for launch in spec.launches],
        "panels": list(spec.widgets),
    }


def describe_application(
    spec: ApplicationSpec, tasks: Sequence[Task], scenario: Optional[ScenarioSpec]
) -> Dict[str, Any]:
    """Describe an application: its team, its tasks, the parameters that it sets, what is simulated of it."""
    return {
        "name": spec.package,
        "title": spec.name,
        "architecture": spec.architecture,
        "robots": [{"id": robot.id, "tasks": list(robot.tasks)} for robot in spec.robots],
        "tasks": [_task(task) for task in tasks],
        "parameters": [row for config in spec.configs for row in _parameters(config)],
        "scenario": None if scenario is None else _scenario(scenario),
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
        }


def _parameters(config: ConfigTemplate) -> List[Dict[str, Any]]:
    return [
        {
            "config": config.id,
            "path": path,
            "type": item.type.value,
            "value": item.value,
            "default": item.default,
            "tool_tip": item.tool_tip,
        }
        for path, item in _leaves(config.items, "")
    ]


def _leaves(items: Sequence[TemplateItem], above: str) -> Iterator[Tuple[str, ParameterTemplate]]:
    for item in items:
        path = f"{above}/{item.name}" if above else item.name
        if isinstance(item, (MapTemplate, ArrayTemplate)):
            yield from _leaves(item.items, path)
        else:
            yield path, item


def _task(task: Task) -> Dict[str, Any]:
    place = None if task.place is None else {"x": task.place.x, "y": task.place.y, "yaw": task.place.yaw}
    return {
        "id": task.id,
        "kind": task.kind,
        "place": place,
        "robots": task.robots,
        "perpetual": task.perpetual,
        "expected_duration": task.expected_duration,
        "predecessors": list(task.predecessors),
        "capabilities": list(task.capabilities),
        "data": dict(task.data),
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
