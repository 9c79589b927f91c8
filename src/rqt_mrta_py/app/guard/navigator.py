"""A planner's navigator whose failures and answers carry its name."""

from __future__ import annotations

import math
from typing import Any, Optional, Sequence, Tuple

from rqt_mrta_py.app.guard.asking import guarded
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import CostField, Navigator
from rqt_mrta_py.model import Pose
from rqt_mrta_py.wording import shown

__all__ = ["GuardedNavigator"]


class GuardedNavigator:
    """Asks a navigator and checks what it answers, so that no behaviour is blamed for it.

    Args:
        who: names robot and planner.
        navigator: to be asked.
    """

    def __init__(self, who: str, navigator: Navigator) -> None:
        self._who = who
        self._navigator = navigator

    def path(self, start: Pose, goal: Pose) -> Optional[Tuple[Pose, ...]]:
        """Find a shortest way; see hooks.Navigator."""
        path: Any = guarded(self._who, self._navigator.path, start, goal)
        if path is None:
            return None
        if not (isinstance(path, (tuple, list)) and path and all(map(_is_place, path))):
            raise HookError(f"{self._who}: path answered {shown(path)}; a tuple of finite Poses, or None, is needed")
        return tuple(path)

    def cost_field(self, goal: Pose) -> CostField:
        """Compute the length of the shortest way to a goal from everywhere; see hooks.Navigator."""
        field: Any = guarded(self._who, self._navigator.cost_field, goal)
        if not callable(getattr(field, "at", None)):
            raise HookError(f"{self._who}: cost_field answered {shown(field)}, which has no 'at'")
        return _GuardedCostField(self._who, field)

    def observe(self, obstacles: Sequence[Tuple[Pose, float]]) -> None:
        """Replace the passing obstacles: centre in the frame ``map`` and radius [m] of each."""
        guarded(self._who, self._navigator.observe, obstacles)


class _GuardedCostField:
    """Checks lengths."""

    def __init__(self, who: str, field: CostField) -> None:
        self._who = who
        self._field = field

    def at(self, place: Pose) -> Optional[float]:
        """Give the length of the shortest way from a place to the goal [m]; None if there is none."""
        length: Any = guarded(self._who, self._field.at, place)
        if length is not None and not (_is_number(length) and 0.0 <= length < math.inf):
            raise HookError(
                f"{self._who}: its cost field answered {shown(length)}; a finite length of at least 0 m, or None, "
                "is needed"
            )
        return None if length is None else float(length)


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _is_place(pose: object) -> bool:
    return (
        isinstance(pose, Pose)
        and all(map(_is_number, (pose.x, pose.y, pose.yaw)))
        and math.isfinite(pose.x + pose.y + pose.yaw)
    )
