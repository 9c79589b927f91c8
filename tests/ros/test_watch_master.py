"""mrta watch through a real master."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from types import TracebackType
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Type

import pytest

from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess, require_live_ros, wait_for

pytestmark = pytest.mark.ros

SPEAKER = """\
import threading, time
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.mission_message import mission_message
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.transport.ros1 import RosNode
host = compose()
node = RosNode.start("agent", host.codec(), arguments=["__ns:=/robot1"])
speaking = threading.Event()
COMMUNICATION = "/alliance/inter_robot_communication"

def announce(application):
    node.publish(mission_message(load_mission(host.registry, application), node.now(), 0.0), node.now())

def speak():
    while speaking.wait():
        now = node.now()
        header = {"stamp": now, "frame_id": "/robot1"}
        fields = {"header": header, "task_id": "wander", "expected_duration": 100.0}
        node.publish(Outgoing(COMMUNICATION, "alliance_msgs/InterRobotCommunication", fields), now)
        time.sleep(0.05)

threading.Thread(target=speak, daemon=True).start()
"""


class Watcher:
    """A running ``mrta watch``, and what it has printed so far."""

    def __init__(self, environment: Mapping[str, str], *arguments: str) -> None:
        command = [sys.executable, "-m", "rqt_mrta_py", "watch", "--json", *arguments]
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=dict(environment)
        )
        self.documents: List[Dict[str, Any]] = []
        self.said: List[str] = []
        self._threads = [threading.Thread(target=read) for read in (self._read, self._read_errors)]
        for thread in self._threads:
            thread.start()

    def __enter__(self) -> Watcher:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], where: Optional[TracebackType]
    ) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        for thread in self._threads:
            thread.join()
        for stream in (self.process.stdout, self.process.stderr):
            assert stream is not None
            stream.close()

    def waits_for(self, wanted: Callable[[Dict[str, Any]], bool], timeout: float = 90.0) -> None:
        """Wait until a document has been printed; whatever was printed before it counts too."""
        wait_for(lambda: self.process.poll() is not None or any(map(wanted, self.documents)), timeout)
        assert any(map(wanted, self.documents)), (self.said, self.documents)

    def interrupted(self) -> Dict[str, Any]:
        """Press Ctrl-C; give the last document."""
        self.process.send_signal(signal.SIGINT)
        assert self.process.wait(60) == 130
        for thread in self._threads:
            thread.join()
        assert self.documents[-1]["line"] == "end"
        return self.documents[-1]

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.documents.append(json.loads(line))

    def _read_errors(self) -> None:
        assert self.process.stderr is not None
        self.said.extend(self.process.stderr)


def event(kind: str, **wanted: str) -> Callable[[Dict[str, Any]], bool]:
    return lambda found: found.get("kind") == kind and all(found[name] == value for name, value in wanted.items())


@pytest.fixture(scope="module")
def speaker(master: MasterProcess) -> Iterator[PythonProcess]:
    """Start a node that speaks as robot1 of border_patrol would."""
    with PythonProcess(master.environment) as process:
        process.do(SPEAKER)
        yield process
        process.do("node.shut_down('tests are over')")


def test_without_a_master_one_line_says_what_to_do(tmp_path: Path) -> None:
    require_live_ros()
    environment = {**os.environ, "ROS_MASTER_URI": "http://127.0.0.1:9", "ROS_HOME": str(tmp_path)}
    command = [sys.executable, "-m", "rqt_mrta_py", "watch"]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=False)
    assert done.returncode == 4
    (line,) = done.stderr.splitlines()
    assert line.startswith("mrta: no ROS master answers at http://127.0.0.1:9")


def test_a_team_of_which_nothing_is_known_but_its_architecture(master: MasterProcess, speaker: PythonProcess) -> None:
    """Nobody has said yet what the mission is."""
    with Watcher(master.environment, "--architecture", "mrta_alliance", "--graph") as watcher:
        watcher.waits_for(lambda found: found["line"] == "mission")
        speaker.do("speaking.set()")
        watcher.waits_for(event("robot_state", robot="robot1", state="busy"))
        watcher.waits_for(event("task_state", task="wander", state="executing"))
        speaker.do("speaking.clear()")
        # No message comes any more: time passes by itself.
        watcher.waits_for(event("robot_state", robot="robot1", state="offline"))
        end = watcher.interrupted()
    assert end["robots"] == [{"id": "robot1", "state": "offline"}]
    graph = end["communication"]
    (topic,) = [each for each in graph["topics"] if each["name"] == "/alliance/inter_robot_communication"]
    assert topic["types"] == ["alliance_msgs/InterRobotCommunication"]
    assert topic["messages"] >= 1
    assert [each["node"] for each in graph["publications"] if each["topic"] == topic["name"]] == ["/robot1/agent"]
    assert not [node for node in graph["nodes"] if "mrta_watch" in node]
    assert graph["subscriptions"] is not None


def test_a_mission_is_waited_for_and_the_next_one_begins_anew(master: MasterProcess, speaker: PythonProcess) -> None:
    with Watcher(master.environment) as watcher:
        wait_for(lambda: any("does not say what it is about" in line for line in watcher.said), 90.0)
        speaker.do("announce('border_patrol')")
        watcher.waits_for(lambda found: found.get("application") == "border_patrol")
        speaker.do("speaking.set()")
        watcher.waits_for(event("allocation_started", robot="robot1", task="wander"))
        speaker.do("announce('cleanup')")
        watcher.waits_for(lambda found: found.get("application") == "cleanup")
        end = watcher.interrupted()
        speaker.do("speaking.clear()")
    assert [each["line"] for each in watcher.documents if each["line"] != "event"] == [
        "mission",
        "end",
        "mission",
        "end",
    ]
    lines = [each["line"] for each in watcher.documents]
    first = watcher.documents[lines.index("end")]
    # Whether robot1 still has it then is a matter of how punctually it was heard.
    assert "wander" in [task["id"] for task in first["tasks"]]
    assert any(map(event("allocation_started", task="wander"), watcher.documents[: lines.index("end")]))
    assert "wander" not in [task["id"] for task in end["tasks"]]
