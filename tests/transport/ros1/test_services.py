"""Services, served and called without generated classes."""

from __future__ import annotations

import importlib
from typing import Any

import pytest
import yaml

from rqt_mrta_py.transport import RosCodec
from rqt_mrta_py.transport.ros1.services import ServiceType
from tests.ros_master import MasterProcess, say
from tests.ros_process import PythonProcess, require_live_ros
from tests.transport.ros1.nodes import texts

pytestmark = pytest.mark.ros


@pytest.mark.parametrize("name", ["GetLoggers", "SetLoggerLevel"])
def test_service_md5_is_that_of_the_generated_class(name: str) -> None:
    require_live_ros()
    generated: Any = getattr(importlib.import_module("roscpp.srv"), name)
    assert ServiceType.find(f"roscpp/{name}", RosCodec(texts)).md5 == generated._md5sum


def test_stranger_with_generated_classes_is_answered(node: PythonProcess, stranger: PythonProcess) -> None:
    node.do("asked = []; node.serve('~level', 'roscpp/SetLoggerLevel', lambda fields: asked.append(fields) or {})")
    stranger.do("from roscpp.srv import SetLoggerLevel; rospy.wait_for_service('/node/level', 5)")
    stranger.do("rospy.ServiceProxy('/node/level', SetLoggerLevel)('loud', 'warn')")
    assert node.ask("asked") == [{"logger": "loud", "level": "warn"}]


def test_command_line_of_ros_is_answered(master: MasterProcess, node: PythonProcess, stranger: PythonProcess) -> None:
    node.do("node.serve('/names', 'roscpp/GetLoggers', lambda _: {'loggers': [{'name': 'a', 'level': 'info'}]})")
    stranger.do("rospy.wait_for_service('/names', 5)")
    answer = yaml.safe_load(say("rosservice", "call", "/names", environment=master.environment))
    assert answer == {"loggers": [{"name": "a", "level": "info"}]}


def test_service_of_a_stranger_is_called(node: PythonProcess, stranger: PythonProcess) -> None:
    answer = node.ask("node.call('/stranger/get_loggers', 'roscpp/GetLoggers', {}, 5.0)")
    assert {"name": "rospy.topics", "level": "INFO"} in answer["loggers"]


def test_service_is_waited_for(node: PythonProcess) -> None:
    node.do(
        "import threading; threading.Timer(0.3, node.serve, ('/soon', 'calls/Sum', lambda f: {'sum': f['a'] + f['b']}))"
        ".start()"
    )
    assert node.ask("node.call('/soon', 'calls/Sum', {'a': 40, 'b': 2}, 5.0)") == {"sum": 42}


def test_refusal_comes_as_its_one_line(node: PythonProcess) -> None:
    node.do("def refuse(fields): raise TransportError('task t9: not known; there are: t1, t2')")
    node.do("node.serve('/refuse', 'calls/Sum', refuse)")
    assert node.ask("raised(node.call, '/refuse', 'calls/Sum', {}, 5.0)") == (
        "TransportError: service /refuse: service cannot process request: task t9: not known; there are: t1, t2"
    )


def test_handler_that_fails_is_logged_and_survived(node: PythonProcess) -> None:
    node.do("node.serve('/failing', 'calls/Sum', lambda fields: {'sum': 1 // fields['a']})")
    assert node.ask("raised(node.call, '/failing', 'calls/Sum', {}, 5.0)") == (
        "TransportError: service /failing: error processing request: integer division or modulo by zero"
    )
    assert node.ask("'service=/failing failed' in lines.texts")
    assert node.ask("node.call('/failing', 'calls/Sum', {'a': 1}, 5.0)") == {"sum": 1}


@pytest.mark.parametrize(
    ("asked", "complaint"),
    [
        ("'/nowhere', 'calls/Sum', {}, 0.2", "service /nowhere: nobody serves it (no provider); 0.2 s were waited"),
        ("'/refuse', 'calls/Sum', {'c': 1}, 0.2", "calls/SumRequest: "),
        ("'/refuse', 'calls/None', {}, 0.2", "message type 'calls/NoneRequest' is not known"),
        (
            "'/stranger/get_loggers', 'calls/Sum', {}, 2",
            "service /stranger/get_loggers: refused: request from [/node]: md5sums do not match",
        ),
    ],
)
def test_call_that_cannot_be_answered_is_said_in_one_line(
    node: PythonProcess, stranger: PythonProcess, asked: str, complaint: str
) -> None:
    said = node.ask(f"raised(node.call, {asked})")
    assert said.startswith(f"TransportError: {complaint}")
    assert "\n" not in said


def test_silent_service_is_not_waited_for_longer_than_asked(node: PythonProcess, stranger: PythonProcess) -> None:
    node.do("node.serve('/slow', 'calls/Sum', lambda fields: time.sleep(1.5) or {})")
    # Waited for, it would have answered.
    node.do("said = raised(node.call, '/slow', 'calls/Sum', {}, 0.3)")
    assert node.ask("said").startswith("TransportError: service /slow: no answer from rosrpc://127.0.0.1:")


def test_name_is_served_once(node: PythonProcess) -> None:
    node.do("node.serve('/once', 'calls/Sum', dict)")
    assert node.ask("raised(node.serve, '/once', 'calls/Sum', dict)").startswith("TransportError: service /once: ")
