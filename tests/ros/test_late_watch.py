"""mrta watch of somebody who comes late: what nobody says again is known from the supervisor."""

from __future__ import annotations

import pytest

from tests.ros.test_watch_master import Watcher
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess

pytestmark = pytest.mark.ros

# Robots are silent and a supervisor tells of them, once, as states that last do. The clock stands still.
TELLER = """\
import time
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.mission_message import mission_message
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.transport.ros1 import RosNode
host = compose()
node = RosNode.start("supervisor", host.codec())
node.advertise("/clock", "rosgraph_msgs/Clock")
node.publish(mission_message(load_mission(host.registry, "border_patrol"), 1.0, 0.0), 1.0)
fields = {
    "header": {"stamp": 42.0},
    "robots": [{"robot_id": "robot1", "state": 2}, {"robot_id": "robot2", "state": 0}],
    "tasks": [{"task_id": "wander", "state": 2, "robots": ["robot1"]}, {"task_id": "report", "state": 3}],
    "allocations": [{"task_id": "wander", "robot_id": "robot1", "start": 30.0}],
}
node.publish(Outgoing("/mrta/team_state", "rqt_mrta_py/TeamState", fields, latched=True), 42.0)
"""


def test_late_watch_begins_with_the_present_allocation_and_tasks_that_are_done(master: MasterProcess) -> None:
    master.ask("setParam", "/use_sim_time", True)
    try:
        with PythonProcess(master.environment) as teller:
            teller.do(TELLER)
            with Watcher(master.environment) as watcher:
                watcher.waits_for(lambda found: found["line"] == "standing")
                end = watcher.interrupted()
            teller.do("node.shut_down('the test is over')")
    finally:
        master.ask("deleteParam", "/use_sim_time")
    assert [each["line"] for each in watcher.documents] == ["mission", "standing", "end"]
    standing = watcher.documents[1]
    assert standing["told_by"] == "/supervisor"
    assert standing["told_at"] == 42.0
    assert standing["robots"] == [{"id": "robot1", "state": "busy"}]
    assert standing["tasks"] == [
        {"id": "report", "state": "done", "robots": []},
        {"id": "wander", "state": "executing", "robots": ["robot1"]},
    ]
    assert {"id": "wander", "state": "executing", "robots": ["robot1"]} in end["tasks"]
    assert {"id": "report", "state": "done", "robots": []} in end["tasks"]
    assert {"id": "robot1", "state": "busy"} in end["robots"]
