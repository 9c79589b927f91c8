"""A renderer whose failures carry its name."""

from __future__ import annotations

from typing import Any, Tuple

from rqt_mrta_py.app.guard.asking import guarded
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import MonitorView, Renderer
from rqt_mrta_py.wording import shown

__all__ = ["guarded_renderer"]


def guarded_renderer(name: str, renderer: Renderer) -> Renderer:
    """Give a renderer whose failures carry its name."""

    def draw(view: MonitorView) -> Any:
        image = guarded(f"renderer {name}", renderer, view)
        shape: Tuple[int, ...] = tuple(getattr(image, "shape", ()))
        dtype = str(getattr(image, "dtype", ""))
        if len(shape) != 3 or shape[2] != 3 or 0 in shape or dtype != "uint8":
            found = f"an array of {shape} {dtype}" if dtype else shown(image)
            raise HookError(f"renderer {name}: drew {found}; an array of (height, width, 3) uint8 is needed")
        return image

    return draw
