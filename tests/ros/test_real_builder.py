"""A builder whose base, arm, magnet and localisation are nodes of somebody else, as of a real robot."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Dict, Iterator, List, NamedTuple

import pytest

from tests.plugins.block_construction.sites import block_at, write_site
from tests.ros.live_team import robot_agent
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess

pytestmark = [pytest.mark.ros, pytest.mark.long]

LEFT = math.atan2(-0.9, -0.9)
SLOT = (1.02, 0.86)
SPEED, TURN_RATE = 0.03, 0.08
"""Of the source [m/s, rad/s]."""

DRIVER = f"""\
import math
from tests.ros.builder_driver import Builder, Driver
builder = Builder((0.75, 0.60, math.pi / 2), (0.2, 0.2, {LEFT!r}), 0.09)
driver = Driver("robot1", builder, 4.0)
"""
EAR = """\
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.transport.ros1 import RosNode
codec = compose().codec()
node = RosNode.start("ear", codec)
told, states = [], []
def hear(stamped):
    fields = codec.decode(stamped.connection, stamped.raw)
    told.append([fields["task_id"], fields["progress"], fields["detail"]])
def look(stamped):
    state = codec.decode(stamped.connection, stamped.raw)
    states.append([state["activity"], state["action"]])
node.hear_topic("/mrta/task_progress", hear)
node.hear_topic("/robot1/builder_state", look)
"""


class Placed(NamedTuple):
    """What came of placing one block."""

    driver: Dict[str, Any]
    told: List[List[Any]]
    states: List[List[str]]
    topics: Dict[str, List[str]]


@pytest.fixture(scope="module")
def placed(master: MasterProcess, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Placed]:
    """Let the robot's node place one block with the stand-in's base, arm and magnet."""
    task = block_at(1, 3, 1, SLOT, heading=math.pi / 2, cells=[(3, 1), (4, 1), (5, 1)], supply=[[1, 0.2, 0.2, LEFT]])
    site = write_site(tmp_path_factory.mktemp("real") / "small_site", [], [task])
    with PythonProcess(master.environment) as driver, PythonProcess(master.environment) as ear:
        driver.do(DRIVER)
        ear.do(EAR)
        arguments = ("_robot:=robot1", f"_application:={site}", "_own_time:=true")
        with robot_agent(master.environment, *arguments):
            ear.until("any(each[1] != 0 for each in told)", 180.0)
            publishers, subscribers, _ = master.ask("getSystemState")
            found = {
                "place": "builder.block",
                "height": "builder.height",
                "dropped": "builder.dropped",
                "held": "builder.held",
                "fastest": "builder.fastest",
                "heard": "driver.heard",
                "now": "driver.now",
            }
            of_driver = {
                "says": sorted(topic for topic, nodes in publishers if "/driver" in nodes),
                "hears": sorted(topic for topic, nodes in subscribers if "/driver" in nodes),
            }
            yield Placed(
                {name: driver.ask(text) for name, text in found.items()},
                ear.ask("told"),
                ear.ask("states"),
                of_driver,
            )
        ear.do("node.shut_down('the test is over')")


def test_the_block_lies_in_its_slot(placed: Placed) -> None:
    x, y, yaw = placed.driver["place"]
    assert (x, y) == pytest.approx(SLOT, abs=0.003)
    print(placed)
    import json; open('/tmp/L/placed.json','w').write(json.dumps(placed))
