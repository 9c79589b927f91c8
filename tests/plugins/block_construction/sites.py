"""Small applications in which robots build, with blocks that lie ready."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Dict, List, Sequence, Tuple

import yaml

__all__ = ["ARENA", "block_at", "block_body", "write_site"]

ARENA = 2.2
SITE = [0.86, 0.78, 1.34, 1.42]

_PACKAGE = """<package format="3">
  <name>small_site</name> <version>0.1.0</version> <description>Builds.</description>
  <maintainer email="a@b.c">m</maintainer> <license>Apache-2.0</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export>
    <rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml" scenario="${prefix}/scenario.yaml"/>
  </export>
</package>
"""
_ROBOT = "<robot_{0}><id>robot{1}</id></robot_{0}>"
_APPLICATION = """<rqt_mrta format="application"><application><name>Site</name>
  <architecture>nearest_robot</architecture> <robots>{robots}</robots>
</application><configs/></rqt_mrta>
"""


def block_body(name: str, units: int, x: float, y: float, heading: float) -> Dict[str, Any]:
    """Lay a block down so that a robot of some heading [rad] can fetch it at x, y [m]."""
    size = [0.06 * units, 0.07, 0.07]
    yaw = heading - math.pi / 2
    return {"id": name, "kind": f"block{units}", "x": x, "y": y, "yaw": yaw, "size": size, "mass": 0.02 * units}


def block_at(
    number: int,
    units: int,
    level: int,
    place: Tuple[float, float],
    *,
    heading: float,
    cells: Sequence[Tuple[int, int]],
    supply: Sequence[Sequence[float]],
) -> Dict[str, Any]:
    """Write the task of placing a block; the one before it must be done before."""
    x, y = place
    data = {
        "block": number,
        "units": units,
        "level": level,
        "x": x,
        "y": y,
        "yaw": 0.0 if abs(math.sin(heading)) > 0.5 else math.pi / 2,
        "heading": heading,
        "cells": [list(cell) for cell in cells],
        "supply": [list(place) for place in supply],
        "site": SITE,
        "arena": ARENA,
    }
    return {
        "id": f"block{number}",
        "kind": "place_block",
        "place": {"x": x - 0.55 * math.cos(heading), "y": y - 0.55 * math.sin(heading), "yaw": heading},
        "capabilities": ["magnet"],
        "predecessors": [f"block{number - 1}"] if number > 1 else [],
        "data": data,
    }


def write_site(
    folder: Path,
    bodies: List[Dict[str, Any]],
    tasks: List[Dict[str, Any]],
    *,
    starts: Sequence[Tuple[float, float, float]] = ((1.1, 0.3, math.pi / 2),),
    noise: float = 0.0,
    duration: float = 900.0,
    **scenario: Any,
) -> str:
    """Write the application to a folder; gives what ``mrta run`` takes for its name."""
    folder.mkdir(parents=True)
    eyes = {"from_above": True, "max_range": 2.5, "position_noise": 0.0}
    sensors = [
        {"kind": "localiser", "topic": "pose", "rate": 10, "position_noise": noise, "heading_noise": 0.0},
        {"kind": "detector", "topic": "detections", "rate": 2, **eyes},
    ]
    robots = [
        {"id": f"robot{number}", "model": "mecanum_arm", "start": dict(zip(("x", "y", "yaw"), start))}
        for number, start in enumerate(starts, 1)
    ]
    whole = {
        "world": "bullet",
        "duration": duration,
        "control_rate": 10,
        "obstacles": [],
        "arena": {"min_x": 0.0, "min_y": 0.0, "max_x": ARENA, "max_y": ARENA},
        "bodies": bodies,
        "robot_defaults": {"sensors": sensors},
        "robots": robots,
        **scenario,
    }
    named = "".join(_ROBOT.format(number, number + 1) for number in range(len(starts)))
    (folder / "package.xml").write_text(_PACKAGE)
    (folder / "rqt_mrta.xml").write_text(_APPLICATION.format(robots=named))
    (folder / "tasks.yaml").write_text(yaml.safe_dump({"tasks": tasks}))
    (folder / "scenario.yaml").write_text(yaml.safe_dump(whole))
    return str(folder)
