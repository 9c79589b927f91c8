"""A run of nodes answers and speaks as the node supervisor does, and its recording holds what it was ordered."""

from __future__ import annotations

import json
import signal
from pathlib import Path
from typing import List

import pytest

from rqt_mrta_py.transport import read_bag
from tests.ros.live_team import LiveRun, check_review_is_run, patrol_in
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess

pytestmark = pytest.mark.ros

# Asks the supervisor, and comes late for whatever is latched.
OPERATOR = """\
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.transport.ros1 import RosNode
codec = compose().codec()
node = RosNode.start("operator_of_test", codec)
heard = {}

def hear(stamped):
    heard.setdefault(stamped.connection.topic, []).append(codec.decode(stamped.connection, stamped.raw))

def call(name, kind, **fields):
    return node.call("/supervisor/" + name, "rqt_mrta_py/" + kind, fields, 60.0)

def answer(name, kind, **fields):
    try:
        return call(name, kind, **fields)
    except Exception as error:
        return str(error)

def graph():
    known = node.graph()
    wanted = [topic for topic in known.publishers if "/alliance/" in topic]
    return {topic: [sorted(known.publishers[topic]), sorted(known.subscribers.get(topic, ()))] for topic in wanted}

def states():
    state = answer("get_state", "GetState")
    return {} if isinstance(state, str) else {each["task_id"]: each["state"] for each in state["state"]["tasks"]}
"""
EXECUTING, WITHDRAWN = 2, 5
COMMUNICATION = "/alliance/inter_robot_communication"


def test_run_answers_and_obeys_as_the_node_supervisor_does(master: MasterProcess, tmp_path: Path) -> None:
    package = patrol_in(tmp_path, "  - {time: 9000, kind: robot_stops, robot: robot2}\n")
    plan = (str(package), "--robots", "3", "--duration", "9999", "--factor", "2")
    with PythonProcess(master.environment) as operator, LiveRun(tmp_path / "run", master.environment, *plan) as run:
        operator.do(OPERATOR)
        operator.until(f"{EXECUTING} in states().values()", 90.0)
        # The dissertation's figure of three robots: all say and hear what they do, each says alone what moves it to it.
        agents, tasks = [f"/robot{number}/agent" for number in (1, 2, 3)], ("border_protection", "report", "wander")
        figure = {COMMUNICATION: [agents, [*agents, "/supervisor"]]}
        for number, agent in enumerate(agents, 1):
            for topic in (*(f"motivation/{task}" for task in tasks), "sensory_feedback", "time_to_activation"):
                figure[f"/robot{number}/alliance/{topic}"] = [[agent], ["/supervisor"]]
        operator.until(f"graph() == {figure!r}")
        assert (
            operator.ask("call('submit_task', 'SubmitTask', task_yaml='{id: dig, kind: wander}')['task_id']") == "dig"
        )
        operator.do("call('reassign_task', 'ReassignTask', task_id='dig', robot_id='robot2')")
        operator.do("call('withdraw_task', 'WithdrawTask', task_id='wander', reason='it is late')")
        assert operator.ask("states()['wander']") == WITHDRAWN
        refusal = operator.ask("answer('withdraw_task', 'WithdrawTask', task_id='nonsense')")
        assert "task_id: nobody knows 'nonsense'" in refusal

        picture = operator.ask("list(call('get_picture', 'GetPicture', format='png')['data'][:4])")
        assert picture == [0x89, *b"PNG"]
        snapshot = operator.ask("call('snapshot', 'Snapshot', seconds=5.0)")
        assert Path(snapshot["path"]).parent == run.out
        assert snapshot["messages"] == len(list(read_bag(Path(snapshot["path"])))) > 0

        operator.do("for topic in ('/mrta/task_state', '/diagnostics'): node.hear_topic(topic, hear)")
        operator.until("{'/mrta/task_state', '/diagnostics'} <= set(heard)", 60.0)
        assert operator.ask("heard['/mrta/task_state'][0]['task_id']")
        run.send(signal.SIGINT)
        run.finish(130)
        operator.do("node.shut_down('the test is over')")
    assert "wander is withdrawn: it is late" in told(run)
    check_review_is_run(run, tmp_path)


def test_run_in_lock_step_obeys(master: MasterProcess, tmp_path: Path) -> None:
    package = patrol_in(tmp_path, "  - {time: 9000, kind: robot_stops, robot: robot2}\n")
    plan = (str(package), "--robots", "2", "--duration", "9999", "--lock-step")
    with PythonProcess(master.environment) as operator, LiveRun(tmp_path / "run", master.environment, *plan) as run:
        operator.do(OPERATOR)
        operator.until(f"{EXECUTING} in states().values()", 90.0)
        operator.do("call('submit_task', 'SubmitTask', task_yaml='{id: dig, kind: wander}')")
        operator.do("call('withdraw_task', 'WithdrawTask', task_id='wander', reason='it is late')")
        operator.until(f"(states().get('wander'), states().get('dig')) == ({WITHDRAWN}, {EXECUTING})", 90.0)
        run.send(signal.SIGINT)
        run.finish(130)
        operator.do("node.shut_down('the test is over')")
    assert "wander is withdrawn: it is late" in told(run)
    check_review_is_run(run, tmp_path)


def told(run: LiveRun) -> List[str]:
    return [json.loads(line)["text"] for line in (run.out / "events.jsonl").read_text().splitlines()]
