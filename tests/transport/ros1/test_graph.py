"""What a master says of the graph, and what is said where there is none."""

from __future__ import annotations

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.ros1 import Graph
from rqt_mrta_py.transport.ros1.master import Master


def test_topics_and_nodes_of_a_graph_are_in_order() -> None:
    graph = Graph(
        types={"/b": "std_msgs/String", "/old": "std_msgs/Int8"},
        publishers={"/b": ("/talker",)},
        subscribers={"/a": ("/listener", "/recorder"), "/b": ("/listener",)},
        services={"/talker/reset": ("/talker",), "/only": ("/server",)},
    )
    assert graph.topics == ("/a", "/b")
    assert graph.nodes == ("/listener", "/recorder", "/server", "/talker")


@pytest.mark.parametrize("uri", ["localhost:11311", "udp://localhost:11311", ""])
def test_address_that_no_master_can_have_is_said_in_one_line(uri: str) -> None:
    with pytest.raises(TransportError) as caught:
        Master(uri, "/node")
    assert str(caught.value) == f"ROS_MASTER_URI {uri!r}: unsupported XML-RPC protocol; accepted is http://host:port"


def test_where_no_master_answers_it_is_said_what_to_do() -> None:
    """Port 1 is nobody's."""
    with pytest.raises(TransportError, match=r"^no ROS master answers at http://127.0.0.1:1 \(.*\); start one with"):
        Master("http://127.0.0.1:1", "/node").ask("getPid")
