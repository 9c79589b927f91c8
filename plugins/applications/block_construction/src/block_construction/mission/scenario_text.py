"""What is simulated of a build, as a scenario.yaml."""

from __future__ import annotations

import math
from typing import List, Sequence

from block_construction.diagram.block_set import body_size
from block_construction.mission.fetching import Ready
from block_construction.mission.numbers import listed, number
from rqt_mrta_py.model import Pose

__all__ = ["MODEL", "scenario_text"]

MODEL = "mecanum_arm"
_MASS = 0.02
"""Of a block, for each of its units [kg]."""
_FRICTION = 0.8
_CONTROL_RATE = 10
_PICTURES = 30
_LINGER = 10
_MINUTE = 60.0


def scenario_text(
    side: float, ready: Sequence[Ready], starts: Sequence[Pose], robots: Sequence[str], **of: float
) -> str:
    """Write the scenario.

    Args:
        side: of the arena [m].
        ready: where blocks lie ready.
        starts: where robots begin, one for each.
        robots: their ids.
        of: ``expected``: how long one robot is expected to build [s]; ``pose_noise``: greatest error of a robot's x and
            y [m]; ``pose_hold``: how long one such error lasts [s]; ``sight_noise``:
            standard deviation of where its detector sees blocks, in x and in y [m].
    """
    # Blocks may fall and be placed anew; whoever is done earlier only waits.
    duration = math.ceil((1.5 * of["expected"] + 300.0) / _MINUTE) * 60
    lines = [
        "world: bullet",
        f"duration: {duration}",
        f"linger: {_LINGER}",
        f"control_rate: {_CONTROL_RATE}",
        f"picture_period: {_PICTURES}",
        f"arena: {{min_x: 0.0, min_y: 0.0, max_x: {number(side)}, max_y: {number(side)}}}",
        "dispensers:",
        *map(_dispenser, ready),
        "robot_defaults:",
        f"  model: {MODEL}",
        "  sensors:",
        *_sensors(of["pose_noise"], of["pose_hold"], of["sight_noise"]),
        "robots:",
        *(
            f"  - {{id: {robot}, start: {{x: {number(start.x)}, y: {number(start.y)}, yaw: {number(start.yaw)}}}}}"
            for robot, start in zip(robots, starts)
        ),
    ]
    return "\n".join(lines) + "\n"


def _dispenser(ready: Ready) -> str:
    stock = "" if ready.stock is None else f", stock: {ready.stock}"
    size = listed(body_size(ready.units))
    return (
        f"  - {{id: {ready.name}, kind: block{ready.units}, x: {number(ready.x)}, y: {number(ready.y)}, "
        f"yaw: {number(ready.yaw)}, size: {size}, mass: {number(_MASS * ready.units)}, friction: {_FRICTION}{stock}}}"
    )


def _sensors(pose_noise: float, pose_hold: float, sight_noise: float) -> List[str]:
    """List what every robot carries: where it is, what its wheels count (table 18), blocks near it, and collisions."""
    noise = f", uniform_noise: {number(pose_noise)}" if pose_noise else ""
    if pose_noise and pose_hold:
        noise += f", uniform_hold: {number(pose_hold)}"
    return [
        f"    - {{kind: localiser, topic: pose, rate: 10, position_noise: 0.0, heading_noise: 0.0{noise}}}",
        "    - {kind: odometry, topic: odom, rate: 10}",
        "    - {kind: detector, topic: detections, rate: 2, max_range: 1.0, fov: 6.283185, "
        f"position_noise: {number(sight_noise) if sight_noise else '0.0'}, from_above: true}}",
        # A touch may be short: it is felt at every tick.
        f"    - {{kind: bumper, topic: bumper, rate: {_CONTROL_RATE}, bodies: false}}",
    ]
