"""What a node hears of a live graph."""

from __future__ import annotations

import pytest

from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess, wait_for
from tests.transport.ros1.nodes import OURS

pytestmark = pytest.mark.ros


def publish(stranger: PythonProcess, topic: str, kind: str = "STRING", latch: bool = False) -> None:
    """Let the stranger publish on a topic; its publisher is ``pub`` from then on."""
    stranger.do(f"pub = rospy.Publisher({topic!r}, {kind}, queue_size=1000, latch={latch})")


def say(stranger: PythonProcess, *texts: str) -> None:
    """Let the stranger say texts once somebody hears it."""
    stranger.until("pub.get_num_connections() > 0")
    for text in texts:
        stranger.do(f"pub.publish({text!r})")


def hear(node: PythonProcess, name: str, *topics: str) -> None:
    """Let the node hear whole topics into a list of that name."""
    node.do(f"{name} = []; node.hear(lambda topic, _type: topic in {topics!r}, {name}.append)")


def test_node_hears_a_type_that_nobody_here_knows(node: PythonProcess, stranger: PythonProcess) -> None:
    hear(node, "strange", "/strange")
    stranger.do(
        "Reading = make('strange_msgs/Reading', 'uint8 LIMIT=9\\nfloat32[] values # of a sensor\\nstring unit')"
    )
    publish(stranger, "/strange", "Reading")
    stranger.until("pub.get_num_connections() > 0")
    stranger.do("pub.publish(Reading([1.5, -2.0], 'mm'))")
    node.until("strange")
    node.do("heard = strange[0]; way = heard.connection")
    assert node.ask("[way.topic, way.type, way.caller, way.latched]") == [
        "/strange",
        "strange_msgs/Reading",
        "/stranger",
        False,
    ]
    assert node.ask("way.md5") == stranger.ask("Reading._md5sum")
    assert node.ask("way.definition") == stranger.ask("Reading._full_text")
    assert node.ask("codec.decode(way, heard.raw)") == {"values": [1.5, -2.0], "unit": "mm"}
    assert "cannot be" not in node.ask("raised(codec.connection, '/x', 'strange_msgs/Reading')")


def test_subscription_gives_fields_and_what_tokens_stand_for(node: PythonProcess, stranger: PythonProcess) -> None:
    node.do("told = []; node.subscribe(Subscription('/@robot_id@/said', 'std_msgs/String', ('data',)), told.append)")
    publish(stranger, "/robot7/said")
    say(stranger, "one", "two")
    node.until("len(told) == 2")
    assert node.ask("[[h.topic, h.robot, h.fields, h.caller, h.ordinal] for h in told]") == [
        ["/robot7/said", "robot7", {"data": "one"}, "/stranger", 0],
        ["/robot7/said", "robot7", {"data": "two"}, "/stranger", 1],
    ]


def test_publishers_come_and_go_and_are_heard_again(node: PythonProcess, stranger: PythonProcess) -> None:
    hear(node, "visits", "/visits")
    for visit in range(3):
        publish(stranger, "/visits")
        say(stranger, f"visit {visit}")
        node.until(f"len(visits) == {visit + 1}")
        stranger.do("pub.unregister()")
    assert node.ask("[codec.decode(h.connection, h.raw)['data'] for h in visits]") == ["visit 0", "visit 1", "visit 2"]


def test_type_that_changes_on_a_topic_is_heard_by_its_new_definition(
    node: PythonProcess, stranger: PythonProcess
) -> None:
    hear(node, "changing", "/changing")
    publish(stranger, "/changing")
    say(stranger, "text")
    node.until("len(changing) == 1")
    stranger.do("pub.unregister(); Int32 = make('std_msgs/Int32', 'int32 data')")
    publish(stranger, "/changing", "Int32")
    stranger.until("pub.get_num_connections() > 0")
    stranger.do("pub.publish(42)")
    node.until("len(changing) == 2")
    assert node.ask("[[h.connection.type, codec.decode(h.connection, h.raw)['data']] for h in changing]") == [
        ["std_msgs/String", "text"],
        ["std_msgs/Int32", 42],
    ]


def test_topic_is_left_when_its_new_type_is_not_wanted(
    master: MasterProcess, node: PythonProcess, stranger: PythonProcess
) -> None:
    node.do("texts_only = []; node.hear(lambda t, k: t == '/fickle' and k == 'std_msgs/String', texts_only.append)")
    publish(stranger, "/fickle")
    say(stranger, "text")
    node.until("texts_only")
    stranger.do("pub.unregister(); Int8 = make('std_msgs/Int8', 'int8 data')")
    publish(stranger, "/fickle", "Int8")
    wait_for(lambda: "/fickle" not in dict(master.ask("getSystemState")[1]))


def test_latched_message_is_heard_by_whoever_comes_late(node: PythonProcess, stranger: PythonProcess) -> None:
    publish(stranger, "/notice", latch=True)
    stranger.do("pub.publish('old'); pub.publish('on the board')")
    hear(node, "early", "/notice")
    node.until("early")
    hear(node, "late", "/notice")
    node.do("read = []; node.subscribe(Subscription('/notice', '', ('data',)), read.append)")
    assert node.ask("[early[0] == late[0]._replace(receipt_ns=early[0].receipt_ns), len(early), len(late)]") == [
        True,
        1,
        1,
    ]
    assert node.ask("[early[0].connection.latched, [h.fields for h in read]]") == [True, [{"data": "on the board"}]]


def test_one_subscription_serves_all_who_hear_a_topic(
    master: MasterProcess, node: PythonProcess, stranger: PythonProcess
) -> None:
    hear(node, "first", "/shared")
    hear(node, "second", "/shared")
    node.do("third = []; node.subscribe(Subscription('/shared', 'std_msgs/String', ('data',)), third.append)")
    publish(stranger, "/shared")
    say(stranger, "to all")
    node.until("first and second and third")
    assert stranger.ask("pub.get_num_connections()") == 1
    assert dict(master.ask("getSystemState")[1])["/shared"] == ["/node"]
    assert node.ask("first[0] is not second[0] and first[0] == second[0]")


def test_receipts_never_decrease_and_follow_the_order_of_callbacks(
    node: PythonProcess, stranger: PythonProcess
) -> None:
    node.do("order = []; node.hear(lambda t, k: t in ('/a_lot', '/more'), order.append)")
    stranger.do("pubs = [rospy.Publisher(topic, STRING, queue_size=1000) for topic in ('/a_lot', '/more')]")
    stranger.until("all(each.get_num_connections() for each in pubs)")
    stranger.do("for index in range(200): pubs[index % 2].publish(str(index))")
    node.until("len(order) == 200")
    assert node.ask("all(a.receipt_ns <= b.receipt_ns for a, b in zip(order, order[1:]))")
    assert node.ask(
        "[[int(codec.decode(h.connection, h.raw)['data']) for h in order if h.connection.topic == t] "
        "for t in ('/a_lot', '/more')]"
    ) == [list(range(0, 200, 2)), list(range(1, 200, 2))]
    assert node.ask("0 < order[0].receipt_ns / 1e9 <= order[-1].receipt_ns / 1e9 <= node.now() < time.time() + 0.001")


def test_hearer_may_bring_receipts_of_its_own(node: PythonProcess, stranger: PythonProcess) -> None:
    node.do("own = []; node.hear(lambda t, k: t == '/own', own.append, receipts=lambda: 17)")
    publish(stranger, "/own")
    say(stranger, "x")
    node.until("own")
    assert node.ask("own[0].receipt_ns") == 17


def test_bytes_that_do_not_fit_are_reported_once_and_survived(node: PythonProcess, stranger: PythonProcess) -> None:
    node.do("good = []; node.subscribe(Subscription('/torn', 'std_msgs/String', ('data',)), good.append)")
    publish(stranger, "/torn")
    stranger.do("class Torn(type(STRING())):\n    def serialize(self, buffer): buffer.write(b'\\x09\\0\\0\\0abc')")
    stranger.until("pub.get_num_connections() > 0")
    stranger.do("pub.publish(Torn()); pub.publish(Torn()); pub.publish('whole')")
    node.until("good")
    assert node.ask("[h.fields for h in good]") == [{"data": "whole"}]
    complaints = node.ask("[text for text in lines.texts if '/torn' in text]")
    assert len(complaints) == 1
    assert "std_msgs/String" in complaints[0]


def test_definition_that_is_not_the_one_known_here_is_reported_with_the_difference(
    node: PythonProcess, stranger: PythonProcess
) -> None:
    node.do("misfits = []; node.on_misfit(misfits.append)")
    hear(node, "altered", "/altered")
    stranger.do("Altered = make('geometry_msgs/Vector3', 'float64 x # to the front\\nfloat32 y\\nfloat64 z')")
    publish(stranger, "/altered", "Altered")
    stranger.until("pub.get_num_connections() > 0")
    stranger.do("pub.publish(1, 2, 3); pub.publish(1, 2, 3)")
    node.until("len(altered) == 2")
    assert node.ask("codec.decode(altered[0].connection, altered[0].raw)") == {"x": 1.0, "y": 2.0, "z": 3.0}
    node.until("[m for m in misfits if m.topic == '/altered']")
    ((caller, text, difference),) = node.ask(
        "[[m.caller, m.text, m.difference] for m in misfits if m.topic == '/altered']"
    )
    assert caller == "/stranger"
    assert text == (
        "/stranger publishes /altered as geometry_msgs/Vector3 with md5 "
        f"{stranger.ask('Altered._md5sum')}; known here is geometry_msgs/Vector3 with md5 "
        "4a842b65f413084dc2b10fb484ea7f17; it is read as its publisher defines it"
    )
    assert difference.split("\n") == [
        "--- known here",
        "+++ /stranger",
        "@@ -2,3 +2,3 @@",
        " float64 x",
        "-float64 y",
        "+float32 y",
        " float64 z",
    ]


def test_publishers_that_disagree_about_a_topic_are_reported(node: PythonProcess, stranger: PythonProcess) -> None:
    node.do("quarrels = []; node.on_misfit(quarrels.append)")
    hear(node, "disputed", "/disputed")
    node.do("node.publish(Outgoing('/disputed', 'std_msgs/String', {'data': 'text'}, latched=True), 0.0)")
    node.until("disputed")
    publish(stranger, "/disputed", "make('std_msgs/Bool', 'bool data')", latch=True)
    stranger.do("pub.publish(True)")
    node.until("len(disputed) == 2")
    (text,) = node.ask("[m.text for m in quarrels if m.topic == '/disputed']")
    assert text == (
        "/stranger publishes /disputed as std_msgs/Bool with md5 8b94c1b53db61fb6aed406028ad6332a, "
        "/node as std_msgs/String with md5 992ce8a1687cec8c8bd883ec73ca41d1"
    )


@pytest.mark.parametrize(
    "failing",
    [
        "node.hear(lambda t, k: t == '/poison', lambda heard: 1 / 0)",
        "node.hear(lambda t, k: t == '/fresh' and 1 / 0, print); node.advertise('/fresh', 'std_msgs/String')",
    ],
    ids=["told of a message", "asked what is wanted"],
)
def test_what_a_callback_raises_ends_the_node(master: MasterProcess, stranger: PythonProcess, failing: str) -> None:
    publish(stranger, "/poison", latch=True)
    stranger.do("pub.publish('x')")
    with PythonProcess(master.environment) as fragile:
        fragile.do(OURS + "node = RosNode.start('fragile', codec); ended = []")
        fragile.do("node.on_shutdown(lambda: ended.append(node.is_shut_down))")
        fragile.do(failing)
        assert fragile.ask("raised(node.wait, 10)") == "ZeroDivisionError: division by zero"
        assert fragile.ask("ended") == [True]


def test_connection_that_breaks_is_made_again_while_its_publisher_is_there(
    node: PythonProcess, stranger: PythonProcess
) -> None:
    """The master does not tell, for it does not know; rospy by itself would never hear that publisher again."""
    hear(node, "broken", "/broken")
    publish(stranger, "/broken")
    say(stranger, "before")
    node.until("broken")
    stranger.do("for connection in pub.impl.connections: connection.close()")
    assert stranger.ask("pub.get_num_connections()") == 0
    say(stranger, "after")
    node.until("len(broken) == 2")


def test_topic_with_an_illegal_name_is_said_once_and_heard(node: PythonProcess, stranger: PythonProcess) -> None:
    hear(node, "illegal", "/robot-1/pose")
    stranger.do("import warnings; warnings.simplefilter('ignore')")
    publish(stranger, "/robot-1/pose")
    say(stranger, "meow")
    node.until("illegal")
    assert node.ask("[text for text in lines.texts if 'robot-1' in text]") == [
        "topic='/robot-1/pose' is no name that ROS accepts; it is heard all the same"
    ]


def test_plugin_that_uses_rospy_by_itself_hears_as_ever(node: PythonProcess, stranger: PythonProcess) -> None:
    node.do("import rospy, rosgraph_msgs.msg; theirs = []")
    node.do("rospy.Subscriber('/for_plugin', rosgraph_msgs.msg.Clock, theirs.append)")
    publish(stranger, "/for_plugin", "make('rosgraph_msgs/Clock', 'time clock')", latch=True)
    stranger.do("pub.publish(rospy.Time(3, 0))")
    node.until("theirs")
    assert node.ask("theirs[0].clock.secs") == 3


def test_large_messages_arrive_whole_among_small_ones(node: PythonProcess, stranger: PythonProcess) -> None:
    hear(node, "sizes", "/sizes")
    publish(stranger, "/sizes")
    stranger.until("pub.get_num_connections() > 0")
    stranger.do("for size in (0, 1, 65527, 65528, 65529, 3_000_000, 2, 200_000): pub.publish('x' * size)")
    node.until("len(sizes) == 8")
    assert node.ask("[len(h.raw) - 4 for h in sizes]") == [0, 1, 65527, 65528, 65529, 3_000_000, 2, 200_000]
    assert node.ask("sizes[5].raw[4:] == b'x' * 3_000_000")
