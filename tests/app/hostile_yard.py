"""An application of any size, with whatever stands in its scenario."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Dict, List

import yaml

_MANIFEST = """<package format="3">
  <name>hostile_yard</name> <version>0.1.0</version> <description>As large, as small, as odd as one likes.</description>
  <maintainer email="a@b.c">m</maintainer> <license>Apache-2.0</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export>
    <rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml" scenario="${prefix}/scenario.yaml"/>
  </export>
</package>
"""
RANGE_FINDER = {"kind": "range_finder", "topic": "scan", "rate": 10}
_SENSORS = [
    {"kind": "localiser", "topic": "pose", "rate": 10},
    {"kind": "odometry", "topic": "odom", "rate": 10},
    {**RANGE_FINDER, "rays": 36},
]


def starts(count: int) -> List[Dict[str, Any]]:
    """Place robots in a square, a metre apart, the first at (0.5, 0.5)."""
    side = math.ceil(math.sqrt(count)) if count else 1
    return [
        {"id": f"robot{index + 1}", "start": {"x": index % side + 0.5, "y": index // side + 0.5}}
        for index in range(count)
    ]


def write_hostile_yard(folder: Path, count: int = 2, **scenario: Any) -> None:
    """Write an application of some robots that wander to a folder.

    Args:
        folder: does not exist yet.
        count: of robots.
        **scenario: keys of scenario.yaml, in place of usual ones.
    """
    side = math.ceil(math.sqrt(count)) + 1.0
    members = "".join(f"<robot_{index}><id>robot{index + 1}</id></robot_{index}>" for index in range(count))
    usual = {
        "world": "planar",
        "duration": 0.2,
        "arena": {"min_x": -1.0, "min_y": -1.0, "max_x": side, "max_y": side},
        "robot_defaults": {"sensors": _SENSORS},
        "robots": starts(count),
    }
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(_MANIFEST)
    (folder / "rqt_mrta.xml").write_text(
        '<rqt_mrta format="application"><application><name>Hostile yard</name>'
        "<architecture>mrta_alliance</architecture>"
        f"<robots>{members}</robots></application><configs/></rqt_mrta>"
    )
    (folder / "tasks.yaml").write_text("tasks: [{id: wander, kind: wander, perpetual: true}]\n")
    (folder / "scenario.yaml").write_text(yaml.safe_dump({**usual, **scenario}, sort_keys=False))
