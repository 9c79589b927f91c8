"""Nodes and topics in layers: hand-made graphs whose layers, orders and places are known."""

from __future__ import annotations

from itertools import permutations
from typing import List, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.model import CommunicationGraph, Flow
from rqt_mrta_py.render import draw_communication
from rqt_mrta_py.render.network.folding import folded
from rqt_mrta_py.render.network.layering import layered
from rqt_mrta_py.render.network.ordering import crossings, ordered
from rqt_mrta_py.render.network.placing import heights

COMMUNICATION = "/alliance/inter_robot_communication"


def alliance(robots: int) -> CommunicationGraph:
    """Three robots of the dissertation's figure of rqt_graph, or more: all hear what each says."""
    flows = []
    hears = [(COMMUNICATION, "/supervisor")]
    for number in range(1, robots + 1):
        node = f"/robot{number}/alliance/high_level"
        flows.append(Flow(node, COMMUNICATION, "alliance_msgs/InterRobotCommunication", 20, 2.0))
        flows.append(Flow(node, f"/robot{number}/motivation", "alliance_msgs/Motivation", 50, 5.0))
        hears.append((COMMUNICATION, node))
    return CommunicationGraph(tuple(sorted(flows, key=lambda flow: (flow.topic, flow.node))), tuple(sorted(hears)))


def test_a_chain_takes_a_layer_for_each_vertex() -> None:
    found = layered(3, [(2, 0), (0, 1)])
    assert found.layers == [[2], [0], [1]]
    assert found.chains == [[2, 0], [0, 1]]
    assert found.reversed_edges == set()


def test_a_long_edge_passes_the_layers_between() -> None:
    found = layered(3, [(0, 1), (1, 2), (0, 2)])
    assert found.layers == [[0], [1, 3], [2]]
    assert found.chains[2] == [0, 3, 2]


def test_a_cycle_is_broken_at_one_edge() -> None:
    found = layered(3, [(0, 1), (1, 2), (2, 0)])
    assert len(found.reversed_edges) == 1
    assert sorted(len(layer) for layer in found.layers) == [1, 1, 2]


def test_who_only_speaks_stands_right_before_who_hears() -> None:
    # 0 -> 1 -> 2 -> 3, and 4 -> 3: without the rule 4 would stand far left, with a long edge.
    found = layered(5, [(0, 1), (1, 2), (2, 3), (4, 3)])
    assert found.layers == [[0], [1], [2, 4], [3]]


@settings(max_examples=60, deadline=None)
@given(
    edges=st.lists(st.tuples(st.integers(0, 7), st.integers(0, 7)).filter(lambda pair: pair[0] != pair[1]), max_size=20)
)
def test_every_edge_leads_layer_by_layer_and_every_vertex_stands_once(edges: List[Tuple[int, int]]) -> None:
    edges = sorted(set(edges))
    found = layered(8, edges)
    level = {vertex: number for number, layer in enumerate(found.layers) for vertex in layer}
    assert len(level) == sum(len(layer) for layer in found.layers)
    assert set(range(8)) <= set(level)
    for number, ((start, end), chain) in enumerate(zip(edges, found.chains)):
        ends = [end, start] if number in found.reversed_edges else [start, end]
        assert [chain[0], chain[-1]] == ends
        assert [level[vertex] for vertex in chain] == list(range(level[chain[0]], level[chain[-1]] + 1))
        assert len(chain) > 1
    # Eades, Lin and Smyth prove that at most half of the edges, less a sixth of the vertices, are reversed.
    assert len(found.reversed_edges) <= len(edges) / 2
    order = ordered(found.layers, found.chains)
    assert [sorted(layer) for layer in order] == [sorted(layer) for layer in found.layers]


def test_crossings_are_counted() -> None:
    assert crossings([[0, 1], [2, 3]], [(0, 2), (1, 3)]) == 0
    assert crossings([[0, 1], [2, 3]], [(0, 3), (1, 2)]) == 1
    assert crossings([[0, 1, 2], [3, 4, 5]], [(0, 5), (1, 4), (2, 3)]) == 3
    assert crossings([[0, 1], [2]], [(0, 2), (1, 2)]) == 0


def test_edges_that_need_not_cross_do_not() -> None:
    chains = [[0, 5], [1, 4], [2, 3]]
    for first in permutations([0, 1, 2]):
        found = ordered([list(first), [3, 4, 5]], chains)
        assert crossings(found, [(a, b) for a, b in chains]) == 0


def test_one_stands_in_the_middle_of_those_it_speaks_to() -> None:
    places = heights([[0], [1, 2, 3]], [[0, 1], [0, 2], [0, 3]], {0: 20.0, 1: 40.0, 2: 40.0, 3: 40.0}, 10.0)
    assert places == pytest.approx({1: 20.0, 2: 70.0, 3: 120.0, 0: 70.0})


@settings(max_examples=40, deadline=None)
@given(
    pairs=st.lists(st.tuples(st.integers(0, 4), st.integers(5, 9)), max_size=15),
    sizes=st.lists(st.floats(1.0, 50.0), min_size=10, max_size=10),
)
def test_nobody_stands_upon_another(pairs: List[Tuple[int, int]], sizes: List[float]) -> None:
    layers = [[0, 1, 2, 3, 4], [5, 6, 7, 8, 9]]
    places = heights(layers, [list(pair) for pair in pairs], dict(enumerate(sizes)), 8.0)
    for layer in layers:
        for above, below in zip(layer, layer[1:]):
            assert places[below] - places[above] >= (sizes[above] + sizes[below]) / 2.0 + 8.0 - 1e-6
    assert min(places[vertex] - sizes[vertex] / 2.0 for vertex in places) == pytest.approx(0.0)


def test_small_teams_are_drawn_robot_by_robot() -> None:
    assert folded(alliance(3), ["robot1", "robot2", "robot3"], most=4).counts == {}


def test_large_teams_are_drawn_once_with_mean_rates() -> None:
    found = folded(alliance(50), [f"robot{number}" for number in range(1, 51)], most=10)
    assert found.counts == {"/<robot>/alliance/high_level": 50, "/<robot>/motivation": 50}
    topics = {topic.name: topic for topic in found.graph.topics}
    assert set(topics) == {COMMUNICATION, "/<robot>/motivation"}
    assert topics["/<robot>/motivation"].rate == pytest.approx(5.0)
    assert topics[COMMUNICATION].rate == pytest.approx(100.0)
    assert topics[COMMUNICATION].messages == 1000
    assert found.graph.subscriptions == (
        (COMMUNICATION, "/<robot>/alliance/high_level"),
        (COMMUNICATION, "/supervisor"),
    )


def test_what_does_not_fit_even_so_is_counted() -> None:
    flows = tuple(Flow("/a", f"/topic{number:02d}", "std_msgs/String", number) for number in range(30))
    found = folded(CommunicationGraph(flows), [], most=10)
    assert [topic.name for topic in found.graph.topics] == [f"/topic{number}" for number in range(20, 30)]
    assert found.left_out == 20


def test_equal_graphs_give_equal_pictures_and_others_do_not() -> None:
    one = draw_communication(alliance(3), ["robot1", "robot2", "robot3"])
    assert one.dtype == np.uint8
    assert np.array_equal(one, draw_communication(alliance(3), ["robot1", "robot2", "robot3"]))
    other = draw_communication(CommunicationGraph(alliance(3).flows), ["robot1", "robot2", "robot3"])
    assert one.shape != other.shape or not np.array_equal(one, other)


@pytest.mark.parametrize(
    "graph",
    [
        CommunicationGraph(()),
        CommunicationGraph((), ()),
        CommunicationGraph((Flow("", "/a", "std_msgs/String"),)),
        CommunicationGraph((Flow("/n", "/a" * 300, "std_msgs/String"), Flow("/n", "/a" * 300, "std_msgs/Int8"))),
        CommunicationGraph((Flow("/n", "/\u0430\n\ud800", "x/Y", 3, 1e12),), (("/nowhere", "/n"),)),
    ],
    ids=["nothing", "nobody", "unknown node", "long name and two types", "hostile name"],
)
def test_whatever_a_bag_tells_is_drawn(graph: CommunicationGraph) -> None:
    assert draw_communication(graph).size > 0
