"""A master, a node of ours and a stranger, shared by tests that each use topics of their own."""

from __future__ import annotations

from typing import Dict, Iterator

import pytest

from tests.ros_master import MasterProcess, ros_environment
from tests.ros_process import PythonProcess, require_live_ros
from tests.transport.ros1.nodes import OURS, STRANGER


@pytest.fixture(scope="session")
def ros_home(tmp_path_factory: pytest.TempPathFactory) -> Dict[str, str]:
    """Give an environment for processes that use ROS; skip without ROS."""
    require_live_ros()
    return ros_environment(tmp_path_factory.mktemp("ros"))


@pytest.fixture(scope="session")
def master(ros_home: Dict[str, str]) -> Iterator[MasterProcess]:
    """Start a master."""
    process = MasterProcess(ros_home)
    process.start()
    yield process
    process.stop()


@pytest.fixture
def own_master(ros_home: Dict[str, str]) -> Iterator[MasterProcess]:
    """Give a master that a test may start, kill and start again."""
    process = MasterProcess(ros_home)
    yield process
    process.stop(kill=True)


@pytest.fixture(scope="session")
def node(master: MasterProcess) -> Iterator[PythonProcess]:
    """Start a node of ours, /node."""
    with PythonProcess(master.environment) as process:
        process.do(OURS + "node = RosNode.start('node', codec)")
        yield process
        process.do("node.shut_down('tests are over')")


@pytest.fixture(scope="session")
def stranger(master: MasterProcess) -> Iterator[PythonProcess]:
    """Start a node that has nothing of ours, /stranger."""
    with PythonProcess(master.environment) as process:
        process.do(STRANGER + "rospy.init_node('stranger', disable_signals=True)")
        yield process
        process.do("rospy.signal_shutdown('tests are over')")
