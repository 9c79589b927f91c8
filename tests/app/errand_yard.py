"""A small application in the planar world: two robots, two errands that end, one task that does not."""

from __future__ import annotations

from pathlib import Path

__all__ = ["DURATION", "write_errand_yard"]

DURATION = 40

_FILES = {
    "package.xml": """<package format="3">
  <name>errand_yard</name> <version>0.1.0</version> <description>Errands.</description>
  <maintainer email="a@b.c">m</maintainer> <license>Apache-2.0</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export>
    <rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml" scenario="${prefix}/scenario.yaml"/>
  </export>
</package>
""",
    "rqt_mrta.xml": """<rqt_mrta format="application"><application><name>Errands</name>
  <architecture>mrta_alliance</architecture>
  <robots><robot_0><id>robot1</id></robot_0><robot_1><id>robot2</id></robot_1></robots>
</application><configs/></rqt_mrta>
""",
    "tasks.yaml": """tasks:
  - {id: north, kind: go_to_place, place: {x: 0.0, y: 1.5}}
  - {id: south, kind: go_to_place, place: {x: 0.0, y: -1.5}}
  - {id: rest, kind: wander, perpetual: true}
""",
    "scenario.yaml": f"""world: planar
duration: {DURATION}
arena: {{min_x: -2.0, min_y: -2.0, max_x: 2.0, max_y: 2.0}}
obstacles: []
robot_defaults:
  sensors:
    - {{kind: localiser, topic: pose, rate: 10}}
    - {{kind: odometry, topic: odom, rate: 10}}
    - {{kind: range_finder, topic: scan, rate: 10, rays: 36, max_range: 4.0}}
robots:
  - {{id: robot1, start: {{x: -1.0, y: 1.0}}}}
  - {{id: robot2, start: {{x: 1.0, y: -1.0}}}}
events:
  - {{time: 30, kind: robot_stops, robot: robot2}}
""",
}


def write_errand_yard(folder: Path) -> str:
    """Write the application to a folder; gives what ``mrta run`` takes for its name."""
    folder.mkdir(parents=True)
    for name, text in _FILES.items():
        (folder / name).write_text(text)
    return str(folder)
