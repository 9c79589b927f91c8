"""The process of a robot's agent is killed: the supervisor notices, and the team goes on without it."""

from __future__ import annotations

import json
import os
import signal
import xmlrpc.client
from pathlib import Path

import pytest

from tests.ros.live_team import LiveRun, patrol_in
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess

pytestmark = pytest.mark.ros

LIMIT = 120.0
OFFLINE = 0

EAR = """\
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.transport.ros1 import RosNode
codec = compose().codec()
node = RosNode.start("ear", codec)
states, holders = {}, {}

def hear(stamped):
    team = codec.decode(stamped.connection, stamped.raw)
    states.update((each["robot_id"], each["state"]) for each in team["robots"])
    holders.update((each["task_id"], each["robots"]) for each in team["tasks"])

node.hear_topic("/mrta/team_state", hear)
"""


def test_task_of_a_robot_whose_agent_is_killed_is_taken_over(master: MasterProcess, tmp_path: Path) -> None:
    """Four robots, three tasks: one robot has none, and grows impatient.

    What the simulation says for the robot's sensors goes on, so it is not silent: it is offline, and has given up.
    """
    package = patrol_in(tmp_path, "  - {time: 99999, kind: robot_stops, robot: robot1}\n")
    plan = (str(package), "--robots", "4", "--duration", "9999", "--factor", "4")
    with PythonProcess(master.environment) as ear:
        ear.do(EAR)
        with LiveRun(tmp_path / "live", master.environment, *plan) as live:
            ear.until("len(holders.get('report', ())) == 1", LIMIT)
            (killed,) = ear.ask("holders['report']")
            os.kill(_pid(master, f"/{killed}/agent"), signal.SIGKILL)
            ear.until(f"states[{killed!r}] == {OFFLINE} and holders['report'] not in ([], [{killed!r}])", LIMIT)
            live.send(signal.SIGINT)
            live.finish(130)
        ear.do("node.shut_down('the test is over')")
    holds = [each for each in live.summary["allocations"] if each["task"] == "report"]
    lost = next(each for each in holds if each["robot"] == killed)
    assert lost["outcome"] == "gave_up"
    assert [each for each in holds if each["robot"] != killed and each["from"] >= lost["to"]]
    events = [json.loads(line) for line in (live.out / "events.jsonl").read_text().splitlines()]
    assert (killed, "offline", "warning") in {(each["robot"], each["state"], each["severity"]) for each in events}


def _pid(master: MasterProcess, node: str) -> int:
    uri = master.ask("lookupNode", node)
    with xmlrpc.client.ServerProxy(uri) as proxy:
        return int(str(proxy.getPid("/test")[2]))  # type: ignore[index]
