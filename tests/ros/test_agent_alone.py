"""An agent on a robot where nobody simulates anything: it takes its turns by the clock."""

from __future__ import annotations

import signal

import pytest

from tests.ros.live_team import robot_agent
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess

pytestmark = pytest.mark.ros

EAR = """\
import time
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.transport.ros1 import RosNode
codec = compose().codec()
node = RosNode.start("ear", codec)
motivations = []

def hear(stamped):
    if stamped.connection.caller == "/robot1/agent":
        fields = codec.decode(stamped.connection, stamped.raw)
        motivations.append(fields["header"]["stamp"])

node.hear_topic("/robot1/alliance/motivation/wander", hear)
"""


def test_agent_takes_turns_by_the_walls_clock_where_time_is_not_simulated(master: MasterProcess) -> None:
    with PythonProcess(master.environment) as ear:
        ear.do(EAR)
        with robot_agent(master.environment, "_robot:=robot1", "_application:=border_patrol") as agent:
            ear.until("len(motivations) > 20", 60.0)
            agent.send(signal.SIGINT)
            said = agent.end()
        now = ear.ask("time.time()")
        stamps = ear.ask("motivations")
        ear.do("node.shut_down('the test is over')")
    assert agent.status == 0, said
    assert stamps == sorted(set(stamps))
    assert now - 90.0 < stamps[0] < stamps[-1] <= now
