"""From lines of the simulation to places in a scenario.yaml."""

from __future__ import annotations

import pytest

from rqt_mrta_py.app.doctor.scenario_places import located
from rqt_mrta_py.config.yaml.lines import YamlLines

SCENARIO = YamlLines(
    """world: planar
arena: {min_x: 0}
obstacles:
  - {id: crate}
  - {id: /shelf}
bodies:
  - {id: can}
  - {id: /tin}
dispensers:
  - {id: sw3}
  - {id: /se1, stock: 0}
robot_defaults:
  model: cart
  sensors: [{kind: gps, topic: pose}, {kind: sonar, topic: scan}]
robots:
  - {id: /r1, start: {x: 1}}
  - {id: r2, start: {x: 2}, model: boat, sensors: [{kind: sonar, topic: scan}]}
radio: {kind: lossy}
events:
  - {time: 9, kind: radio_changes, parameters: {kind: tin}}
  - {time: 4.5, kind: radio_changes, parameters: {kind: lossy, range: 0}}
  - {time: 4.5, kind: robot_stops, robot: r1}
"""
)


@pytest.mark.parametrize(
    ("line", "element", "message"),
    [
        ("scenario: no world 'flat'; there is none", "world", "no world 'flat'; there is none"),
        ("arena: must be", "arena", "must be"),
        ("obstacle shelf: size", "obstacles[1]", "size"),
        ("body tin: place (0, 0, 0) reaches", "bodies[1]", "place (0, 0, 0) reaches"),
        ("body can: the id is taken", "bodies[0]/id", "the id is taken"),
        ("body can: world planar lacks bodies; x", "bodies[0]", "world planar lacks bodies; x"),
        ("dispenser se1: place (0, 0, 0) reaches", "dispensers[1]", "place (0, 0, 0) reaches"),
        ("dispenser sw3: the id is taken", "dispensers[0]/id", "the id is taken"),
        ("dispenser se1: stock must be", "dispensers[1]/stock", "stock must be"),
        ("robot r1: no robot model 'cart'; x", "robot_defaults/model", "no robot model 'cart'; x"),
        ("robot r2: no robot model 'boat'; x", "robots[1]/model", "no robot model 'boat'; x"),
        ("robot r1: no sensor 'sonar' for scan; x", "robot_defaults/sensors[1]", "no sensor 'sonar' for scan; x"),
        ("robot r2: no sensor 'sonar' for scan; x", "robots[1]/sensors[0]", "no sensor 'sonar' for scan; x"),
        ("robot r1: sensor gps on pose: parameter noise: too much", "robot_defaults/sensors[0]/noise", "too much"),
        ("robot r2: sensor sonar on scan: rate 7 Hz", "robots[1]/sensors[0]", "rate 7 Hz"),
        ("team sensor gps on pose: rays", "robot_defaults/sensors[0]", "rays"),
        ("robot r2: world planar lacks drive:swim; x", "robots[1]/model", "world planar lacks drive:swim; x"),
        ("robot r1: start pose (1, 0, 0) overlaps", "robots[0]/start", "start pose (1, 0, 0) overlaps"),
        ("robot r1: the id is taken", "robots[0]/id", "the id is taken"),
        ("radio lossy: range: must be", "radio/range", "must be"),
        ("radio lossy: cannot work", "radio", "cannot work"),
        ("event radio_changes at 9 s: no radio 'tin'; x", "events[0]/parameters/kind", "no radio 'tin'; x"),
        ("event radio_changes at 4.5 s: range: must be", "events[1]/parameters/range", "must be"),
        ("event robot_stops at 4.5 s: world planar lacks freeze", "events[2]", "world planar lacks freeze"),
        ("world burrow: capabilities answered 3", "", "world burrow: capabilities answered 3"),
    ],
)
def test_lines_of_the_simulation_are_found_in_the_file(line: str, element: str, message: str) -> None:
    assert located(line, SCENARIO) == (element, message)
