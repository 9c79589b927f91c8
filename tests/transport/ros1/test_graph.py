"""What a master says of the graph, as a value."""

from __future__ import annotations

from rqt_mrta_py.transport.ros1 import Graph


def test_topics_and_nodes_of_a_graph_are_in_order() -> None:
    graph = Graph(
        types={"/b": "std_msgs/String", "/old": "std_msgs/Int8"},
        publishers={"/b": ("/talker",)},
        subscribers={"/a": ("/listener", "/recorder"), "/b": ("/listener",)},
        services={"/talker/reset": ("/talker",), "/only": ("/server",)},
    )
    assert graph.topics == ("/a", "/b")
    assert graph.nodes == ("/listener", "/recorder", "/server", "/talker")
