"""Drawings are drawn where their places are, in one scale, in the colours of the palette."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from rqt_mrta_py.app.guard import checked_drawing
from rqt_mrta_py.errors import HookError, RenderError
from rqt_mrta_py.hooks import Area, Drawing, DrawingPanel, Stroke, Tint, Words
from rqt_mrta_py.render.drawings import WIDTH, draw_drawing, drawing_png
from rqt_mrta_py.render.palette import INK, RED, TASK_COLOURS

pytest.importorskip("cv2", reason="OpenCV draws")
pytest.importorskip("PIL", reason="Pillow writes")

SQUARE = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0))
LEFT_HALF = ((0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0))


def drawing(*panels: DrawingPanel, columns: int = 1) -> Drawing:
    return Drawing("plan", "A plan", panels, columns)


def share(image: np.ndarray, colour: object) -> float:
    """Tell which share of a picture has a colour."""
    return float((image[:, :, ::-1] == np.array(colour)).all(axis=2).mean())


def test_later_shapes_cover_earlier_ones_in_colours_of_the_palette() -> None:
    image = draw_drawing(drawing(DrawingPanel("", (Area(SQUARE, Tint(0)), Area(LEFT_HALF, Tint(Drawing.RED))))))
    assert image.shape[1] == WIDTH
    blue, red = share(image, TASK_COLOURS[0]), share(image, RED)
    assert blue == pytest.approx(red, rel=0.01)
    # A square of 1000 pixels, the highest that a panel is.
    assert blue + red == pytest.approx(1000.0**2 / image[:, :, 0].size, rel=0.01)
    columns = np.flatnonzero((image[:, :, ::-1] == np.array(RED)).all(axis=2).any(axis=0))
    assert columns.max() < WIDTH / 2 + 2


def test_y_goes_up() -> None:
    low = Area(((0.0, 0.0), (2.0, 0.0), (2.0, 0.5), (0.0, 0.5)), Tint(Drawing.INK))
    image = draw_drawing(drawing(DrawingPanel("", (Stroke(SQUARE, Tint(0)), low))))
    rows = np.flatnonzero((image[:, :, ::-1] == np.array(INK)).all(axis=2).sum(axis=1) > 500)
    assert rows.min() > 0.7 * image.shape[0]


def test_panels_have_one_scale() -> None:
    small = Area(((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)), Tint(1))
    image = draw_drawing(drawing(DrawingPanel("", (Area(SQUARE, Tint(0)),)), DrawingPanel("", (small,)), columns=2))
    assert share(image, TASK_COLOURS[0]) == pytest.approx(4.0 * share(image, TASK_COLOURS[1]), rel=0.02)


def test_words_without_room_are_left_out() -> None:
    base = DrawingPanel("", (Area(SQUARE, Tint(0)),))
    narrow = DrawingPanel("", (*base.shapes, Words(1.0, 1.0, "words", room=0.01)))
    roomy = DrawingPanel("", (*base.shapes, Words(1.0, 1.0, "words", room=1.0)))
    assert drawing_png(drawing(narrow)) == drawing_png(drawing(base)) != drawing_png(drawing(roomy))


def test_a_drawing_without_anything_is_only_its_title() -> None:
    assert draw_drawing(drawing()).shape[0] < 200
    assert draw_drawing(drawing(DrawingPanel("nothing", ()))).shape[1] == WIDTH


def test_too_many_panels_are_refused() -> None:
    with pytest.raises(RenderError, match="drawing plan: 60 rows of panels are too many for one picture"):
        draw_drawing(drawing(*[DrawingPanel("", (Area(SQUARE, Tint(0)),))] * 60))


GOOD = drawing(DrawingPanel("", (Area(SQUARE, Tint(0)),)))


@pytest.mark.parametrize(
    ("bad", "message"),
    [
        (replace(GOOD, name="../x"), "verb: '../x' is no name of a drawing"),
        (
            replace(GOOD, columns=0),
            "verb: drawing plan: has title 'A plan', 0 columns; a text and 1 or more",
        ),
        (replace(GOOD, key=((0, "x"),)), "verb: drawing plan: explains 0 by 'x'; a Tint and a text are needed"),
        (replace(GOOD, panels=("x",)), "verb: drawing plan: 'x' stands among its panels; a DrawingPanel"),
        (
            drawing(DrawingPanel("", (Area(((0.0, float("nan")),), Tint(0)),))),
            "verb: drawing plan: Area(",
        ),
        (drawing(DrawingPanel("", (Area((), Tint(0)),))), "verb: drawing plan: Area("),
        (drawing(DrawingPanel("", (Stroke(SQUARE, Tint(-9)),))), "verb: drawing plan: Stroke("),
        (drawing(DrawingPanel("", (Words(0.0, 0.0, "x", size=0),))), "verb: drawing plan: Words("),
        (drawing(DrawingPanel("", ("x",))), "verb: drawing plan: 'x' stands among a panel's shapes; an Area, Stroke"),
    ],
)
def test_what_cannot_be_drawn_is_told_with_whose_it_is(bad: Drawing, message: str) -> None:
    with pytest.raises(HookError) as caught:
        checked_drawing("verb", bad)
    assert str(caught.value).startswith(message)


def test_what_can_be_drawn_passes() -> None:
    assert checked_drawing("verb", GOOD) is GOOD
