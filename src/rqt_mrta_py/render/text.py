"""Words as masks: DejaVu Sans by Pillow, which looks the same under every version of OpenCV.

Masks are pure functions of text and style, so they are cached: most words of a picture stand in the next one too.
"""

from __future__ import annotations

import math
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, List, NamedTuple, Tuple

import numpy as np

from rqt_mrta_py.errors import MissingDependencyError
from rqt_mrta_py.render.libraries import opencv, pillow
from rqt_mrta_py.render.palette import Colour

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Style", "ascent", "fit", "halo_patch", "mask", "patch", "printable", "shorten", "text_width", "wrap"]

_HALO = 2
# No picture has room for more, and measuring what a bag tells must not take for ever.
_LONGEST = 400
_UNPRINTABLE = "\ufffd"


class Style(NamedTuple):
    """How words look: height of the font [pixels] and weight."""

    size: int
    bold: bool = False


def printable(text: str, longest: int = _LONGEST) -> str:
    """Make one short line of whatever a stream tells.

    Args:
        text: anything.
        longest: of a longer text only beginning and end stay [characters].

    Returns:
        The text, white space as blanks, other control characters and halves of surrogate pairs as ``\ufffd``.
    """
    if len(text) > longest:
        text = _ends(text, longest - 1)
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else " " if c.isspace() else _UNPRINTABLE for c in text)


def text_width(text: str, style: Style) -> int:
    """Measure words.

    Args:
        text: one line.
        style: its look.

    Returns:
        Width of their mask [pixels].
    """
    return _width(printable(text), style)


def ascent(style: Style) -> int:
    """Give the height of capitals above the baseline [pixels]."""
    return _metrics(style)[2]


def fit(text: str, style: Style, width: float) -> str:
    """Shorten words to a width.

    Args:
        text: one line.
        style: its look.
        width: that they may take [pixels].

    Returns:
        The text, or its beginning with an ellipsis, or nothing if not even that fits.
    """
    return _fit(printable(text), style, int(width))


def shorten(name: str, style: Style, width: float) -> str:
    """Shorten a name to a width; beginning and end stay, for it is often the end that tells names apart.

    Args:
        name: one line.
        style: its look.
        width: that it may take [pixels].

    Returns:
        The name, or its two ends around an ellipsis, or nothing if not even that fits.
    """
    return _shorten(printable(name), style, int(width))


def wrap(text: str, style: Style, width: float, lines: int) -> Tuple[str, ...]:
    """Break words into lines.

    Args:
        text: one sentence.
        style: its look.
        width: of a line [pixels].
        lines: at most so many; the last ends in an ellipsis if words are left over.

    Returns:
        One line or more.
    """
    return _wrap(printable(text, _LONGEST * lines), style, int(width), lines)


def mask(text: str, style: Style) -> Tuple[NDArray[np.uint8], int]:
    """Draw words.

    Args:
        text: one line.
        style: its look.

    Returns:
        Coverage, (height, width) from 0 to 255, and the row of the baseline.
    """
    return _mask(printable(text), style)


def patch(text: str, style: Style, colour: Colour, ground: Colour) -> Tuple[NDArray[np.uint8], int]:
    """Draw words on a flat ground.

    Args:
        text: one line.
        style: its look.
        colour: of the words.
        ground: on which they stand.

    Returns:
        A picture (height, width, 3) and the row of the baseline.
    """
    return _patch(printable(text), style, colour, ground)


def halo_patch(
    text: str, style: Style, colour: Colour, halo: Colour
) -> Tuple[NDArray[np.uint16], NDArray[np.uint16], int]:
    """Draw words with a halo, to lay over anything.

    Args:
        text: one line.
        style: its look.
        colour: of the words.
        halo: colour of the halo.

    Returns:
        What to add, (height, width, 3), in units of 1/256; what is kept of the ground, of the same shape, from 0 to
        256; and the row of the baseline.
    """
    return _halo_patch(printable(text), style, colour, halo)


@lru_cache(maxsize=1024)
def _mask(text: str, style: Style) -> Tuple[NDArray[np.uint8], int]:
    above, below, _ = _metrics(style)
    width = _width(text, style)
    image = pillow("Image").new("L", (max(width, 1), above + below), 0)
    pillow("ImageDraw").Draw(image).text((1, above), text, fill=255, font=_font(style), anchor="ls")
    return np.array(image, dtype=np.uint8), above


@lru_cache(maxsize=2048)
def _patch(text: str, style: Style, colour: Colour, ground: Colour) -> Tuple[NDArray[np.uint8], int]:
    coverage, baseline = _mask(text, style)
    share = coverage[:, :, None].astype(np.float32) / 255.0
    blended = _bgr(ground) + share * (_bgr(colour) - _bgr(ground))
    return np.rint(blended).astype(np.uint8), baseline


@lru_cache(maxsize=1024)
def _halo_patch(
    text: str, style: Style, colour: Colour, halo: Colour
) -> Tuple[NDArray[np.uint16], NDArray[np.uint16], int]:
    cv2 = opencv()
    coverage, baseline = _mask(text, style)
    room = cv2.copyMakeBorder(coverage, _HALO, _HALO, _HALO, _HALO, cv2.BORDER_CONSTANT, value=0)
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * _HALO + 1, 2 * _HALO + 1))
    glow = cv2.blur(cv2.dilate(room, disc), (3, 3))[:, :, None].astype(np.float32) / 255.0
    share = room[:, :, None].astype(np.float32) / 255.0
    covered = np.maximum(glow * 0.92, share)
    added = _bgr(colour) * share + _bgr(halo) * (covered - share)
    kept = np.rint((1.0 - covered) * 256.0).astype(np.uint16)
    # One share for each colour: numpy is three times as quick where nothing is to be spread.
    return np.rint(added * 256.0).astype(np.uint16), np.repeat(kept, 3, axis=2), baseline + _HALO


def _bgr(colour: Colour) -> NDArray[np.float32]:
    return np.array(colour[::-1], dtype=np.float32)


@lru_cache(maxsize=4096)
def _width(text: str, style: Style) -> int:
    return math.ceil(_font(style).getlength(text)) + 2 if text else 0


@lru_cache(maxsize=4096)
def _fit(text: str, style: Style, width: int) -> str:
    if _width(text, style) <= width:
        return text
    low, high = 0, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        if _width(text[:middle].rstrip() + "…", style) <= width:
            low = middle
        else:
            high = middle - 1
    return text[:low].rstrip() + "…" if low else ""


@lru_cache(maxsize=4096)
def _shorten(name: str, style: Style, width: int) -> str:
    if _width(name, style) <= width:
        return name
    low, high = 0, len(name) - 1
    while low < high:
        middle = (low + high + 1) // 2
        if _width(_ends(name, middle), style) <= width:
            low = middle
        else:
            high = middle - 1
    return _ends(name, low) if low else ""


def _ends(name: str, kept: int) -> str:
    tail = kept // 2
    return f"{name[: kept - tail]}…{name[len(name) - tail :]}"


@lru_cache(maxsize=1024)
def _wrap(text: str, style: Style, width: int, lines: int) -> Tuple[str, ...]:
    done: List[str] = []
    words = text.split()
    while words and len(done) < lines - 1:
        count = 1
        while count < len(words) and _width(" ".join(words[: count + 1]), style) <= width:
            count += 1
        done.append(_fit(" ".join(words[:count]), style, width))
        words = words[count:]
    if words or not done:
        done.append(_fit(" ".join(words), style, width))
    return tuple(done)


@lru_cache(maxsize=32)
def _metrics(style: Style) -> Tuple[int, int, int]:
    font = _font(style)
    above, below = font.getmetrics()
    return above, below, -font.getbbox("H", anchor="ls")[1]


@lru_cache(maxsize=32)
def _font(style: Style) -> Any:
    fonts = pillow("ImageFont")
    path = _font_path("DejaVuSans-Bold.ttf" if style.bold else "DejaVuSans.ttf")
    return fonts.truetype(path, style.size, layout_engine=fonts.Layout.BASIC)


def _font_path(name: str) -> str:
    """Find a face among matplotlib's own fonts, whose import is not worth the wait, else among the system's."""
    spec = find_spec("matplotlib")
    folders = [Path(spec.origin).parent / "mpl-data" / "fonts" / "ttf"] if spec and spec.origin else []
    folders += [Path("/usr/share/fonts/truetype/dejavu"), Path("/usr/share/fonts/dejavu")]
    for folder in folders:
        if (folder / name).is_file():
            return str(folder / name)
    raise MissingDependencyError(
        f"writing on pictures: no font {name} in {', '.join(map(str, folders))}; "
        "install matplotlib or fonts-dejavu-core"
    )
