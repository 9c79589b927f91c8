"""A master that is not there yet, is lost, or comes back as a new one; and nodes that end."""

from __future__ import annotations

import time
from typing import Iterator

import pytest

from tests.ros_master import MasterProcess, say
from tests.ros_process import PythonProcess, wait_for
from tests.transport.ros1.nodes import OURS

pytestmark = pytest.mark.ros


@pytest.fixture
def lonely(own_master: MasterProcess) -> Iterator[PythonProcess]:
    """Give a process with our names whose master does not run yet."""
    with PythonProcess(own_master.environment) as process:
        process.do(OURS)
        yield process


def test_node_waits_for_a_master_and_lives_through_its_restart(
    own_master: MasterProcess, lonely: PythonProcess
) -> None:
    """What was connected goes on meanwhile; afterwards the new master knows all that the old one did."""
    lonely.do("try: RosNode.start('node', codec, await_master=False)\nexcept Exception as error: said = error")
    text = lonely.ask("str(said)")
    assert text.startswith("no ROS master answers at http://127.0.0.1:")
    assert text.endswith("; start one with roscore, or set ROS_MASTER_URI")
    assert lonely.ask("[type(said).__name__, said.exit_code]") == ["MissingDependencyError", 4]
    lonely.do(
        "import threading; made = []; starting = threading.Thread("
        "target=lambda: made.append(RosNode.start('node', codec)), daemon=True); starting.start()"
    )
    lonely.until("any('waiting for it' in text for text in lines.texts)")
    own_master.start()
    lonely.until("made")
    lonely.do("node = made[0]; changes, heard = [], []; node.on_master(changes.append)")
    lonely.do("node.subscribe(Subscription('/talk', 'std_msgs/String', ('data',)), lambda h: heard.append(h.fields))")
    lonely.do("node.serve('~sum', 'calls/Sum', lambda fields: {'sum': fields['a'] + fields['b']})")
    lonely.do("node.advertise('/talk', 'std_msgs/String')")
    lonely.until("node._mouths.mouth('/talk', 'std_msgs/String', False).is_heard")
    lonely.do("def talk(text): node.publish(Outgoing('/talk', 'std_msgs/String', {'data': text}), 0.0)")
    lonely.do("talk('before')")
    lonely.until("len(heard) == 1")
    before = own_master.ask("getSystemState")

    own_master.stop(kill=True)
    lonely.until("changes == [MasterChange.LOST]")
    lonely.do("talk('meanwhile')")
    lonely.until("len(heard) == 2")
    # A topic that is new while there is no master must not stop the node.
    lonely.do("start = time.monotonic(); node.advertise('/new', 'std_msgs/String'); passed = time.monotonic() - start")
    assert lonely.ask("passed") < 30.0

    own_master.start()
    lonely.until("changes == [MasterChange.LOST, MasterChange.RESTARTED]")
    lonely.do("talk('after')")
    lonely.until("len(heard) == 3")
    wait_for(lambda: "/new" in dict(own_master.ask("getSystemState")[0]))
    publishers, subscribers, services = own_master.ask("getSystemState")
    assert [each for each in publishers if each[0] != "/new"] == before[0]
    assert [subscribers, services] == before[1:]
    assert lonely.ask("node.call('~sum', 'calls/Sum', {'a': 1, 'b': 2}, 60.0)") == {"sum": 3}
    # A topic that appears afterwards is found.
    lonely.do("found = []; node.hear(lambda topic, _type: topic == '/new', found.append)")
    lonely.until("node._mouths.mouth('/new', 'std_msgs/String', False).is_heard")
    lonely.do("node.publish(Outgoing('/new', 'std_msgs/String', {}), 0.0)")
    lonely.until("found")
    assert lonely.ask("heard") == [{"data": "before"}, {"data": "meanwhile"}, {"data": "after"}]
    # Nor does a node whose master is gone take long to end.
    own_master.stop(kill=True)
    lonely.do("start = time.monotonic(); node.shut_down('the test is over'); passed = time.monotonic() - start")
    assert lonely.ask("passed") < 30.0
    assert lonely.ask("node.wait(0)")


def test_master_that_was_only_out_of_reach_is_found_again(node: PythonProcess) -> None:
    node.do("outages = []; node.on_master(outages.append); watched = node._watch._master; ask = watched.ask")
    node.do("def silent(*_): raise TransportError('no ROS master answers')")
    node.do("watched.ask = silent")
    node.until("outages == [MasterChange.LOST]")
    node.do("watched.ask = ask")
    node.until("outages == [MasterChange.LOST, MasterChange.FOUND]")


INTERRUPTED = """\
from rqt_mrta_py.transport.ros1.watch import MasterWatch
watches = []

def interrupted(watch):
    watches.append(watch)
    raise KeyboardInterrupt

MasterWatch.start = interrupted
try:
    RosNode.start('node', codec)
except KeyboardInterrupt:
    watches[0].stop()
"""


def test_node_that_is_interrupted_while_it_begins_can_end(own_master: MasterProcess, lonely: PythonProcess) -> None:
    own_master.start()
    lonely.do(INTERRUPTED)
    assert lonely.ask("len(watches)") == 1


@pytest.mark.parametrize("way", ["SIGINT", "rosnode kill"])
def test_node_ends_without_waiting_for_anybody(own_master: MasterProcess, lonely: PythonProcess, way: str) -> None:
    own_master.start()
    lonely.do("node = RosNode.start('node', codec); node.advertise('/talk', 'std_msgs/String')")
    lonely.do("node.subscribe(Subscription('/talk'), print)")
    lonely.until("node._mouths.mouth('/talk', 'std_msgs/String', False).is_heard")
    lonely.do("node.on_shutdown(lambda: node.publish(Outgoing('/last', 'std_msgs/String', {}, True), 0.0))")
    lonely.do("from rqt_mrta_py.app.interrupt import Interrupt; import os, signal, threading")
    if way == "SIGINT":
        lonely.do("threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()")
        lonely.do(
            "with Interrupt() as wish:\n"
            "    while not wish.requested: node.wait(0.02)\n"
            "    start = time.monotonic(); node.shut_down('interrupted')"
        )
    else:
        say("rosnode", "kill", "/node", environment=own_master.environment)
        lonely.do("start = time.monotonic(); ended = node.wait(30.0)")
    assert lonely.ask("node.is_shut_down and node.wait(0)")
    assert lonely.ask("time.monotonic() - start") < 30.0
    publishers, subscribers, services = own_master.ask("getSystemState")
    assert [publishers, subscribers, services] == [[], [], []]


def test_process_with_a_node_is_not_kept_alive_by_it(own_master: MasterProcess, lonely: PythonProcess) -> None:
    own_master.start()
    lonely.do("node = RosNode.start('node', codec); node.subscribe(Subscription('/clock'), print)")
    lonely.do("node.advertise('/clock', 'rosgraph_msgs/Clock')")
    lonely.until("node._mouths.mouth('/clock', 'rosgraph_msgs/Clock', False).is_heard")
    start = time.monotonic()
    assert lonely.leave() == 0
    assert time.monotonic() - start < 30.0
    assert own_master.ask("getSystemState") == [[], [], []]


def test_process_is_a_node_only_once(node: PythonProcess) -> None:
    assert node.ask("raised(RosNode.start, 'other', codec)") == (
        "TransportError: other: this process is a ROS node already; it can be one only once"
    )
