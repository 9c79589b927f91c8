"""What a plugin's part raises where its answer is needed, told with whose part it is."""

from __future__ import annotations

from typing import Any, Callable, Iterable, List, TypeVar

from rqt_mrta_py.errors import HookError, MrtaError
from rqt_mrta_py.hooks import CurvePanel, Heard, MonitorPanel, MonitorView, Renderer, Subscription

__all__ = ["GuardedPanel", "guarded", "guarded_renderer"]

_Answer = TypeVar("_Answer")


def guarded(who: str, ask: Callable[..., _Answer], *arguments: Any) -> _Answer:
    """Ask a plugin's part.

    Args:
        who: names it, for instance ``monitor panel x``.
        ask: what to call.
        arguments: to call it with.

    Returns:
        Its answer.

    Raises:
        HookError: it raised; says who and what. Errors that already speak to the user pass as they are, and so does
            that the reader of a pipe has gone.
    """
    try:
        return ask(*arguments)
    except (MrtaError, BrokenPipeError):
        raise
    except Exception as error:
        raise HookError(f"{who}: {type(error).__name__}: {error}") from error


class GuardedPanel:
    """A monitor panel whose failures carry its name."""

    def __init__(self, name: str, panel: MonitorPanel) -> None:
        self._who = f"monitor panel {name}"
        self._panel = panel

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear."""
        wishes: Iterable[Subscription] = guarded(self._who, self._panel.subscriptions)
        return list(wishes)

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        guarded(self._who, self._panel.hear, heard)

    def view(self, start: float, end: float) -> CurvePanel:
        """Give what is to be drawn of the time from ``start`` to ``end`` [s]."""
        return guarded(self._who, self._panel.view, start, end)


def guarded_renderer(name: str, renderer: Renderer) -> Renderer:
    """Give a renderer whose failures carry its name."""

    def draw(view: MonitorView) -> Any:
        return guarded(f"renderer {name}", renderer, view)

    return draw
