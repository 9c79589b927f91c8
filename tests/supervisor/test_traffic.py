"""How much flows between nodes and topics: rates by hand."""

from __future__ import annotations

import pytest

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.model import CommunicationGraph, Flow
from rqt_mrta_py.supervisor import Traffic, communication, recorded_communication

SECOND = 10**9
SCAN = Connection("/r1/scan", "sensor_msgs/LaserScan", "0" * 32, "", "/r1/driver")
NEWS = Connection("/news", "std_msgs/String", "1" * 32, "", "/r1/agent")
AGAIN = Connection("/news", "std_msgs/String", "1" * 32, "other text", "/r1/agent")


def test_a_recorded_rate_is_the_mean_from_first_message_to_last() -> None:
    graph = recorded_communication([(SCAN, 21, 5 * SECOND, 7 * SECOND), (NEWS, 1, 0, 0)])
    assert graph.flows == (
        Flow("/r1/agent", "/news", "std_msgs/String", 1, None),
        Flow("/r1/driver", "/r1/scan", "sensor_msgs/LaserScan", 21, 10.0),
    )
    assert graph.nodes == ("/r1/agent", "/r1/driver")
    assert graph.subscriptions is None


def test_connections_of_one_node_and_topic_are_joined() -> None:
    graph = recorded_communication([(NEWS, 11, 0, SECOND), (AGAIN, 6, 0, SECOND)])
    assert graph.flows == (Flow("/r1/agent", "/news", "std_msgs/String", 17, 15.0),)


def test_a_stream_counts_as_its_recording_would() -> None:
    traffic = Traffic()
    for number in range(21):
        traffic.count(SCAN, number * SECOND // 10)
    assert traffic.recorded() == recorded_communication([(SCAN, 21, 0, 2 * SECOND)])


def test_a_live_rate_is_that_of_the_last_seconds() -> None:
    traffic = Traffic(window=5.0)
    assert traffic.flows(100.0) == ()
    for second in range(1, 21):
        for _ in range(10 if second <= 10 else 0):
            traffic.count(SCAN, 0)
        (flow,) = traffic.flows(100.0 + second)
        if 6 <= second <= 10:
            assert flow.rate == pytest.approx(10.0)
        elif second == 12:
            assert flow.rate == pytest.approx(6.0)
        elif second >= 15:
            assert flow.rate == pytest.approx(0.0)
    assert flow.messages == 100


def test_a_clock_that_goes_back_begins_anew() -> None:
    traffic = Traffic()
    traffic.flows(100.0)
    traffic.count(SCAN, 0)
    assert [flow.rate for flow in traffic.flows(5.0)] == [None]
    traffic.count(SCAN, 0)
    assert [flow.rate for flow in traffic.flows(6.0)] == [1.0]


def test_nodes_and_topics_as_plain_values() -> None:
    flows = (
        Flow("", "/a", "std_msgs/String", 2, 1 / 3),
        Flow("/n", "/a", "std_msgs/Int8", 1, None),
    )
    assert communication(CommunicationGraph(flows, (("/b", "/m"),))) == {
        "schema": "rqt_mrta_py/communication/1",
        "nodes": ["/m", "/n"],
        "topics": [
            {"name": "/a", "types": ["std_msgs/Int8", "std_msgs/String"], "messages": 3, "rate": 0.333},
            {"name": "/b", "types": [], "messages": 0, "rate": None},
        ],
        "publications": [
            {"node": None, "topic": "/a", "type": "std_msgs/String", "messages": 2, "rate": 0.333},
            {"node": "/n", "topic": "/a", "type": "std_msgs/Int8", "messages": 1, "rate": None},
        ],
        "subscriptions": [{"topic": "/b", "node": "/m"}],
    }
