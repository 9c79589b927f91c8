"""Names, remappings, namespaces and parameters of a live node."""

from __future__ import annotations

import sys
from typing import Any, Dict, Iterator, List

import pytest

from rqt_mrta_py.errors import MissingDependencyError, TransportError
from rqt_mrta_py.transport import RosCodec
from rqt_mrta_py.transport.ros1 import RosNode
from rqt_mrta_py.transport.ros1.arguments import NodeArguments
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess
from tests.transport.ros1.nodes import OURS


def test_arguments_are_told_apart() -> None:
    given = ["scan:=/robot1/laser", "__name:=left", "_rate:=5", "__ns:=team/a", "__log:=/tmp/x.log"]
    assert NodeArguments.read(given, {"ROS_NAMESPACE": "other"}) == NodeArguments(
        "/team/a/", {"scan": "/robot1/laser"}, ("__name:=left", "_rate:=5", "__log:=/tmp/x.log")
    )


@pytest.mark.parametrize(
    ("environment", "namespace"),
    [({}, "/"), ({"ROS_NAMESPACE": "/"}, "/"), ({"ROS_NAMESPACE": "/robot1"}, "/robot1/")],
)
def test_namespace_comes_from_the_environment_where_no_argument_names_it(
    environment: Dict[str, str], namespace: str
) -> None:
    assert NodeArguments.read((), environment).namespace == namespace


@pytest.mark.parametrize(
    ("argument", "complaint"),
    [
        (
            "--fast",
            "'--fast' is no argument of a ROS node; accepted are name:=name, _parameter:=value, "
            "__name:=name and __ns:=namespace",
        ),
        ("scan:=", "'scan:=' is no argument of a ROS node"),
        ("9scan:=laser", "9scan:=laser: '9scan' is not a name that ROS accepts: letters, digits, _ and /"),
        ("scan:=my laser", "scan:=my laser: 'my laser' is not a name that ROS accepts"),
        ("__ns:=robot 1", "namespace 'robot 1': 'robot 1' is not a name that ROS accepts"),
    ],
)
def test_argument_that_is_none_is_refused(argument: str, complaint: str) -> None:
    with pytest.raises(TransportError) as caught:
        NodeArguments.read([argument], {})
    assert str(caught.value).startswith(complaint)


@pytest.fixture(scope="module")
def remapped(master: MasterProcess) -> Iterator[PythonProcess]:
    """Start a node with a namespace, remappings and private parameters."""
    arguments = ["__ns:=/team", "__name:=second", "news:=/there", "/there:=/elsewhere", "_limits:={low: 1.5}", "_n:=3"]
    with PythonProcess(master.environment) as process:
        process.do(OURS + f"node = RosNode.start('first', codec, arguments={arguments!r})")
        yield process


@pytest.mark.ros
def test_node_is_named_and_speaks_as_its_arguments_say(remapped: PythonProcess, master: MasterProcess) -> None:
    remapped.do("heard = []; node.subscribe(Subscription('news', '', ('data',)), heard.append)")
    remapped.do("node.publish(Outgoing('news', 'std_msgs/String', {'data': 'hello'}, True), 0.0)")
    remapped.do("node.publish(Outgoing('~own', 'std_msgs/String', {'data': 'mine'}, True), 0.0)")
    remapped.do("node.serve('sum', 'calls/Sum', dict)")
    remapped.until("heard")
    assert remapped.ask("[node.name, heard[0].topic, heard[0].caller]") == ["/team/second", "/there", "/team/second"]
    remapped.until("'/team/sum' in node.graph().services and '/team/second/own' in node.graph().types")
    remapped.do("graph = node.graph()")
    assert remapped.ask("[graph.publishers['/there'], graph.subscribers['/there'], graph.types['/there']]") == [
        ["/team/second"],
        ["/team/second"],
        "std_msgs/String",
    ]
    assert remapped.ask("['/team/second' in graph.nodes, '/elsewhere' in graph.topics]") == [True, False]


@pytest.mark.ros
def test_parameters_are_plain_values(remapped: PythonProcess, master: MasterProcess) -> None:
    master.ask("setParam", "/team/robots", ["robot1", "robot2"])
    values: List[Any] = [
        ("node.parameter('~n')", 3),
        ("node.parameter('~limits/low')", 1.5),
        ("node.parameters('~')", {"limits": {"low": 1.5}, "n": 3}),
        ("node.parameter('robots')", ["robot1", "robot2"]),
        ("node.parameter('/nothing', 'default')", "default"),
        ("node.parameters('/nothing')", {}),
        ("node.parameters('~n')", {}),
    ]
    assert [remapped.ask(text) for text, _ in values] == [value for _, value in values]
    remapped.do("node.set_parameter('~n', True)")
    assert master.ask("getParam", "/team/second/n") is True


@pytest.mark.ros
@pytest.mark.parametrize(
    ("call", "complaint"),
    [
        ("node.parameter, 'a b'", "/team/second: 'a b' is not a name that ROS accepts"),
        ("node.set_parameter, '~n', None", "ROS cannot carry None: cannot marshal None"),
        ("node.set_parameter, '~n', 2**40", "ROS cannot carry 1099511627776: int exceeds XML-RPC limits"),
        ("node.subscribe, Subscription('a b'), print", "/team/second: topic 'a b': 'a b' is not a name"),
    ],
)
def test_what_ros_does_not_accept_is_said_in_one_line(remapped: PythonProcess, call: str, complaint: str) -> None:
    assert remapped.ask(f"raised({call})").startswith(f"TransportError: {complaint}")


def test_without_ros_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "rospy", None)
    with pytest.raises(MissingDependencyError, match=r"live ROS 1 needs the library rospy .*apt-get install") as caught:
        RosNode.start("node", RosCodec(lambda type_name: None))
    assert caught.value.exit_code == 4
