"""Places in YAML files."""

from __future__ import annotations

from typing import Optional

from rqt_mrta_py.config.yaml.rows import Row
from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.model import Pose

__all__ = ["PLACE", "pose_of"]

PLACE = Table(
    "place",
    "A position and heading in the frame map.",
    (
        Key("x", ValueType.NUMBER, "Position along the x axis.", "m"),
        Key("y", ValueType.NUMBER, "Position along the y axis.", "m"),
        Key("yaw", ValueType.NUMBER, "Heading, counter-clockwise from the x axis.", "rad", 0.0),
    ),
)


def pose_of(row: Optional[Row]) -> Optional[Pose]:
    """Turn a place that was read without problems into a pose; None stays None."""
    return None if row is None else Pose(row.values["x"], row.values["y"], row.values["yaw"])
