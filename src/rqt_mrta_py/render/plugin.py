"""The pictures of the main package, registered as a stranger would register theirs."""

from __future__ import annotations

from typing import Mapping

from rqt_mrta_py.hooks import Renderer, hookimpl
from rqt_mrta_py.render.dashboard import draw_dashboard
from rqt_mrta_py.render.monitor import MonitorRenderer

__all__ = ["mrta_register_renderers"]


@hookimpl
def mrta_register_renderers() -> Mapping[str, Renderer]:
    """Name the picture of a moment and the picture of the whole."""
    return {"dashboard": draw_dashboard, "monitor": MonitorRenderer()}
