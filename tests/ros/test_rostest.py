"""The launch files under rostest, as ROS users test theirs."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.ros_process import require_live_ros

pytestmark = pytest.mark.ros

FILES = sorted((Path(__file__).parent / "launch").glob("*.test"))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_rostest_is_content(path: Path, tmp_path: Path) -> None:
    require_live_ros()
    messages = ROOT / ".venv" / "messages"
    if shutil.which("rostest") is None or not (messages / "rqt_mrta_py").is_dir():
        pytest.skip("not here: rostest, or generated message classes")
    environment = {
        **os.environ,
        # Programs of rostest take the first python3, which must see rospy.
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ.get('PATH', '')}",
        "PYTHONPATH": str(messages),
        "ROS_HOME": str(tmp_path),
        "ROS_HOSTNAME": "127.0.0.1",
        "ROS_LOG_DIR": str(tmp_path),
        "ROS_PACKAGE_PATH": f"{ROOT}:{ROOT / 'plugins'}",
        "ROS_TEST_RESULTS_DIR": str(tmp_path),
    }
    done = subprocess.run(
        ["rostest", str(path)], capture_output=True, text=True, env=environment, timeout=240, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "RESULT: SUCCESS" in done.stdout
