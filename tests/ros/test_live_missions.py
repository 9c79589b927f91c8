"""Teams of nodes against a real master: in lock step, free-running, with agents that die and strangers that speak."""

from __future__ import annotations

import os
import signal
import xmlrpc.client
from pathlib import Path
from typing import Dict, Tuple

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.growing_bags import written_so_far
from tests.ros.live_team import LiveRun, check_review_is_run, patrol_in, robot_agent
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess, wait_for

pytestmark = pytest.mark.ros

SAME = ("mission.bag", "summary.json", "events.jsonl", "incidents.jsonl")

# rospy and a message class made from a text, and nothing of ours.
STRANGER = """\
import genpy.dynamic, rospy, threading
from rosgraph_msgs.msg import Clock
TEXT = '''Header header
string task_id
duration expected_duration
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
'''
NAME = "alliance_msgs/InterRobotCommunication"
CLASS = genpy.dynamic.generate_dynamic(NAME, TEXT)[NAME]
rospy.init_node("stranger", disable_signals=True)
publisher = rospy.Publisher("/alliance/inter_robot_communication", CLASS, queue_size=10)
now = 0.0

def speak(clock):
    global now
    now = clock.clock.to_sec()
    if now >= 3.0:
        message = CLASS()
        message.header.stamp = clock.clock
        message.header.frame_id = "/robot3"
        message.task_id = "wander"
        message.expected_duration = rospy.Duration(1200)
        publisher.publish(message)

def hear(message):
    callers.append(message._connection_header["callerid"])

callers = []
rospy.Subscriber("/clock", Clock, speak)
rospy.Subscriber("/robot1/alliance/sensory_feedback", rospy.AnyMsg, hear)
"""

# Has loaded everything, and is a node only once it is told to.
SPARE_AGENT = """\
import multiprocessing
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.nodes import agent
host = compose()
arguments = ["_robot:=robot1", "_own_time:=false"]
spare = multiprocessing.get_context("fork").Process(target=agent.main, args=(arguments, host))
"""


@pytest.mark.parametrize(
    "plan",
    [
        ("border_patrol", "--robots", "3", "--duration", "4", "--world", "planar"),
        ("target_visiting", "--robots", "2", "--duration", "4", "--world", "planar"),
        pytest.param(("border_patrol",), marks=pytest.mark.long),
        pytest.param(("target_visiting",), marks=pytest.mark.long),
    ],
    ids=" ".join,
)
def test_lock_step_leaves_the_same_bytes_as_one_process(
    master: MasterProcess, tmp_path: Path, plan: Tuple[str, ...]
) -> None:
    with LiveRun(tmp_path / "live", master.environment, *plan, "--lock-step") as live:
        assert main(["run", *plan, "--pictures", "0", "-q", "--out", str(tmp_path / "embedded")]) == 0
        live.finish()
    assert [line for line in live.said if "waiting for" not in line] == []
    for name in SAME:
        assert (tmp_path / "live" / name).read_bytes() == (tmp_path / "embedded" / name).read_bytes(), name
    assert live.summary["allocations"]


@pytest.mark.parametrize("application", ["cleanup", "target_visiting"])
def test_a_free_running_mission_reviews_to_its_own_bytes(
    master: MasterProcess, tmp_path: Path, application: str
) -> None:
    """Threads and sockets order its messages; the bag tells how. ``test_run_services`` reviews border_patrol."""
    plan = (application, "--robots", "2", "--duration", "4", "--world", "planar")
    with LiveRun(tmp_path / "live", master.environment, *plan) as live:
        live.finish()
    assert live.summary["allocations"]
    check_review_is_run(live, tmp_path)


@pytest.fixture(scope="module")
def troubled(master: MasterProcess, tmp_path_factory: pytest.TempPathFactory) -> LiveRun:
    """Run a patrol, free-running, until everything has happened.

    From 2 s on a stranger says that robot3 wanders; at 6 s robot2 stops; at 7 s or a little later the agent of robot1
    is killed, and another process takes its place.
    """
    folder = tmp_path_factory.mktemp("troubled")
    package = patrol_in(folder, "  - {time: 6, kind: robot_stops, robot: robot2}\n")
    with PythonProcess(master.environment) as stranger, PythonProcess(master.environment) as spare:
        stranger.do(STRANGER)
        spare.do(SPARE_AGENT)
        with LiveRun(folder / "live", master.environment, str(package), "--robots", "3", "--duration", "99") as live:
            stranger.until("now >= 8.0", timeout=90.0)
            os.kill(_pid(master, "/robot1/agent"), signal.SIGKILL)
            stranger.do("time_of_death, callers = now, []")
            spare.do("spare.start()")
            stranger.until("len(callers) > 20 and now > time_of_death + 2.0", timeout=90.0)
            live.send(signal.SIGINT)
            live.finish(130)
        spare.do("spare.terminate()")
        spare.do("spare.join(10)")
        assert spare.ask("spare.exitcode") == 0
        stranger.do("rospy.signal_shutdown('done')")
    return live


def test_a_robot_that_the_scenario_stops_falls_silent(troubled: LiveRun) -> None:
    last = max(
        each.receipt_ns / 1e9 - 1.0
        for each in troubled.messages()
        if each.connection.topic.startswith("/robot2/") or each.connection.caller == "/robot2/agent"
    )
    # Sensors speak ten times a second; an agent may be a few ticks behind.
    assert 5.85 < last < 6.5


def test_an_agent_that_was_killed_goes_on_in_another_process(troubled: LiveRun) -> None:
    said = [each.receipt_ns / 1e9 - 1.0 for each in troubled.messages() if each.connection.caller == "/robot1/agent"]
    gaps = [after - before for before, after in zip(said, said[1:])]
    assert max(gaps) > 0.2
    assert max(said) > troubled.summary["time"]["end"] - 1.5


def test_a_strangers_publisher_is_heard_as_a_robot(troubled: LiveRun) -> None:
    """The supervisor has robot3 wander from then on, and robot1 begins anew to grow impatient of that task."""
    began: Dict[Tuple[str, str], float] = {}
    for each in troubled.summary["allocations"]:
        began.setdefault((each["robot"], each["task"]), each["from"] - troubled.summary["time"]["start"])
    assert 1.9 <= began["robot3", "wander"] < 2.5
    assert began.get(("robot1", "wander"), 12.0) > began["robot2", "report"] + 0.5


def test_parameters_of_a_wrong_type_are_refused_in_one_line(master: MasterProcess) -> None:
    master.ask("setParam", "/robot1/alliance/spin_rate", "fast")
    try:
        with robot_agent(master.environment, "_robot:=robot1", "_application:=border_patrol") as agent:
            said = agent.end()
    finally:
        master.ask("deleteParam", "/robot1/alliance/spin_rate")
    assert agent.status == 3
    assert said == ["agent: parameter server /robot1/alliance: robot1/spin_rate: must be a finite number (got 'fast')"]


def test_ctrl_c_leaves_whole_files(master: MasterProcess, tmp_path: Path) -> None:
    plan = ("border_patrol", "--robots", "2", "--duration", "100", "--world", "planar")
    with LiveRun(tmp_path / "live", master.environment, *plan) as live:
        active = live.out / "mission.bag.active"
        wait_for(lambda: written_so_far(active), 60.0)
        live.send(signal.SIGINT)
        said = live.end()
    assert live.status == 130, said
    assert (live.out / "summary.json").exists()
    assert live.messages()[0].connection.topic == "/mrta/mission"


def _pid(master: MasterProcess, node: str) -> int:
    uri = master.ask("lookupNode", node)
    with xmlrpc.client.ServerProxy(uri) as proxy:
        return int(str(proxy.getPid("/test")[2]))  # type: ignore[index]
