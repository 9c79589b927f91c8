"""Figures: charts below one another in one picture, drawn with matplotlib at the end of a mission or benchmark.

* ``drawing``: a figure as pixels and as a PNG file
* ``page``: title, legend and charts laid out in pixels; ``legend`` names lines where they cover nothing
* ``colours``: which line has which colour; ``limits``: from where to where axes go
* ``lines``: lines, bars and intervals upon a pair of axes
"""

from __future__ import annotations

from rqt_mrta_py.render.figures.drawing import draw_figure, figure_png, require_figures

__all__ = ["draw_figure", "figure_png", "require_figures"]
