"""What others show of a team: RViz and a diagnostic aggregator, where they are installed."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import Dict, Iterator, List

import pytest

from tests.conftest import ROOT
from tests.ros_master import MasterProcess
from tests.ros_process import LONGEST, PythonProcess

pytestmark = pytest.mark.ros

ONLOOKER = """\
from rqt_mrta_py.transport import RosCodec
from rqt_mrta_py.transport.ros1 import RosNode
node = RosNode.start("onlooker", RosCodec(lambda type_name: None))
sorted_as = set()

def hear(stamped):
    for status in node.codec.decode(stamped.connection, stamped.raw)["status"]:
        if status["level"] == 0:
            sorted_as.add(status["name"])

node.hear(lambda topic, type_name: topic == "/diagnostics_agg", hear)

def hearers(topic):
    return node.graph().subscribers.get(topic, ())
"""


@pytest.fixture
def environment(master: MasterProcess) -> Dict[str, str]:
    if shutil.which("roslaunch") is None:
        pytest.skip("roslaunch is not installed")
    path = os.pathsep.join(filter(None, [str(ROOT), str(ROOT / "plugins"), os.environ.get("ROS_PACKAGE_PATH")]))
    return {**master.environment, "ROS_PACKAGE_PATH": path}


@contextmanager
def launched(environment: Dict[str, str], log: Path, *arguments: str) -> Iterator[None]:
    """Launch a supervisor of border_patrol with further arguments; what it says is shown if the test fails."""
    command = ["roslaunch", "rqt_mrta_py", "supervisor.launch", "application:=border_patrol", "pictures:=0"]
    with log.open("wb") as out:
        process = subprocess.Popen([*command, *arguments], stdout=out, stderr=out, env=environment)
        try:
            yield
        finally:
            process.send_signal(signal.SIGINT)
            try:
                process.wait(LONGEST)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            sys.stdout.write(log.read_text(errors="replace"))


@contextmanager
def screen() -> Iterator[str]:
    """Give the name of a screen that nobody sees."""
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1500x1000x24"]
    with subprocess.Popen(command, pass_fds=(writing,), stderr=subprocess.DEVNULL) as process:
        os.close(writing)
        try:
            with os.fdopen(reading) as told:
                yield f":{told.readline().strip()}"
        finally:
            process.terminate()


def require(package: str, environment: Dict[str, str], *programs: str) -> None:
    found = subprocess.run(["rospack", "find", package], env=environment, capture_output=True, check=False)
    missing: List[str] = [] if found.returncode == 0 else [package]
    missing.extend(name for name in programs if shutil.which(name) is None)
    if missing:
        pytest.skip(f"not installed: {', '.join(missing)}")


def test_an_aggregator_sorts_our_health(environment: Dict[str, str], tmp_path: Path) -> None:
    require("diagnostic_aggregator", environment)
    with launched(environment, tmp_path / "log", "aggregator:=true"), PythonProcess(environment) as onlooker:
        onlooker.do(ONLOOKER)
        onlooker.until("'/Task allocation/supervisor: recording' in sorted_as")


def test_rviz_hears_what_it_is_to_show(environment: Dict[str, str], tmp_path: Path) -> None:
    require("rviz", environment, "Xvfb")
    with screen() as name:
        seen = {**environment, "DISPLAY": name, "LIBGL_ALWAYS_SOFTWARE": "1"}
        with launched(seen, tmp_path / "log", "rviz:=true"), PythonProcess(environment) as onlooker:
            onlooker.do(ONLOOKER)
            onlooker.until("'/rviz' in hearers('/mrta/markers') and '/rviz' in hearers('/tf')")
