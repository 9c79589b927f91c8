"""A figure as pixels and as a PNG file."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

from rqt_mrta_py.hooks import Figure
from rqt_mrta_py.render.encode import png
from rqt_mrta_py.render.figures.page import FigurePage
from rqt_mrta_py.render.libraries import matplotlib, opencv, pillow

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["draw_figure", "figure_png", "require_figures"]


def require_figures() -> None:
    """Make sure that figures can be drawn.

    Raises:
        MissingDependencyError: matplotlib, Pillow or OpenCV is not installed.
    """
    matplotlib("figure")
    pillow("ImageFont")
    opencv()


def draw_figure(figure: Figure) -> NDArray[np.uint8]:
    """Draw a figure.

    Args:
        figure: what is to be drawn.

    Returns:
        A picture (height, 1600, 3), blue, green, red; equal for equal figures. The more charts, the higher it is.

    Raises:
        MissingDependencyError: matplotlib, Pillow or OpenCV is not installed.
        RenderError: there are more charts than a picture can be high.
    """
    with matplotlib("style").context("default"), warnings.catch_warnings():
        # Names may be in any script; what the font lacks is drawn as a box.
        warnings.filterwarnings("ignore", "Glyph .* missing from", UserWarning)
        return FigurePage.of(figure).picture()


def figure_png(figure: Figure) -> bytes:
    """Draw a figure and encode it; equal bytes for equal figures, which hold no date and no version.

    Args:
        figure: what is to be drawn.

    Returns:
        The content of a PNG file.

    Raises:
        MissingDependencyError, RenderError: as ``draw_figure``.
    """
    return png(draw_figure(figure))
