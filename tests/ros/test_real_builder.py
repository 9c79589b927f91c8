"""A builder whose base, arm, magnet and localisation are nodes of somebody else, as of a real robot."""

from __future__ import annotations

import math
import re
import sys
from pathlib import Path
from typing import Any, Dict, Iterator, List, NamedTuple

import pytest

from tests.ros.live_team import Process, robot_agent
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess

pytestmark = [pytest.mark.ros, pytest.mark.long]

FETCH = math.atan2(-0.9, -0.9)
"""Heading of a robot that fetches in the lower left corner [rad]."""
MIDDLE = (1.1, 1.1)
"""Of an arena of 2.2 m, and so of a structure of one block [m]."""
SUPPLY = """\
arena: {side: 2.2}
places:
  - {x: 0.2, y: 0.2, blocks: {3: 1}}
"""
DRIVER = f"""\
import math
import re
import sys
from tests.ros.builder_driver import Builder, Driver
builder = Builder((0.9, 0.5, math.pi / 2), (0.2, 0.2, {FETCH!r}), 0.09)
driver = Driver("robot1", builder, 4.0)
"""
EAR = """\
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.transport.ros1 import RosNode
codec = compose().codec()
node = RosNode.start("ear", codec)
ends, states = [], []

def hear(stamped):
    fields = codec.decode(stamped.connection, stamped.raw)
    if fields["progress"] != 0:
        ends.append([fields["robot_id"], fields["progress"], fields["detail"]])

def look(stamped):
    state = codec.decode(stamped.connection, stamped.raw)
    if not states or states[-1] != [state["activity"], state["action"]]:
        states.append([state["activity"], state["action"]])

node.hear_topic("/mrta/task_progress", hear)
node.hear_topic("/robot1/builder_state", look)
"""
DONE = 1


class Placed(NamedTuple):
    """What came of placing one block.

    Attributes:
        driver: what its drivers know of robot and block.
        ends: how tasks ended: robot, progress, why.
        states: what the builder did, activity and action.
        said, heard: topics that the drivers say and hear.
        types: of all topics.
    """

    driver: Dict[str, Any]
    ends: List[List[Any]]
    states: List[List[str]]
    said: List[str]
    heard: List[str]
    types: Dict[str, str]


@pytest.fixture(scope="module")
def placed(master: MasterProcess, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Placed]:
    """Let our node build one block with the base, the arm and the magnet of a stranger."""
    folder: Path = tmp_path_factory.mktemp("real")
    (folder / "beam.txt").write_text("###\n", encoding="utf-8")
    (folder / "supply.yaml").write_text(SUPPLY, encoding="utf-8")
    settings = f"_settings:=structure={folder / 'beam.txt'} supply={folder / 'supply.yaml'}"
    with PythonProcess(master.environment) as driver, PythonProcess(master.environment) as ear:
        driver.do(DRIVER)
        ear.do(EAR)
        arguments = ("_robot:=robot1", "_application:=block_construction", "_robots:=1", settings, "_own_time:=true")
        with robot_agent(master.environment, *arguments):
            ear.until("ends", 240.0)
            ear.until("states[-1] == ['idle', '']", 20.0)
            publishers, subscribers, _ = master.ask("getSystemState")
            types = dict(master.ask("getTopicTypes"))
            known = ("block", "height", "dropped", "held", "fastest", "place")
            yield Placed(
                {name: driver.ask(f"builder.{name}") for name in known},
                ear.ask("ends"),
                ear.ask("states"),
                sorted(topic for topic, nodes in publishers if "/driver" in nodes),
                sorted(topic for topic, nodes in subscribers if "/driver" in nodes),
                types,
            )
        ear.do("node.shut_down('the test is over')")


RELAYED = """\
import rospy
from geometry_msgs.msg import PoseStamped
rospy.init_node("ear", disable_signals=True)
heard = []
rospy.Subscriber("/pose", PoseStamped, heard.append)
"""
TRANSFORMS = """\
from geometry_msgs.msg import TransformStamped

class TransformException(Exception):
    pass

class Buffer:
    asked = 0

    def lookup_transform(self, target, source, time):
        self.asked += 1
        if self.asked == 1 or (target, source, time.to_sec()) != ("map", "robot1/base_link", 0.0):
            raise TransformException(f"{target} to {source} is not known at {time}")
        found = TransformStamped()
        found.header.frame_id, found.child_frame_id = target, source
        found.transform.translation.x, found.transform.translation.y = 0.4, 1.6
        found.transform.rotation.z, found.transform.rotation.w = 0.6, 0.8
        return found

class TransformListener:
    def __init__(self, buffer):
        self.buffer = buffer
"""


def test_the_relay_on_the_page_says_what_tf_knows(master: MasterProcess, root: Path, tmp_path: Path) -> None:
    """With a stand-in for tf2_ros, which is not installed for every Python."""
    page = (root / "docs" / "applications" / "real_builder.md").read_text(encoding="utf-8")
    (relay,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    (tmp_path / "pose_from_tf").write_text(relay, encoding="utf-8")
    (tmp_path / "tf2_ros.py").write_text(TRANSFORMS, encoding="utf-8")
    with PythonProcess(master.environment) as ear:
        # The drivers of other tests simulate time, which stands still without them.
        ear.do("import rospy; rospy.set_param('/use_sim_time', False)")
        ear.do(RELAYED)
        with Process([sys.executable, str(tmp_path / "pose_from_tf")], master.environment):
            ear.until("heard")
        pose = ear.ask(
            "[heard[0].header.frame_id, heard[0].pose.position.x, heard[0].pose.position.y,"
            " heard[0].pose.orientation.z, heard[0].pose.orientation.w]"
        )
    assert pose == ["map", 0.4, 1.6, 0.6, 0.8]


def test_the_block_lies_in_its_slot(placed: Placed) -> None:
    x, y, facing = placed.driver["block"]
    assert placed.ends == [["robot1", DONE, ""]]
    assert (x, y) == pytest.approx(MIDDLE, abs=0.003)
    # It lies along x, whatever side it was placed from.
    assert abs(math.sin(facing)) == pytest.approx(1.0, abs=0.001)
    assert (placed.driver["height"], placed.driver["held"]) == (0.035, False)


def test_the_block_was_let_go_once_right_above_the_floor(placed: Placed) -> None:
    (dropped,) = placed.driver["dropped"]
    assert abs(dropped) < 0.002


def test_the_robot_drove_as_slowly_as_the_sources(placed: Placed) -> None:
    """Section 6.3 of the source: 0.03 m/s and 0.08 rad/s."""
    speed, turn_rate = placed.driver["fastest"]
    assert 0.02 < speed <= 0.03 + 1e-9
    assert 0.05 < turn_rate <= 0.08 + 1e-9


def test_both_procedures_went_through_all_their_actions(placed: Placed) -> None:
    fetching = ["position", "lower", "approach", "raise", "retreat", "raise"]
    placing = ["position", "lower", "approach", "lower", "retreat", "raise"]
    for activity, actions in (("fetching", fetching), ("placing", placing)):
        assert [action for doing, action in placed.states if doing == activity] == actions
    assert placed.states[-1] == ["idle", ""]


def test_the_drivers_need_no_other_topics_than_the_page_names(placed: Placed, root: Path) -> None:
    page = (root / "docs" / "applications" / "real_builder.md").read_text(encoding="utf-8")
    ours = "/robot1/"
    assert [topic for topic in placed.heard if topic.startswith(ours)] == [
        "/robot1/arm/command",
        "/robot1/cmd_vel",
        "/robot1/magnet/command",
    ]
    assert [topic for topic in placed.said if topic.startswith(ours)] == [
        "/robot1/arm/state",
        "/robot1/magnet/state",
        "/robot1/odom",
        "/robot1/pose",
    ]
    for topic in (*placed.heard, *placed.said):
        if topic.startswith(ours):
            assert f"| `{topic[len(ours) :]}` | {placed.types[topic]} |" in page
