"""The nodes supervisor and recorder against a real master: what they hear, say, answer and leave."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Dict, Iterator, List

import pytest

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.review.review import ReviewRequest, review_bag
from rqt_mrta_py.transport import read_bag
from tests.growing_bags import written_so_far
from tests.ros.live_team import Process
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess, wait_for

pytestmark = pytest.mark.ros

ROOT = Path(__file__).resolve().parents[2]

# One process says what robots, operators and strangers say, and hears what the supervisor does.
ROBOTS = """\
import threading, time
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.hooks import Outgoing, Stamped
from rqt_mrta_py.transport.ros1 import RosNode
codec = compose().codec()
node = RosNode.start("agent", codec, arguments=["__ns:=/robot1"])
COMMUNICATION = ("/alliance/inter_robot_communication", "alliance_msgs/InterRobotCommunication")
PROGRESS = ("/mrta/task_progress", "rqt_mrta_py/TaskProgress")
MOTIVATION = ("/robot1/alliance/motivation/report", "alliance_msgs/Motivation")
heard = {}

def hear(stamped):
    fields = codec.decode(stamped.connection, stamped.raw)
    heard.setdefault(stamped.connection.topic, []).append(fields)

node.hear(lambda topic, type_name: topic.startswith("/mrta/") or topic == "/diagnostics", hear)
for topic, type_name in (COMMUNICATION, PROGRESS, MOTIVATION):
    node.advertise(topic, type_name)

def robot(frame, task="wander"):
    fields = {"header": {"stamp": node.now(), "frame_id": frame}, "task_id": task}
    node.publish(Outgoing(*COMMUNICATION, fields), 0.0)

def states(robot_id):
    return [each["state"] for each in heard.get("/mrta/robot_state", ()) if each["robot_id"] == robot_id]

def orders():
    return [(each["task_id"], each["robot_id"], each["progress"]) for each in heard.get(PROGRESS[0], ())]

def status(part):
    newest = heard["/diagnostics"][-1]["status"] if "/diagnostics" in heard else ()
    return next((each for each in newest if each["name"] == "supervisor: " + part), None)

def value(part, key):
    found = status(part)
    return found and {pair["key"]: pair["value"] for pair in found["values"]}.get(key)

def refused(name, kind, fields):
    try:
        node.call(name, "rqt_mrta_py/" + kind, fields, 10.0)
    except Exception as error:
        return str(error)

def garbage():
    connection = codec.connection(*MOTIVATION)
    node.pass_on(Stamped(connection, 0, b"\\xff\\xff\\xff\\xff\\xff"))
"""


@pytest.fixture(scope="module")
def robots(master: MasterProcess) -> Iterator[PythonProcess]:
    with PythonProcess(master.environment) as process:
        process.do(ROBOTS)
        yield process
        process.do("node.shut_down('tests are over')")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("supervisor")


def node(name: str, environment: Dict[str, str], *arguments: str) -> Process:
    """Start a node as rosrun does."""
    return Process([sys.executable, str(ROOT / "scripts" / name), *arguments], environment)


@pytest.fixture(scope="module")
def supervisor(master: MasterProcess, robots: PythonProcess, folder: Path) -> Iterator[Process]:
    """Start a supervisor of border_patrol, some of whose parameters are of a wrong type."""
    with node(
        "supervisor",
        master.environment,
        "_application:=border_patrol",
        f"_record:={folder / 'bags' / 'mission.bag'}",
        f"_out:={folder / 'out'}",
        f"_snapshots:={folder / 'snapshots'}",
        "_snapshot_seconds:=many",
        "_pictures:=0",
    ) as process:
        robots.until("'/mrta/team_state' in heard", 60.0)
        yield process


def call(robots: PythonProcess, name: str, kind: str, fields: object) -> Dict[str, object]:
    answer = robots.ask(f"node.call('/supervisor/{name}', 'rqt_mrta_py/{kind}', {fields!r}, 30.0)")
    assert isinstance(answer, dict)
    return answer


def test_mission_and_state_are_told_to_whoever_comes_late(supervisor: Process, robots: PythonProcess) -> None:
    robots.until("'/mrta/mission' in heard")
    assert robots.ask("heard['/mrta/mission'][0]['application']") == "border_patrol"
    robots.until("heard['/mrta/team_state'][-1]['robots']")
    known = robots.ask("[each['robot_id'] for each in heard['/mrta/team_state'][-1]['robots']]")
    assert known == [f"robot{number}" for number in range(1, 6)]


def test_robot_is_busy_while_it_announces_a_task_and_offline_when_it_stops(
    supervisor: Process, robots: PythonProcess
) -> None:
    """It stays busy for 2 s, as the architecture's file says; nobody says anything when that is over."""
    robots.until("(robot('/robot1'), 2 in states('robot1'))[1]")
    state = call(robots, "get_state", "GetState", {})
    assert state["application"] == "border_patrol"
    robots.until("states('robot1')[-1] == 0")
    robots.until("any(each['rule'] == 'robot_silent_with_task' for each in heard.get('/mrta/incident', ()))")


def test_error_leaves_a_snapshot(supervisor: Process, robots: PythonProcess, folder: Path) -> None:
    robots.until("any(each['rule'] == 'robot_silent_with_task' for each in heard.get('/mrta/incident', ()))", 30.0)
    wait_for(lambda: list((folder / "snapshots").glob("robot_silent_with_task-*.bag")))


def test_operators_orders_reach_the_team(supervisor: Process, robots: PythonProcess) -> None:
    answer = call(robots, "submit_task", "SubmitTask", {"task_yaml": "{id: dig, kind: wander}"})
    assert answer == {"task_id": "dig"}
    call(robots, "reassign_task", "ReassignTask", {"task_id": "dig", "robot_id": "robot2", "reason": "it is near"})
    call(robots, "withdraw_task", "WithdrawTask", {"task_id": "dig"})
    robots.until("orders()[-3:] == [('dig', '', 4), ('dig', 'robot2', 6), ('dig', '', 5)]")


def test_order_that_makes_no_sense_is_refused_in_one_line(supervisor: Process, robots: PythonProcess) -> None:
    request = {"task_id": "wander", "robot_id": "no robot!"}
    line = robots.ask(f"refused('/supervisor/reassign_task', 'ReassignTask', {request!r})")
    assert "robot_id: nobody knows 'no robot!'" in line
    assert "\n" not in line


def test_snapshot_is_a_bag_of_what_was_heard(supervisor: Process, robots: PythonProcess, folder: Path) -> None:
    answer = call(robots, "snapshot", "Snapshot", {"seconds": 0.0, "path": str(folder / "now.bag")})
    messages = list(read_bag(folder / "now.bag"))
    assert answer["messages"] == len(messages) > 0
    assert "/mrta/mission" in {each.connection.topic for each in messages}
    request = {"seconds": 0.0, "path": str(folder / "now.bag")}
    assert "exists already" in robots.ask(f"refused('/supervisor/snapshot', 'Snapshot', {request!r})")


def test_picture_is_drawn_on_request(supervisor: Process, robots: PythonProcess) -> None:
    robots.do("picture = node.call('/supervisor/get_picture', 'rqt_mrta_py/GetPicture', {'format': 'png'}, 60.0)")
    assert robots.ask("list(picture['data'])[:4]") == [0x89, *b"PNG"]


def test_bad_input_is_counted_and_survived(supervisor: Process, robots: PythonProcess) -> None:
    robots.do("garbage(); robot('no robot!'); robot('/robot99'); robot('/robot1', 'no such task')")
    robots.until("value('stream', 'unreadable') == '1'")
    robots.until("value('stream', 'wrong parameters') == '1'")
    robots.until("(robot('/robot2'), 2 in states('robot2'))[1]")


def test_supervisor_ends_clean_and_its_bag_reviews_to_its_outputs(
    supervisor: Process, robots: PythonProcess, master: MasterProcess, folder: Path, tmp_path: Path
) -> None:
    subprocess.run(["rosnode", "kill", "/supervisor"], env=master.environment, check=True, capture_output=True)
    errors = supervisor.end(30.0)
    assert supervisor.status == 0, errors
    assert [line for line in errors if "~snapshot_seconds: must be a number" in line]
    bag, out = folder / "bags" / "mission.bag", folder / "out"
    review = review_bag(compose(), ReviewRequest(bag, pictures=0, out=tmp_path / "review"), lambda *_: None)
    for name in ("summary.json", "events.jsonl", "incidents.jsonl"):
        assert (review.folder / name).read_text() == (out / name).read_text()
    assert "robot_silent_with_task" in json.dumps(review.summary["incidents"])


def test_supervisor_waits_for_a_mission_and_knows_an_architecture_by_its_file_alone(
    master: MasterProcess, robots: PythonProcess, tmp_path: Path
) -> None:
    """The robots are nobody's: they are known by what they say."""
    file = ROOT / "plugins" / "architectures" / "mrta_alliance" / "rqt_mrta.xml"
    robots.do("heard.clear()")
    arguments = (f"_architecture:={file}", "_pictures:=0", "__name:=watchman")
    with node("supervisor", master.environment, *arguments) as process:
        robots.until("(robot('/stranger7'), 2 in states('stranger7'))[1]", 60.0)
        process.send(signal.SIGINT)
        process.end(30.0)
        assert process.status == 0


def test_recording_survives_a_kill_but_for_its_last_second_and_goes_on_in_another_bag(
    master: MasterProcess, robots: PythonProcess, tmp_path: Path
) -> None:
    robots.do("def talk():\n    while talking.is_set():\n        robot('/robot1'); time.sleep(0.01)")
    robots.do("talking = threading.Event(); talking.set(); threading.Thread(target=talk, daemon=True).start()")
    arguments = (f"_record:={tmp_path / 'all.bag'}", "_topics:=/alliance/*")
    with node("recorder", master.environment, *arguments) as process:
        active = tmp_path / "all.bag.active"
        wait_for(lambda: len(stamps(active)) > 150, 60.0)
        wait_for(lambda: stamps(active)[-1] > time.time() - 1.0, 60.0)
        written = stamps(active)
        process.send(signal.SIGKILL)
        process.end(30.0)
    assert stamps(active)[: len(written)] == written
    with node("recorder", master.environment, *arguments) as process:
        wait_for(lambda: len(stamps(tmp_path / "all-2.bag.active")) > 10, 60.0)
        process.send(signal.SIGTERM)
        process.end(30.0)
        assert process.status == 0
    robots.do("talking.clear()")
    assert {each.connection.topic for each in read_bag(tmp_path / "all-2.bag")} == {
        "/alliance/inter_robot_communication"
    }


def stamps(active: Path) -> List[float]:
    """Read when the messages of an unfinished bag were received [s]."""
    return [each.receipt_ns / 1e9 for each in written_so_far(active)]
