"""What a node publishes, as plain ROS nodes hear it."""

from __future__ import annotations

import pytest

from tests.ros_process import PythonProcess

pytestmark = pytest.mark.ros


def hear(stranger: PythonProcess, name: str, topic: str, module: str, kind: str) -> None:
    """Let the stranger hear a topic with the class that ROS generated for its type."""
    pytest.importorskip(module)
    stranger.do(f"from {module}.msg import {kind}")
    stranger.do(f"{name} = []; rospy.Subscriber({topic!r}, {kind}, {name}.append)")


def test_stranger_with_generated_classes_hears_what_is_published(node: PythonProcess, stranger: PythonProcess) -> None:
    hear(stranger, "poses", "/robot1/pose", "geometry_msgs", "PoseStamped")
    node.do("node.advertise('/robot1/pose', 'geometry_msgs/PoseStamped')")
    node.until("node._mouths.mouth('/robot1/pose', 'geometry_msgs/PoseStamped', False).is_heard")
    fields = "{'header': {'stamp': 2.5, 'frame_id': 'map'}, 'pose': {'position': {'x': 1.5}}}"
    node.do(f"for _ in range(3): node.publish(Outgoing('/robot1/pose', 'geometry_msgs/PoseStamped', {fields}), 0.0)")
    stranger.until("len(poses) == 3")
    stranger.do("heads = [p.header for p in poses]")
    assert stranger.ask("[[h.seq, h.stamp.secs, h.stamp.nsecs, h.frame_id] for h in heads]") == [
        [seq, 2, 500000000, "map"] for seq in (1, 2, 3)
    ]
    assert stranger.ask("poses[0].pose.position.x") == 1.5


def test_header_number_that_is_given_stays(node: PythonProcess, stranger: PythonProcess) -> None:
    hear(stranger, "numbered", "/numbered", "geometry_msgs", "PointStamped")
    node.do("node.publish(Outgoing('/numbered', 'geometry_msgs/PointStamped', {'header': {'seq': 77}}, True), 0.0)")
    stranger.until("numbered")
    assert stranger.ask("numbered[0].header.seq") == 77


def test_latched_message_is_there_for_who_comes_late(node: PythonProcess, stranger: PythonProcess) -> None:
    node.do(
        "for text in ('first', 'last'): node.publish(Outgoing('/state', 'std_msgs/String', {'data': text}, True), 0.0)"
    )
    hear(stranger, "states", "/state", "std_msgs", "String")
    stranger.until("states")
    assert stranger.ask("[[s.data, s._connection_header['latching']] for s in states]") == [["last", "1"]]


def test_rows_are_published_each_on_its_topic(node: PythonProcess, stranger: PythonProcess) -> None:
    for robot in ("robot1", "robot2"):
        hear(stranger, f"of_{robot}", f"/{robot}/point", "geometry_msgs", "PointStamped")
    rows = "OutgoingRows(('/robot1/point', '/robot2/point', '/robot1/point'), 'geometry_msgs/PointStamped', columns)"
    node.do("import numpy as np; columns = {'header/stamp': 1.25, 'point/x': np.array([1.0, 2.0, 3.0])}")
    node.do("for topic in ('/robot1/point', '/robot2/point'): node.advertise(topic, 'geometry_msgs/PointStamped')")
    node.until("all(m.is_heard for t, m in node._mouths._by_topic.items() if t.endswith('/point'))")
    node.do(f"node.publish({rows}, 0.0)")
    stranger.until("len(of_robot1) == 2 and len(of_robot2) == 1")
    assert stranger.ask("[[p.header.seq, p.header.stamp.to_sec(), p.point.x] for p in of_robot1 + of_robot2]") == [
        [1, 1.25, 1.0],
        [2, 1.25, 3.0],
        [1, 1.25, 2.0],
    ]


def test_what_is_published_here_is_heard_here(node: PythonProcess) -> None:
    node.do("echo = []; node.hear(lambda t, k: t == '/echo', echo.append)")
    node.do("node.publish(Outgoing('/echo', 'std_msgs/String', {'data': 'hello'}, True), 0.0)")
    node.until("echo")
    assert node.ask("[echo[0].connection.caller, codec.decode(echo[0].connection, echo[0].raw)]") == [
        "/node",
        {"data": "hello"},
    ]


def test_what_nobody_hears_is_not_even_written(node: PythonProcess) -> None:
    """A message that does not fit is therefore noticed only where somebody hears it."""
    wrong = "Outgoing('/unheard', 'std_msgs/String', {'nothing': 1}, %s)"
    node.do(f"node.publish({wrong % False}, 0.0)")
    assert node.ask(f"raised(node.publish, {wrong % True}, 0.0)").startswith("TransportError: /node on /unheard: ")


@pytest.mark.parametrize(
    ("said", "complaint"),
    [
        (
            "Outgoing('/typed', 'std_msgs/Int32', {})",
            "/node on /typed: it publishes std_msgs/String there already, not std_msgs/Int32; "
            "a ROS node publishes one type on a topic",
        ),
        (
            "Outgoing('/9 lives', 'std_msgs/Int32', {})",
            "/node: topic '/9 lives': '/9 lives' is not a name that ROS accepts: "
            "letters, digits, _ and /, a letter, / or ~ first",
        ),
        (
            "Outgoing('/x', 'no_msgs/Such', {})",
            "/node on /x: message type 'no_msgs/Such' is not known: it is no standard type, "
            "and no package on the search path has no_msgs/msg/Such.msg",
        ),
    ],
)
def test_what_cannot_be_published_is_said_in_one_line(node: PythonProcess, said: str, complaint: str) -> None:
    node.do("node.advertise('/typed', 'std_msgs/String')")
    assert node.ask(f"raised(node.publish, {said}, 0.0)") == f"TransportError: {complaint}"


def test_subscriber_that_is_refused_is_reported_with_the_difference(
    node: PythonProcess, stranger: PythonProcess
) -> None:
    node.do("refused = []; node.on_misfit(refused.append); node.advertise('/refusing', 'std_msgs/String')")
    stranger.do("Odd = make('std_msgs/String', 'uint8 data'); rospy.Subscriber('/refusing', Odd, print)")
    node.until("[m for m in refused if m.topic == '/refusing']")
    ((caller, text, difference),) = node.ask(
        "[[m.caller, m.text, m.difference] for m in refused if m.topic == '/refusing']"
    )
    assert caller == "/stranger"
    assert text == (
        f"/stranger wants /refusing as std_msgs/String with md5 {stranger.ask('Odd._md5sum')}; it is published here "
        "as std_msgs/String with md5 992ce8a1687cec8c8bd883ec73ca41d1, and /stranger does not hear it"
    )
    assert difference.split("\n")[2:] == ["@@ -1,2 +1,2 @@", " MSG: std_msgs/String", "-string data", "+uint8 data"]
    assert node.ask("sorted(node.refused('/refusing'))") == ["/stranger"]


def test_subscriber_that_is_refused_holds_up_no_first_message(node: PythonProcess, stranger: PythonProcess) -> None:
    """The master lists it among those who want to hear, and it will never be connected."""
    stranger.do("rospy.Subscriber('/refused/first', make('std_msgs/String', 'uint8 data'), print)")
    node.do("from rqt_mrta_py.app.live import ways; ways._PATIENCE = 60.0; opened = ways.Ways(node, [], lambda: False)")
    node.do("opened.open([('/refused/first', 'std_msgs/String', False)])")
    assert node.ask("sorted(node.refused('/refused/first'))") == ["/stranger"]
    assert not node.ask("[line for line in lines.texts if 'nobody waits any longer' in line]")


def test_lines_of_the_log_go_onto_rosout(node: PythonProcess, stranger: PythonProcess) -> None:
    hear(stranger, "log", "/rosout", "rosgraph_msgs", "Log")
    node.until("node._mouths._by_topic['/rosout'].is_heard")
    stranger.until(
        "any(c.callerid_pub == '/node' for c in rospy.impl.registration.get_topic_manager()"
        ".get_subscriber_impl('/rosout').connections)"
    )
    node.do("node.log(logging.WARNING, 'robot1 is silent [incident 3]')")
    stranger.until("[line for line in log if line.msg == 'robot1 is silent [incident 3]']")
    assert stranger.ask("[[line.name, line.level] for line in log if 'incident 3' in line.msg]") == [["/node", 4]]
    assert node.ask("'robot1 is silent [incident 3]' in lines.texts")
