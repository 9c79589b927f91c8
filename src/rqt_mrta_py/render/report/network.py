"""Nodes and topics: as a picture that scales, and as a table."""

from __future__ import annotations

from typing import Dict, List, Mapping, NamedTuple, Optional, Sequence

from rqt_mrta_py.model import CommunicationGraph
from rqt_mrta_py.render.network.arrangement import Link, Measures, arranged, links_of
from rqt_mrta_py.render.network.folding import Folded, folded
from rqt_mrta_py.render.report.html import Content, Html, element, words
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.tables import counted, section, table

__all__ = ["network_section"]

_MOST_TOPICS = 40
_MOST_ROWS = 1000
_LETTER, _SMALL_LETTER, _LONGEST = 7.6, 6.3, 46
_MEASURES = Measures(topic=42.0, node=30.0, gap=12.0)
_BETWEEN, _MARGIN = 96.0, 4.0


class _Vertex(NamedTuple):
    """A node or a topic: its name, what is said of it, how wide it is [pixels]."""

    is_topic: bool
    name: str
    detail: str
    width: float


def network_section(given: ReportInput) -> Optional[Html]:
    """Show who says what; None where nobody knows."""
    graph = given.communication
    if graph is None or not graph.flows:
        return None
    small = folded(graph, [robot.id for robot in given.view.record.robots], _MOST_TOPICS)
    note = f"{counted(len(graph.nodes), 'node')}, {counted(len(graph.topics), 'topic')}"
    if graph.subscriptions is None:
        note += "; a bag does not tell who hears"
    if small.left_out:
        note += f"; the {small.left_out} topics with the fewest messages are in the table only"
    return section(
        "communication",
        "Communication",
        element(
            "div", _picture(small), class_="scroll network", tabindex=0, role="region", aria_label="Nodes and topics"
        ),
        element("details", element("summary", f"All {len(graph.flows)} publications"), _table(graph)),
        note=note,
    )


def _table(graph: CommunicationGraph) -> Html:
    rows: List[Sequence[Content]] = [
        [
            element("code", flow.topic),
            element("code", flow.node or "?"),
            element("code", flow.type),
            f"{flow.messages:,}",
            "–" if flow.rate is None else f"{flow.rate:.4g}",
        ]
        for flow in graph.flows[:_MOST_ROWS]
    ]
    more = len(graph.flows) - len(rows)
    made = table("Publications", ["topic", "node", "type", "messages", "rate [Hz]"], rows, 3)
    if more <= 0:
        return made
    return element("div", made, element("p", f"{more} more are in communication.json", class_="hint"))


def _picture(small: Folded) -> Html:
    vertices, lines = _vertices(small), links_of(small.graph)
    found = arranged([each.is_topic for each in vertices], lines, _MEASURES)
    layers, places = found.layers, found.places
    lefts: Dict[int, float] = {}
    widths: Dict[int, float] = {}
    left = _MARGIN
    for layer in layers:
        widest = max((vertices[vertex].width for vertex in layer if vertex < len(vertices)), default=0.0)
        for vertex in layer:
            lefts[vertex], widths[vertex] = left, widest
        left += widest + _BETWEEN
    width = max(left - _BETWEEN + _MARGIN, 1.0)
    height = found.bottom + 2.0 * _MARGIN
    parts: List[Html] = []
    for number, line in enumerate(lines):
        chain = found.chains[number]
        parts.append(_curve(chain, lefts, widths, places, backwards=number in found.reversed_links, line=line))
    for number, each in enumerate(vertices):
        parts.append(_box(each, lefts[number], widths[number], places[number] + _MARGIN))
    arrow = element(
        "marker",
        element("path", d="M0,0L9,4.5L0,9z"),
        id="arrow",
        viewBox="0 0 9 9",
        refX=9,
        refY="4.5",
        markerWidth=9,
        markerHeight=9,
        markerUnits="userSpaceOnUse",
        orient="auto-start-reverse",
    )
    return element(
        "svg",
        element("defs", arrow),
        *parts,
        viewBox=f"0 0 {width:.1f} {height:.1f}",
        width=f"{width:.0f}",
        height=f"{height:.0f}",
        role="img",
        aria_label="Nodes on the left lead to the topics that they publish",
    )


def _vertices(small: Folded) -> List[_Vertex]:
    vertices = [_vertex(node, "", small, is_topic=False) for node in small.graph.nodes]
    for topic in small.graph.topics:
        rate = "" if topic.rate is None else f"{topic.rate:.3g} Hz"
        detail = " · ".join(part for part in (", ".join(topic.types), rate) if part)
        vertices.append(_vertex(topic.name, detail, small, is_topic=True))
    return vertices


def _vertex(name: str, detail: str, small: Folded, *, is_topic: bool) -> _Vertex:
    count = f"  ×{small.counts[name]}" if name in small.counts else ""
    shown = words(name, _LONGEST) + count
    detail = words(detail, _LONGEST + 10)
    return _Vertex(is_topic, shown, detail, max(len(shown) * _LETTER, len(detail) * _SMALL_LETTER) + 26.0)


def _box(vertex: _Vertex, left: float, width: float, y: float) -> Html:
    height = _MEASURES.topic if vertex.is_topic else _MEASURES.node
    rect = element(
        "rect",
        x=f"{left:.1f}",
        y=f"{y - height / 2.0:.1f}",
        width=f"{width:.1f}",
        height=f"{height:.1f}",
        rx=3 if vertex.is_topic else f"{height / 2.0:.0f}",
    )
    x = f"{left + 13.0:.1f}"
    name = element("text", vertex.name, x=x, y=f"{y - 3.0 if vertex.detail else y + 4.5:.1f}")
    detail = element("text", vertex.detail, x=x, y=f"{y + 13.0:.1f}", class_="detail") if vertex.detail else None
    return element("g", rect, name, detail, class_="topic" if vertex.is_topic else "node")


def _curve(
    chain: Sequence[int],
    lefts: Dict[int, float],
    widths: Dict[int, float],
    places: Mapping[int, float],
    *,
    backwards: bool,
    line: Link,
) -> Html:
    pieces: List[str] = []
    for before, after in zip(chain, chain[1:]):
        x, y = lefts[before] + widths[before], places[before] + _MARGIN
        to_x, to_y = lefts[after], places[after] + _MARGIN
        middle = (x + to_x) / 2.0
        pieces.append(
            f"{'L' if pieces else 'M'}{x:.1f},{y:.1f}"
            f"C{middle:.1f},{y:.1f} {middle:.1f},{to_y:.1f} {to_x:.1f},{to_y:.1f}"
        )
    both = line.says and line.hears
    return element(
        "path",
        d=Html("".join(pieces)),
        class_="both" if both else "says" if line.says else "hears",
        marker_end=None if backwards and not both else "url(#arrow)",
        marker_start="url(#arrow)" if backwards or both else None,
    )
