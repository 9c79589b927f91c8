"""A supervisor that is killed and started again, and one whose master is: neither loses what it knew."""

from __future__ import annotations

import signal
import sys
import time
from pathlib import Path
from typing import Callable, Dict, Iterator, List, Set

import pytest

from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import read_bag
from tests.growing_bags import written_so_far
from tests.ros.live_team import Process
from tests.ros_master import MasterProcess, ros_environment
from tests.ros_process import PythonProcess, require_live_ros, wait_for

pytestmark = pytest.mark.ros

ROOT = Path(__file__).resolve().parents[2]
LIMIT = 90.0

# Two robots, and somebody who hears what the supervisor says.
TEAM = """\
import threading, time
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.transport.ros1 import RosNode
codec = compose().codec()
node = RosNode.start("agent", codec, arguments=["__ns:=/robot1"])
COMMUNICATION = ("/alliance/inter_robot_communication", "alliance_msgs/InterRobotCommunication")
node.advertise(*COMMUNICATION)
node.advertise("/mrta/task_progress", "rqt_mrta_py/TaskProgress")
newest, count, masters, tasks = {}, {}, [], {"/robot1": "wander", "/robot2": "report"}
speaking = threading.Event()
speaking.set()
node.on_master(lambda change: masters.append(change.name))

def hear(stamped):
    topic = stamped.connection.topic
    newest[topic] = codec.decode(stamped.connection, stamped.raw)
    count[topic] = count.get(topic, 0) + 1

node.hear(lambda topic, type_name: topic in ("/mrta/mission", "/mrta/team_state"), hear)

def speak():
    while speaking.wait():
        for robot, task in tuple(tasks.items()):
            fields = {"header": {"stamp": node.now(), "frame_id": robot}, "task_id": task}
            node.publish(Outgoing(*COMMUNICATION, fields), 0.0)
        time.sleep(0.02)

def done(robot, task):
    del tasks["/" + robot]
    fields = {"header": {"stamp": node.now()}, "task_id": task, "robot_id": robot, "progress": 1}
    node.publish(Outgoing("/mrta/task_progress", "rqt_mrta_py/TaskProgress", fields), 0.0)

def states(kind):
    team = newest.get("/mrta/team_state", {"robots": (), "tasks": ()})
    return {each[kind + "_id"]: each["state"] for each in team[kind + "s"]}

def holds():
    team = newest.get("/mrta/team_state", {"allocations": ()})
    return sorted((each["robot_id"], each["task_id"]) for each in team["allocations"])

threading.Thread(target=speak, daemon=True).start()
"""
BUSY, EXECUTING, DONE = 2, 2, 3


@pytest.fixture
def own_master(tmp_path: Path) -> Iterator[MasterProcess]:
    """Start a master for one test alone, which may kill it."""
    require_live_ros()
    process = MasterProcess(ros_environment(tmp_path / "ros"))
    process.start()
    try:
        yield process
    finally:
        process.stop()


@pytest.fixture
def team(own_master: MasterProcess) -> Iterator[PythonProcess]:
    with PythonProcess(own_master.environment) as process:
        process.do(TEAM)
        yield process
        process.do("node.shut_down('the test is over')")


def supervisor(environment: Dict[str, str], *arguments: str) -> Process:
    """Start the node as rosrun does."""
    command = [sys.executable, str(ROOT / "scripts" / "supervisor"), "_application:=border_patrol", "_pictures:=0"]
    return Process([*command, *arguments], environment)


def kept(active: Path) -> List[Stamped]:
    return written_so_far(active)


def soon(condition: Callable[[], bool]) -> None:
    """Wait until something is so of a bag, looking now and then, for each look reads it."""
    wait_for(lambda: condition() or time.sleep(0.2), LIMIT)


def topics(messages: List[Stamped]) -> Set[str]:
    return {each.connection.topic for each in messages}


def test_supervisor_that_is_killed_while_it_records_goes_on_where_it_broke_off(
    own_master: MasterProcess, team: PythonProcess, tmp_path: Path
) -> None:
    """That a task is done is said once, before the kill; who holds what is said again and again."""
    active, second = tmp_path / "all.bag.active", tmp_path / "all-2.bag"
    record = f"_record:={tmp_path / 'all.bag'}"
    with supervisor(own_master.environment, record) as first:
        team.until(
            f"states('task').get('wander') == {EXECUTING} and states('task').get('report') == {EXECUTING}", LIMIT
        )
        team.do("done('robot2', 'report')")
        team.until(f"states('task')['report'] == {DONE}", LIMIT)
        before = team.ask("count['/mrta/team_state']")
        team.until(f"count['/mrta/team_state'] > {before} + 1", LIMIT)
        soon(lambda: kept(active)[-1].receipt_ns / 1e9 > time.time() - 1.0)
        seen, killed = kept(active), time.time()
        first.send(signal.SIGKILL)
        first.end()
    left = active.read_bytes()
    assert kept(active)[: len(seen)] == seen
    team.do("newest.clear()")
    with supervisor(own_master.environment, record) as resumed:
        team.until(f"states('task').get('report') == {DONE} and holds() == [('robot1', 'wander')]", LIMIT)
        assert team.ask("states('robot')['robot1']") == BUSY
        assert team.ask("states('task')['wander']") == EXECUTING
        team.until("newest['/mrta/mission']['application'] == 'border_patrol'", LIMIT)
        soon(lambda: len(kept(second.with_name("all-2.bag.active"))) > 100)
        resumed.send(signal.SIGTERM)
        said = resumed.end()
    assert resumed.status == 0, said
    assert active.read_bytes() == left
    messages = list(read_bag(second))
    assert {"/mrta/mission", "/mrta/task_progress", "/alliance/inter_robot_communication"} <= topics(messages)
    assert messages[0].receipt_ns / 1e9 > killed


def test_master_that_is_killed_and_started_again_costs_the_supervisor_no_state(
    own_master: MasterProcess, team: PythonProcess, tmp_path: Path
) -> None:
    active = tmp_path / "all.bag.active"
    with supervisor(own_master.environment, f"_record:={tmp_path / 'all.bag'}") as node:
        team.until(
            f"states('task').get('wander') == {EXECUTING} and states('task').get('report') == {EXECUTING}", LIMIT
        )
        team.do("done('robot2', 'report')")
        team.until(f"states('task')['report'] == {DONE} and holds() == [('robot1', 'wander')]", LIMIT)
        since = team.ask("[each['start'] for each in newest['/mrta/team_state']['allocations']]")
        own_master.stop(kill=True)
        told, heard = team.ask("count['/mrta/team_state']"), len(kept(active))
        # What is connected goes on without a master.
        team.until(f"count['/mrta/team_state'] > {told} + 1", LIMIT)
        soon(lambda: len(kept(active)) > heard + 20)
        own_master.start()
        team.until("masters and masters[-1] != 'LOST'", LIMIT)
        wait_for(lambda: "/supervisor/get_state" in str(own_master.ask("getSystemState")), LIMIT)
        # Whoever comes now finds the services, and the latched topics as they were.
        with PythonProcess(own_master.environment) as late:
            late.do(TEAM.replace('"agent"', '"late"').replace("speaking.set()", ""))
            late.until("'/mrta/mission' in newest and '/mrta/team_state' in newest", LIMIT)
            assert late.ask("newest['/mrta/mission']['application']") == "border_patrol"
            state = late.ask("node.call('/supervisor/get_state', 'rqt_mrta_py/GetState', {}, 60.0)")
            late.do("node.shut_down('it has seen enough')")
        assert state["application"] == "border_patrol"
        assert {each["task_id"]: each["state"] for each in state["state"]["tasks"]}["report"] == DONE
        assert [each["start"] for each in state["state"]["allocations"]] == since
        # A robot that nobody knew before the restart is heard too.
        team.do("tasks['/robot3'] = 'border_protection'")
        team.until("('robot3', 'border_protection') in holds()", LIMIT)
        node.send(signal.SIGTERM)
        said = node.end()
    assert node.status == 0, said
    assert len(list(read_bag(tmp_path / "all.bag"))) > heard + 20
