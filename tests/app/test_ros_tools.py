"""The bag of a run, opened with ROS's own tools."""

from __future__ import annotations

import os
import re
import shutil
import socket
import subprocess
import sys
from pathlib import Path
from typing import Dict, Iterator, Tuple

import pytest

from tests.app.outputs import Outputs
from tests.ros_master import running_master, say

pytestmark = pytest.mark.ros

STANDARD_TOPICS = {
    "/clock": "rosgraph_msgs/Clock",
    "/tf": "tf2_msgs/TFMessage",
    "/rosout": "rosgraph_msgs/Log",
    "/robot1/odom": "nav_msgs/Odometry",
    "/robot1/pose": "geometry_msgs/PoseStamped",
    "/robot1/scan": "sensor_msgs/LaserScan",
    "/robot1/cmd_vel": "geometry_msgs/Twist",
    "/robot1/alliance/motivation/wander": "alliance_msgs/Motivation",
    "/robot1/alliance/sensory_feedback": "alliance_msgs/SensoryFeedback",
    "/alliance/inter_robot_communication": "alliance_msgs/InterRobotCommunication",
    "/mrta/markers": "visualization_msgs/MarkerArray",
    "/mrta/monitor/compressed": "sensor_msgs/CompressedImage",
    "/mrta/mission": "rqt_mrta_py/Mission",
    "/mrta/team_state": "rqt_mrta_py/TeamState",
    "/mrta/robot_state": "rqt_mrta_py/RobotState",
    "/mrta/task_state": "rqt_mrta_py/TaskState",
    "/mrta/allocation": "rqt_mrta_py/Allocation",
    "/mrta/task_progress": "rqt_mrta_py/TaskProgress",
    "/mrta/event": "rqt_mrta_py/Event",
    "/mrta/incident": "rqt_mrta_py/Incident",
    "/mrta/scenario_event": "rqt_mrta_py/ScenarioEvent",
}


@pytest.fixture(scope="module")
def ros_environment(tmp_path_factory: pytest.TempPathFactory) -> Dict[str, str]:
    """Give an environment in which ROS's tools see the generated message classes; skip without ROS."""
    if shutil.which("rosbag") is None:
        pytest.skip("ROS 1 is not installed: no rosbag on PATH")
    home = str(tmp_path_factory.mktemp("ros"))
    messages = [line for line in sys.path if (Path(line) / "alliance_msgs" / "msg").is_dir()]
    if not messages:
        pytest.skip("message classes have not been generated into the virtual environment")
    return {
        **os.environ,
        "PYTHONPATH": os.pathsep.join([*messages, os.environ.get("PYTHONPATH", "")]),
        "ROS_HOME": home,
        "ROS_LOG_DIR": home,
        "ROS_HOSTNAME": "127.0.0.1",
    }


def rosbag(*arguments: str, environment: Dict[str, str], timeout: float = 60) -> str:
    return say("rosbag", *arguments, environment=environment, timeout=timeout)


def test_rosbag_info_finds_every_topic_with_its_type_and_messages(
    patrol: Outputs, ros_environment: Dict[str, str]
) -> None:
    text = rosbag("info", str(patrol.bag), environment=ros_environment)
    found = dict(re.findall(r"(/\S+)\s+\d+ msgs?\s+: (\S+)", text))
    assert {topic: found.get(topic) for topic in STANDARD_TOPICS} == STANDARD_TOPICS
    assert min(int(count) for count in re.findall(r"\s(\d+) msgs?\s+:", text)) > 0


def test_rosbag_check_needs_no_rule_to_play_the_bag(patrol: Outputs, ros_environment: Dict[str, str]) -> None:
    text = rosbag("check", str(patrol.bag), environment=ros_environment)
    assert "rules missing" not in text
    assert "does not need any migrations" in text or "Bag is ready to be migrated" in text


def test_message_types_are_those_of_the_generated_classes(patrol: Outputs, ros_environment: Dict[str, str]) -> None:
    """Equal md5 means that any ROS node reads what was recorded."""
    script = (
        "import sys, rosbag, roslib.message\n"
        "connections = rosbag.Bag(sys.argv[1])._get_connections()\n"
        "wrong = [c.datatype for c in connections\n"
        "         if roslib.message.get_message_class(c.datatype)._md5sum != c.md5sum]\n"
        "sys.exit(' '.join(wrong) or 0)\n"
    )
    finished = subprocess.run(
        ["/usr/bin/python3", "-c", script, str(patrol.bag)],
        capture_output=True,
        text=True,
        env=ros_environment,
        timeout=60,
        check=False,
    )
    assert finished.returncode == 0, finished.stderr


@pytest.fixture
def master(ros_environment: Dict[str, str]) -> Iterator[Dict[str, str]]:
    """Start a master on a free port and give an environment that points at it."""
    with running_master(ros_environment) as environment:
        yield environment


def test_rosbag_play_plays_the_bag_to_a_real_master(patrol: Outputs, master: Dict[str, str]) -> None:
    text = rosbag("play", "--quiet", "-r", "50", "-u", "100", str(patrol.bag), environment=master, timeout=120)
    assert "ERROR" not in text


def test_roslaunch_runs_and_reviews_a_mission(ros_environment: Dict[str, str], root: Path, tmp_path: Path) -> None:
    environment = {**ros_environment, "ROS_PACKAGE_PATH": f"{root}:{root / 'plugins'}"}
    run = tmp_path / "run"
    options = "options:=--duration 2 --pictures 0"
    roslaunch("run.launch", f"out:={run}", options, environment=environment)
    assert (run / "mission.bag").exists()
    review = tmp_path / "review"
    roslaunch("review.launch", f"bag:={run / 'mission.bag'}", f"out:={review}", environment=environment)
    assert (review / "summary.json").read_bytes() == (run / "summary.json").read_bytes()


FOREIGN_ARCHITECTURE = """<package format="2">
  <name>foreign</name> <version>1.0.0</version> <description>d</description>
  <maintainer email="a@b.c">m</maintainer> <license>l</license>
  <depend>rqt_mrta</depend>
  <export> <rqt_mrta architecture="${prefix}/rqt_mrta.xml"/> </export>
</package>
"""


@pytest.mark.parametrize(
    ("arguments", "found"),
    [
        (("--attrib=architecture", "rqt_mrta_py"), "mrta_alliance"),
        (("--attrib=application", "rqt_mrta_py"), "border_patrol"),
        (("--attrib=plugin", "rqt_mrta_py"), "basic_behaviours"),
        (("--attrib=architecture", "rqt_mrta"), "foreign"),
    ],
)
def test_rospack_lists_what_is_registered(
    ros_environment: Dict[str, str], root: Path, tmp_path: Path, arguments: Tuple[str, str], found: str
) -> None:
    """Foreign packages register with rqt_mrta, which a stub stands in for where it is not installed."""
    package = tmp_path / "foreign"
    package.mkdir()
    (package / "package.xml").write_text(FOREIGN_ARCHITECTURE)
    environment = {**ros_environment, "ROS_PACKAGE_PATH": f"{tmp_path}:{root}:{root / 'plugins'}"}
    command = ["rospack", "plugins", *arguments]
    finished = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=False)
    assert finished.returncode == 0, finished.stderr
    assert found in [line.split()[0] for line in finished.stdout.splitlines()]


def roslaunch(*arguments: str, environment: Dict[str, str]) -> None:
    """Launch with a master of its own on a free port; a required node's end ends the launch."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    command = ["roslaunch", "-p", port, "rqt_mrta_py", *arguments]
    environment = {**environment, "ROS_MASTER_URI": f"http://127.0.0.1:{port}"}
    finished = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert "finished cleanly" in finished.stdout + finished.stderr, finished.stdout
    assert finished.returncode == 0, finished.stderr
