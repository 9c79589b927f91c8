"""Polygons by other means than the code under test: clipping by half planes, areas, segments."""

from __future__ import annotations

import math
from typing import List, Sequence, Tuple

Point = Tuple[float, float]


def box(x: float, y: float, yaw: float, length: float, width: float) -> List[Point]:
    """Give the corners of a turned box, counter-clockwise."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    return [place(x, y, yaw, a * length / 2, b * width / 2) for a, b in corners]


def robot(x: float, y: float, yaw: float) -> List[Point]:
    """Give the hull of a diff_drive: a body of 0.30 m x 0.22 m, wheels to 0.18 m at both sides."""
    outline = [(0.15, -0.11), (0.15, 0.11), (0.0, 0.18), (-0.15, 0.11), (-0.15, -0.11), (0.0, -0.18)]
    return [place(x, y, yaw, a, b) for a, b in outline]


def place(x: float, y: float, yaw: float, ahead: float, left: float) -> Point:
    cos, sin = math.cos(yaw), math.sin(yaw)
    return (x + cos * ahead - sin * left, y + sin * ahead + cos * left)


def disc(x: float, y: float, radius: float, corners: int = 720) -> List[Point]:
    """Give a polygon inside a circle, less than radius * 1e-5 smaller."""
    turns = [2 * math.pi * index / corners for index in range(corners)]
    return [(x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns]


def common(subject: Sequence[Point], clip: Sequence[Point]) -> List[Point]:
    """Give what two convex polygons have in common (Sutherland and Hodgman 1974)."""
    left = list(subject)
    for (ax, ay), (bx, by) in zip(clip, [*clip[1:], clip[0]]):
        sides = [(bx - ax) * (y - ay) - (by - ay) * (x - ax) for x, y in left]
        kept: List[Point] = []
        for index, (point, side) in enumerate(zip(left, sides)):
            (px, py), before = left[index - 1], sides[index - 1]
            if (side >= 0) != (before >= 0):
                share = before / (before - side)
                kept.append((px + share * (point[0] - px), py + share * (point[1] - py)))
            if side >= 0:
                kept.append(point)
        left = kept
    return left


def area(polygon: Sequence[Point]) -> float:
    """Give the area of a polygon, 0 without one."""
    pairs = zip(polygon, [*polygon[1:], *polygon[:1]])
    return abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in pairs)) / 2


def depth_in_polygon(polygon: Sequence[Point], other: Sequence[Point]) -> float:
    """Give the shortest way out of a convex polygon for another, 0 or less when they are apart."""
    ways = []
    for edges, reaching in ((polygon, other), (other, polygon)):
        for (ax, ay), (bx, by) in zip(edges, [*edges[1:], edges[0]]):
            length = math.hypot(bx - ax, by - ay)
            ways.append(max(((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / length for x, y in reaching))
    return min(ways)


def depth_in_disc(polygon: Sequence[Point], centre: Point, radius: float) -> float:
    """Give the shortest way out of a disc for a convex polygon, 0 or less when they are apart."""
    sides, distances = [], []
    for (ax, ay), (bx, by) in zip(polygon, [*polygon[1:], polygon[0]]):
        ex, ey, x, y = bx - ax, by - ay, centre[0] - ax, centre[1] - ay
        sides.append(ex * y - ey * x)
        share = min(1.0, max(0.0, (ex * x + ey * y) / (ex * ex + ey * ey)))
        distances.append(math.hypot(x - share * ex, y - share * ey))
    nearest = min(distances)
    return radius + (nearest if min(sides) >= 0.0 else -nearest)


def shrunk(polygon: Sequence[Point], centre: Point, by: float) -> List[Point]:
    """Bring every corner nearer to a centre, such that no edge comes nearer by less than it would at right angles."""
    out = []
    for x, y in polygon:
        away = math.hypot(x - centre[0], y - centre[1])
        share = max(0.0, 1.0 - by / away)
        out.append((centre[0] + share * (x - centre[0]), centre[1] + share * (y - centre[1])))
    return out


def ray_to_polygon(origin: Point, direction: float, polygon: Sequence[Point]) -> float:
    """Give how far it is along a ray to the first edge, infinity without one."""
    dx, dy = math.cos(direction), math.sin(direction)
    nearest = math.inf
    for (ax, ay), (bx, by) in zip(polygon, [*polygon[1:], polygon[0]]):
        across = dx * (by - ay) - dy * (bx - ax)
        if across == 0.0:
            continue
        along = ((ax - origin[0]) * (by - ay) - (ay - origin[1]) * (bx - ax)) / across
        share = ((ax - origin[0]) * dy - (ay - origin[1]) * dx) / across
        if along >= 0.0 and 0.0 <= share <= 1.0:
            nearest = min(nearest, along)
    return nearest


def ray_to_circle(origin: Point, direction: float, centre: Point, radius: float) -> float:
    """Give how far it is along a ray to a circle around which it does not begin, infinity if it passes."""
    x, y = centre[0] - origin[0], centre[1] - origin[1]
    half = x * math.cos(direction) + y * math.sin(direction)
    under_root = half * half - (x * x + y * y - radius * radius)
    if half < 0.0 or under_root < 0.0:
        return math.inf
    return half - math.sqrt(under_root)
