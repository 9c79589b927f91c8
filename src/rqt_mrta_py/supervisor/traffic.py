"""Traffic: how much flows between nodes and topics, counted from a stream or read off a bag's index."""

from __future__ import annotations

from collections import deque
from typing import Any, Deque, Dict, Iterable, List, NamedTuple, Optional, Tuple

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.model import CommunicationGraph, Flow

__all__ = ["Traffic", "communication", "recorded_communication"]

SCHEMA = "rqt_mrta_py/communication/1"

_NS = 1_000_000_000


class _Mark(NamedTuple):
    """How many messages of each connection had come by some moment [s]."""

    time: float
    counts: Dict[Connection, int]


class Traffic:
    """Counts the messages of connections.

    Args:
        window: over which is told how many come a second just now [s].
    """

    def __init__(self, window: float = 5.0) -> None:
        self._window = window
        # Number of messages, receipt of the first and of the last one.
        self._spans: Dict[Connection, List[int]] = {}
        self._marks: Deque[_Mark] = deque()

    def count(self, connection: Connection, receipt_ns: int) -> None:
        """Take note of one message."""
        span = self._spans.get(connection)
        if span is None:
            self._spans[connection] = [1, receipt_ns, receipt_ns]
        else:
            span[0] += 1
            span[2] = receipt_ns

    def recorded(self) -> CommunicationGraph:
        """Say what flowed so far, as a recording of it would."""
        return recorded_communication((each, count, start, end) for each, (count, start, end) in self._spans.items())

    def flows(self, now: float) -> Tuple[Flow, ...]:
        """Say what flows; to be asked now and again, for a rate is what came between two such moments.

        Args:
            now: on any clock that runs as long as rates are wanted for [s].
        """
        marks = self._marks
        if marks and now < marks[-1].time:
            marks.clear()
        while len(marks) > 1 and marks[1].time <= now - self._window:
            marks.popleft()
        since = marks[0] if marks and now > marks[0].time else None
        flows = []
        for connection, (count, _, _) in self._spans.items():
            rate = None
            if since is not None:
                rate = (count - since.counts.get(connection, 0)) / (now - since.time)
            flows.append(Flow(connection.caller, connection.topic, connection.type, count, rate))
        if not marks or now - marks[-1].time >= self._window / 10.0:
            marks.append(_Mark(now, {connection: span[0] for connection, span in self._spans.items()}))
        return _joined(flows)


def recorded_communication(spans: Iterable[Tuple[Connection, int, int, int]]) -> CommunicationGraph:
    """Say what flowed in a recording, where nobody knows who heard it.

    Args:
        spans: connections, each with its number of messages and the receipt of its first and last one [ns].

    Returns:
        The graph; a rate is the mean from the first message of a connection to its last.
    """
    flows = []
    for connection, count, start_ns, end_ns in spans:
        length = (end_ns - start_ns) / _NS
        rate = (count - 1) / length if count > 1 and length > 0.0 else None
        flows.append(Flow(connection.caller, connection.topic, connection.type, count, rate))
    return CommunicationGraph(_joined(flows))


def communication(graph: CommunicationGraph) -> Dict[str, Any]:
    """Describe nodes and topics in plain values.

    Returns:
        The content of ``communication.json``, keys in their documented order; rates in hertz, rounded to thousandths;
        None where unknown.
    """
    subscriptions: Optional[List[Dict[str, Any]]] = None
    if graph.subscriptions is not None:
        subscriptions = [{"topic": topic, "node": node} for topic, node in graph.subscriptions]
    return {
        "schema": SCHEMA,
        "nodes": list(graph.nodes),
        "topics": [
            {"name": topic.name, "types": list(topic.types), "messages": topic.messages, "rate": _rounded(topic.rate)}
            for topic in graph.topics
        ],
        "publications": [
            {
                "node": flow.node or None,
                "topic": flow.topic,
                "type": flow.type,
                "messages": flow.messages,
                "rate": _rounded(flow.rate),
            }
            for flow in graph.flows
        ],
        "subscriptions": subscriptions,
    }


def _joined(flows: Iterable[Flow]) -> Tuple[Flow, ...]:
    """Join what a node says of one type on one topic over several connections, and sort."""
    joined: Dict[Tuple[str, str, str], Flow] = {}
    for flow in flows:
        key = (flow.topic, flow.node, flow.type)
        other = joined.get(key)
        if other is None:
            joined[key] = flow
            continue
        rates = [rate for rate in (other.rate, flow.rate) if rate is not None]
        joined[key] = flow._replace(messages=flow.messages + other.messages, rate=sum(rates) if rates else None)
    return tuple(joined[key] for key in sorted(joined))


def _rounded(rate: Optional[float]) -> Optional[float]:
    return None if rate is None else round(rate, 3)
