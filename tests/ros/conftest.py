"""A real master, one for the tests of a file."""

from __future__ import annotations

from typing import Iterator

import pytest

from tests.ros_master import MasterProcess, ros_environment
from tests.ros_process import require_live_ros


@pytest.fixture(scope="module")
def master(tmp_path_factory: pytest.TempPathFactory) -> Iterator[MasterProcess]:
    """Start a master; skip without ROS."""
    require_live_ros()
    process = MasterProcess(ros_environment(tmp_path_factory.mktemp("ros")))
    process.start()
    yield process
    process.stop()
