"""Nodes and topics in one picture: who publishes what, who hears it, with types and rates."""

from __future__ import annotations

from typing import TYPE_CHECKING, Dict, List, Mapping, NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.model import CommunicationGraph
from rqt_mrta_py.render.canvas import Box, Canvas, Point
from rqt_mrta_py.render.network.arrangement import Link, Measures, arranged, links_of
from rqt_mrta_py.render.network.folding import Folded, folded
from rqt_mrta_py.render.palette import ACCENT, FRAME, HAPPENING, INK, MUTED, PAGE, RED, TRAIL, WHITE, Colour
from rqt_mrta_py.render.text import Style, fit, shorten, text_width

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["draw_communication"]

_MOST_TOPICS = 40
_NAME, _DETAIL, _NODE = Style(14, bold=True), Style(12), Style(14, bold=True)
_TITLE, _WORDS = Style(20, bold=True), Style(13)
_WIDEST = 440.0
_MEASURES = Measures(topic=44.0, node=32.0, gap=14.0)
_BETWEEN, _MARGIN, _HEAD, _FOOT = 110.0, 28.0, 58.0, 44.0
_LEAST_WIDTH, _LEAST_HEIGHT = 760.0, 200.0
_ARROW = 9.0
_BENDS = 24


class _Vertex(NamedTuple):
    """A node or a topic on the picture."""

    is_topic: bool
    name: str
    detail: str
    width: float
    warns: bool


def draw_communication(graph: CommunicationGraph, robots: Sequence[str] = ()) -> NDArray[np.uint8]:
    """Draw nodes and topics in layers, from those who speak to those who hear.

    Args:
        graph: what flows; who hears it may be unknown.
        robots: ids of the robots: of a large team, what all say in their own namespaces is drawn once.

    Returns:
        A picture (height, width, 3), blue, green, red, as large as it needs to be; equal for equal graphs.

    Raises:
        MissingDependencyError: Pillow or OpenCV is not installed.
    """
    small = folded(graph, robots, _MOST_TOPICS)
    vertices, edges = _vertices(small), links_of(small.graph)
    found = arranged([each.is_topic for each in vertices], edges, _MEASURES)
    layers, sizes, places = found.layers, found.sizes, found.places
    columns = _columns(layers, vertices)
    width = max(_LEAST_WIDTH, (columns[-1].right if columns else 0.0) + _MARGIN)
    height = max(_LEAST_HEIGHT, _HEAD + found.bottom + _FOOT)
    canvas = Canvas(np.full((round(height), round(width), 3), PAGE[::-1], dtype=np.uint8))
    column_of = {vertex: columns[number] for number, layer in enumerate(layers) for vertex in layer}
    boxes = {
        vertex: _box(column_of[vertex], _HEAD + places[vertex], sizes[vertex], vertices[vertex].width)
        for vertex in range(len(vertices))
    }
    # Those who talk with one another are drawn last: their lines lie above the others.
    for number, edge in sorted(enumerate(edges), key=lambda each: (each[1].says and each[1].hears, each[0])):
        _draw_edge(canvas, edge, found.chains[number], boxes, {v: (column_of[v], _HEAD + y) for v, y in places.items()})
    for vertex, box in boxes.items():
        _draw_vertex(canvas, vertices[vertex], box)
    _draw_words(canvas, small, width, height, any(edge.says and edge.hears for edge in edges))
    return canvas.image


def _vertices(small: Folded) -> List[_Vertex]:
    """List what is drawn: nodes, then topics."""
    graph = small.graph
    topics = graph.topics
    vertices = [_vertex(node, "", small.counts, is_topic=False) for node in graph.nodes]
    for topic in topics:
        rate = "" if topic.rate is None else f"{topic.rate:.3g} Hz"
        detail = "   ".join(part for part in (", ".join(topic.types).replace("*", "?"), rate) if part)
        vertices.append(_vertex(topic.name, detail, small.counts, is_topic=True, warns=len(topic.types) > 1))
    return vertices


def _vertex(name: str, detail: str, counts: Mapping[str, int], *, is_topic: bool, warns: bool = False) -> _Vertex:
    count = f"  \u00d7{counts[name]}" if name in counts else ""
    room = _WIDEST - 28.0 - text_width(count, _NAME)
    shown = shorten(name, _NAME, room) + count
    detail = fit(detail, _DETAIL, _WIDEST - 28.0)
    width = max(text_width(shown, _NAME), text_width(detail, _DETAIL)) + 28.0
    return _Vertex(is_topic, shown, detail, width, warns)


def _columns(layers: Sequence[Sequence[int]], vertices: Sequence[_Vertex]) -> List[Box]:
    """Give each layer's stripe; heights do not matter."""
    columns, left = [], _MARGIN
    for layer in layers:
        widest = max((vertices[vertex].width for vertex in layer if vertex < len(vertices)), default=0.0)
        columns.append(Box(left, 0.0, left + widest, 0.0))
        left += widest + _BETWEEN
    return columns


def _box(column: Box, middle: float, height: float, width: float) -> Box:
    x = (column.left + column.right) / 2.0
    return Box(x - width / 2.0, middle - height / 2.0, x + width / 2.0, middle + height / 2.0)


def _draw_edge(
    canvas: Canvas,
    edge: Link,
    chain: Sequence[int],
    boxes: Mapping[int, Box],
    places: Mapping[int, Tuple[Box, float]],
) -> None:
    """Draw a line through its layers, an arrow where it is heard and one where it is said."""
    stops: List[Point] = []
    for number, vertex in enumerate(chain):
        box = boxes.get(vertex)
        column, y = places[vertex]
        left, right = (column.left, column.right) if box is None else (box.left, box.right)
        if number:
            stops.append((left, y))
        if number < len(chain) - 1:
            stops.append((right, y))
    colour = _colour(edge.says, edge.hears)
    ends: Dict[int, Point] = {chain[0]: stops[0], chain[-1]: stops[-1]}
    line: List[Point] = []
    for number, (before, after) in enumerate(zip(stops, stops[1:])):
        line += [before, after] if number % 2 else _bend(before, after)
    canvas.line(line, colour, 2 if edge.says and edge.hears else 1)
    for vertex, wanted in ((edge.topic, edge.says), (edge.node, edge.hears)):
        if wanted:
            _draw_arrow(canvas, ends[vertex], 1.0 if vertex == chain[-1] else -1.0, colour)


def _colour(says: bool, hears: bool) -> Colour:
    return HAPPENING if says and hears else ACCENT if says else TRAIL


def _bend(before: Point, after: Point) -> List[Point]:
    """Lead from one point to another, leaving and arriving horizontally."""
    shares = np.linspace(0.0, 1.0, _BENDS)
    eased = shares * shares * (3.0 - 2.0 * shares)
    xs = before[0] + (after[0] - before[0]) * shares
    ys = before[1] + (after[1] - before[1]) * eased
    return [(float(x), float(y)) for x, y in zip(xs, ys)]


def _draw_arrow(canvas: Canvas, tip: Point, direction: float, colour: Colour) -> None:
    x, y = tip
    back = x - direction * _ARROW
    canvas.polygon([(x, y), (back, y - _ARROW / 2.2), (back, y + _ARROW / 2.2)], colour)


def _draw_vertex(canvas: Canvas, vertex: _Vertex, box: Box) -> None:
    x, y = box.centre
    if not vertex.is_topic:
        radius = box.height / 2.0
        for left in (box.left + radius, box.right - radius):
            canvas.disc((left, y - 0.5), radius - 0.5, ACCENT)
        canvas.fill(Box(box.left + radius, box.top, box.right - radius, box.bottom), ACCENT)
        canvas.text(x, y, vertex.name, _NODE, WHITE, ACCENT, 0.5)
        return
    canvas.fill(box, WHITE)
    canvas.frame(box, RED if vertex.warns else FRAME)
    canvas.text(x, y - 9.0 if vertex.detail else y, vertex.name, _NAME, INK, WHITE, 0.5)
    canvas.text(x, y + 10.0, vertex.detail, _DETAIL, RED if vertex.warns else MUTED, WHITE, 0.5)


def _draw_words(canvas: Canvas, small: Folded, width: float, height: float, talks: bool) -> None:
    graph = small.graph
    canvas.text(_MARGIN, 28.0, "Nodes and topics", _TITLE, INK, PAGE)
    said = f"{_counted(graph.nodes, small, 'node')}, {_counted([topic.name for topic in graph.topics], small, 'topic')}"
    if small.left_out:
        said += f"; {small.left_out} more topics are not shown"
    canvas.text(width - _MARGIN, 28.0, said, _WORDS, MUTED, PAGE, 1.0)
    y = height - 20.0
    x = _MARGIN
    kinds = [(ACCENT, "says"), (TRAIL, "hears"), (HAPPENING, "says and hears")]
    for colour, words in kinds if talks else kinds[:2]:
        if colour == TRAIL and graph.subscriptions is None:
            canvas.text(x, y, "who hears is not recorded", _WORDS, MUTED, PAGE)
            break
        canvas.line([(x, y), (x + 30.0, y)], colour, 2)
        _draw_arrow(canvas, (x + 34.0, y), 1.0, colour)
        if colour == HAPPENING:
            _draw_arrow(canvas, (x - 4.0, y), -1.0, colour)
        x += 70.0 + canvas.text(x + 44.0, y, words, _WORDS, MUTED, PAGE)


def _counted(names: Sequence[str], small: Folded, word: str) -> str:
    count = sum(small.counts.get(name, 1) for name in names)
    return f"{count} {word}{'' if count == 1 else 's'}"
