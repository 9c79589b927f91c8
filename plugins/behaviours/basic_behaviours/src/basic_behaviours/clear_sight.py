"""What stands in the way of a robot among things that it fetches: all that is seen, but the one that it is after."""

from __future__ import annotations

from typing import Optional, Tuple

from basic_behaviours.sight import Disc, Sight
from rqt_mrta_py.hooks import Heard, RobotModel

__all__ = ["ClearSight"]

_SLACK = 0.1


class ClearSight:
    """Adds what the detector sees to what the range finder sees, and takes out one thing, wherever it is seen.

    Things may be too low for the range finder, or as high as the robot.

    Args:
        model: of the robot.
        radius: of the largest thing as seen from above [m].
    """

    def __init__(self, model: RobotModel, radius: float) -> None:
        self._reach = model.radius + model.reach
        self._radius = radius
        self._of: Tuple[object, ...] = (None,) * 5
        self._clear: Optional[Sight] = None

    def look(self, sight: Sight, detections: Heard, spared: str, *, carried: bool, push: bool = False) -> Sight:
        """Give what stands in the way; the same again while nothing else is heard.

        Args:
            sight: what the range finder sees.
            detections: what the detector saw last.
            spared: id of the thing that the robot is after; empty if none.
            carried: whether the robot holds it.
            push: leave out lying things that the range finder overlooks, so that the robot pushes them aside.
        """
        of = (sight, detections, spared, carried, push)
        if self._clear is None or any(one is not other for one, other in zip(of, self._of)):
            self._of = of
            self._clear = self._look(*of)
        return self._clear

    def _look(self, sight: Sight, detections: Heard, spared: str, carried: bool, push: bool) -> Sight:
        clear = sight
        if carried:
            clear = clear.without_disc(Disc(self._reach / 2.0, 0.0, self._reach / 2.0 + self._radius + _SLACK))
        others = []
        for detection in detections.fields["detections"]:
            x, y = float(detection["position"]["x"]), float(detection["position"]["y"])
            if detection["id"] != spared:
                others.append(Disc(x, y, self._radius))
            elif not carried:
                clear = clear.without_disc(Disc(x, y, self._radius + _SLACK))
        return clear.with_discs(others) if others and not push else clear
