"""The tasks.yaml and scenario.yaml of a new application."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Sequence

import yaml

from rqt_mrta_py.config.packages.layout import Layout
from rqt_mrta_py.config.tasks.task_text import dump_task
from rqt_mrta_py.model import Arena, Pose, Task

__all__ = ["scenario_text", "tasks_text"]

_SENSORS: Sequence[Mapping[str, Any]] = (
    {"kind": "localiser", "topic": "pose", "rate": 10},
    {"kind": "odometry", "topic": "odom", "rate": 10},
    {"kind": "range_finder", "topic": "scan", "rate": 10, "rays": 36, "fov": 6.283185307179586, "max_range": 4.0},
)
"""What behaviours hear of a robot's surroundings: where it is, and what is near."""


def tasks_text(tasks: Sequence[Task]) -> str:
    """Write a tasks.yaml."""
    lines = ["# What there is to do, for simulation and hardware alike.", "tasks:"]
    for task in tasks:
        first, *rest = dump_task(task).splitlines()
        lines += [f"  - {first}", *(f"    {line}" for line in rest)]
    return "\n".join([*lines, ""])


def scenario_text(robots: Sequence[str], layout: Layout, world: str, duration: float) -> str:
    """Write a scenario.yaml.

    Args:
        robots: their ids.
        layout: floor and start poses, in the robots' order.
        world: name of the world.
        duration: of the mission [s].
    """
    arena = layout.arena
    lines = [
        f"# {arena.max_x - arena.min_x:g} m x {arena.max_y - arena.min_y:g} m of floor.",
        f"world: {_flow(world)}",
        f"duration: {_flow(duration)}",
        f"arena: {_flow(_arena(arena))}",
        "robot_defaults:",
        "  model: diff_drive",
        "  sensors:",
        *(f"    - {_flow(sensor)}" for sensor in _SENSORS),
        "robots:",
        *(f"  - {_flow({'id': robot, 'start': _pose(pose)})}" for robot, pose in zip(robots, layout.starts)),
    ]
    return "\n".join([*lines, ""])


def _arena(arena: Arena) -> Dict[str, float]:
    floor = {name: float(getattr(arena, name)) for name in ("min_x", "min_y", "max_x", "max_y")}
    return {**floor, "wall_height": float(arena.wall_height)}


def _pose(pose: Pose) -> Dict[str, float]:
    return {"x": float(pose.x), "y": float(pose.y), "yaw": float(pose.yaw)}


def _flow(value: Any) -> str:
    text = yaml.safe_dump(value, default_flow_style=True, sort_keys=False, width=1_000_000)
    return text.partition("\n...")[0].strip()
