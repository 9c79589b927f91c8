"""Nodes and topics of a running system: what its master knows, with what was heard."""

from __future__ import annotations

from typing import Dict, Iterable, Set, Tuple

from rqt_mrta_py.model import CommunicationGraph, Flow
from rqt_mrta_py.transport.ros1 import Graph

__all__ = ["live_graph"]


def live_graph(known: Graph, heard: Iterable[Flow], leave_out: str) -> CommunicationGraph:
    """Join what a master knows with what flows.

    Args:
        known: nodes and topics, who publishes and who subscribes.
        heard: what flows; nodes and topics that have gone are left out.
        leave_out: the node that looks, whose own ears and mouths nobody wants to see.

    Returns:
        All that is published or subscribed to now; what is not heard has no rate.
    """
    speaking: Set[Tuple[str, str]] = {
        (topic, node) for topic, nodes in known.publishers.items() for node in nodes if node != leave_out
    }
    flows: Dict[Tuple[str, str, str], Flow] = {}
    met: Set[Tuple[str, str]] = set()
    for flow in heard:
        if (flow.topic, flow.node) in speaking:
            flows[flow.topic, flow.node, flow.type] = flow
            met.add((flow.topic, flow.node))
    for topic, node in speaking - met:
        type_name = known.types.get(topic, "*")
        flows[topic, node, type_name] = Flow(node, topic, type_name)
    subscriptions = {(topic, node) for topic, nodes in known.subscribers.items() for node in nodes if node != leave_out}
    return CommunicationGraph(tuple(flows[key] for key in sorted(flows)), tuple(sorted(subscriptions)))
