"""A monitor panel whose failures carry its name."""

from __future__ import annotations

from typing import Any, List

from rqt_mrta_py.app.guard.asking import guarded, wishes_of
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, Heard, MonitorPanel, Subscription
from rqt_mrta_py.wording import shown

__all__ = ["GuardedPanel"]


class GuardedPanel:
    """A monitor panel whose failures carry its name."""

    def __init__(self, name: str, panel: MonitorPanel) -> None:
        self._who = f"monitor panel {name}"
        self._panel = panel

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear."""
        return wishes_of(self._who, self._panel)

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        guarded(self._who, self._panel.hear, heard)

    def view(self, start: float, end: float) -> CurvePanel:
        """Give what is to be drawn of the time from ``start`` to ``end`` [s]."""
        view: Any = guarded(self._who, self._panel.view, start, end)
        if not (isinstance(view, CurvePanel) and all(map(_is_group, view.groups))):
            raise HookError(f"{self._who}: gives {shown(view)}; a CurvePanel of CurveGroups of Curves is needed")
        return view


def _is_group(group: object) -> bool:
    return isinstance(group, CurveGroup) and all(isinstance(curve, Curve) for curve in group.curves)
