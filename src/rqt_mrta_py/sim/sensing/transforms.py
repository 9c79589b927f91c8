"""The transforms that robots publish: where they are by their odometry, and where that began by their localisers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Sequence, Tuple

import numpy as np

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Column, TeamOutgoing
from rqt_mrta_py.sim.angles import wrap_angles
from rqt_mrta_py.sim.picking import picked
from rqt_mrta_py.sim.sensing.mount import RobotSaid, Said
from rqt_mrta_py.wording import shown

if TYPE_CHECKING:
    from numpy.typing import NDArray

    _Floats = NDArray[np.float64]
    _Rows = NDArray[np.intp]

__all__ = ["Transforms", "odometry_origins"]

_ODOMETRY, _LOCATED = "nav_msgs/Odometry", "geometry_msgs/PoseStamped"
_POSE_IN = {_ODOMETRY: ("pose", "pose"), _LOCATED: ("pose",)}
"""Where messages of these types have their pose."""

_POSE = (
    ("position", "x"),
    ("position", "y"),
    ("position", "z"),
    ("orientation", "x"),
    ("orientation", "y"),
    ("orientation", "z"),
    ("orientation", "w"),
)
"""What a geometry_msgs/Pose is made of: the rows of arrays of poses."""
_TRANSFORM_PARTS = {"position": "translation", "orientation": "rotation"}
"""Names of the same in a geometry_msgs/Transform."""
_MOST_TEAMS = 64
"""Teams that speak together, whose rows are kept in mind."""


class Transforms:
    """Derives ``/tf`` of all robots from what their own sensors publish.

    Each nav_msgs/Odometry is followed by odom -> base_link, and by map -> odom once a localiser was heard; a
    geometry_msgs/PoseStamped is paired with the newest odometry.

    Args:
        robots: ids, prefixes of the frames ``<robot>/odom`` and ``<robot>/base_link``.
    """

    def __init__(self, robots: Sequence[str]) -> None:
        self._robots = tuple(robots)
        self._odom_frames = tuple([f"{robot}/odom" for robot in robots])
        self._base_frames = tuple([f"{robot}/base_link" for robot in robots])
        self._places = {robot: place for place, robot in enumerate(robots)}
        self._rows_of: Dict[Tuple[str, ...], _Rows] = {}
        self._poses: Dict[str, _Floats] = {type_name: np.zeros((len(_POSE), len(robots))) for type_name in _POSE_IN}
        self._is_new = {type_name: np.zeros(len(robots), dtype=bool) for type_name in _POSE_IN}
        self._is_counted = np.zeros(len(robots), dtype=bool)
        self._origins: _Floats = np.zeros((len(_POSE), len(robots)))
        self._is_placed = np.zeros(len(robots), dtype=bool)

    def hear(self, said: Said) -> None:
        """Take in what sensors publish.

        Raises:
            SimError: a pose in it is not made of numbers.
        """
        if isinstance(said, RobotSaid):
            self._hear_one(said)
        elif said.type in _POSE_IN:
            within = "/".join(_POSE_IN[said.type])
            values = [said.columns.get(f"{within}/{part}/{name}", 0.0) for part, name in _POSE]
            self._take(said.type, said.topic, said.robots, values)

    def due(self, times: NDArray[np.float64]) -> List[TeamOutgoing]:
        """Give what follows from all that was heard since the last time, one message a robot at the most.

        Args:
            times: on each robot's clock [s], shape (robots,).

        Returns:
            What robots publish that know where they are in the map, then what the others do.
        """
        is_counted, is_located = self._is_new[_ODOMETRY], self._is_new[_LOCATED]
        self._is_counted |= is_counted
        found = np.flatnonzero(is_located & self._is_counted)
        if found.size:
            self._place(found)
        placed, lost = np.flatnonzero(is_counted & self._is_placed), np.flatnonzero(is_counted & ~self._is_placed)
        is_counted[:] = is_located[:] = False
        messages = []
        if placed.size:
            frames, times_of = picked(self._odom_frames, placed), times[placed]
            columns = _transform(0, times_of, "map", frames, self._origins[:, placed])
            columns.update(self._base(1, times_of, placed))
            messages.append(self._message(placed, columns))
        if lost.size:
            messages.append(self._message(lost, self._base(0, times[lost], lost)))
        return messages

    def _hear_one(self, said: RobotSaid) -> None:
        for message in said.messages:
            if message.type in _POSE_IN:
                pose: Any = message.fields
                for name in _POSE_IN[message.type]:
                    pose = _inner(pose, name)
                values = [_inner(pose, part).get(name, 0.0) for part, name in _POSE]
                self._take(message.type, message.topic, (said.robot,), values)

    def _take(self, type_name: str, topic: str, robots: Tuple[str, ...], values: Sequence[Column]) -> None:
        rows, poses = self._rows(robots), self._poses[type_name]
        for row, (part, name), value in zip(poses, _POSE, values):
            try:
                row[rows] = value
            except (TypeError, ValueError):
                where = "/".join((*_POSE_IN[type_name], part, name))
                raise SimError(
                    f"robot {robots[0]}: {type_name} on {topic}: {where} must be a number to make a transform "
                    f"(got {shown(value)})"
                ) from None
        self._is_new[type_name][rows] = True

    def _rows(self, robots: Tuple[str, ...]) -> _Rows:
        """Find the rows of robots, which mostly speak with the same others again."""
        rows = self._rows_of.get(robots)
        if rows is None:
            if len(self._rows_of) >= _MOST_TEAMS:
                self._rows_of.clear()
            rows = self._rows_of[robots] = np.array([self._places[robot] for robot in robots], dtype=np.intp)
        return rows

    def _place(self, rows: _Rows) -> None:
        """Find where odometry began, of robots that were located now."""
        located, counted = (_flat(self._poses[type_name][:, rows]) for type_name in (_LOCATED, _ODOMETRY))
        x, y, yaw = odometry_origins(located, counted)
        zero = np.zeros_like(x)
        self._origins[:, rows] = (x, y, zero, zero, zero, np.sin(yaw / 2), np.cos(yaw / 2))
        self._is_placed[rows] = True

    def _base(self, number: int, times: _Floats, rows: _Rows) -> Dict[str, Column]:
        odom_frames, base_frames = picked(self._odom_frames, rows), picked(self._base_frames, rows)
        return _transform(number, times, odom_frames, base_frames, self._poses[_ODOMETRY][:, rows])

    def _message(self, rows: _Rows, columns: Mapping[str, Column]) -> TeamOutgoing:
        return TeamOutgoing("/tf", "tf2_msgs/TFMessage", picked(self._robots, rows), columns)


def odometry_origins(located: NDArray[np.float64], counted: NDArray[np.float64]) -> NDArray[np.float64]:
    """Place frames ``odom`` in ``map`` such that a pose in the one and a pose in the other are the same place.

    Args:
        located: robots in ``map``: x, y [m] and yaw [rad], shape (3, robots).
        counted: the same robots in ``odom``.

    Returns:
        T(map, odom) = T(map, base) T(odom, base)^-1, in the same form.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        yaw = wrap_angles(located[2] - counted[2])
        cos, sin = np.cos(yaw), np.sin(yaw)
        x = located[0] - (cos * counted[0] - sin * counted[1])
        y = located[1] - (sin * counted[0] + cos * counted[1])
    return np.array((x, y, yaw))


def _flat(poses: _Floats) -> _Floats:
    """Give x, y, yaw of poses on the floor."""
    x, y, _, _, _, turn_z, turn_w = poses
    return np.array((x, y, 2 * np.arctan2(turn_z, turn_w)))


def _transform(number: int, times: _Floats, parents: Column, children: Column, poses: _Floats) -> Dict[str, Column]:
    """Give the columns of one geometry_msgs/TransformStamped: where children stand in their parents."""
    within = f"transforms/{number}"
    columns: Dict[str, Column] = {
        f"{within}/header/stamp": times,
        f"{within}/header/frame_id": parents,
        f"{within}/child_frame_id": children,
    }
    for (part, name), values in zip(_POSE, poses):
        columns[f"{within}/transform/{_TRANSFORM_PARTS[part]}/{name}"] = values
    return columns


def _inner(fields: Any, name: str) -> Mapping[str, Any]:
    """Give a part of a message, whose fields nobody has checked yet; one left out has none."""
    inner = fields.get(name, {})
    return inner if isinstance(inner, Mapping) else {}
