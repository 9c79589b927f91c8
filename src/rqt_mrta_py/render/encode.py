"""Pictures as bytes and as files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, List

from rqt_mrta_py.config.files import write_whole
from rqt_mrta_py.errors import RenderError
from rqt_mrta_py.render.libraries import opencv

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["jpeg", "png", "write_picture"]

# The pictures are mostly flat: rows that are not filtered are quicker to encode, and smaller, than filtered ones.
_PNG_LEVEL = 3


def png(image: NDArray[np.uint8]) -> bytes:
    """Encode a picture as PNG.

    Args:
        image: (height, width, 3), blue, green, red.

    Returns:
        The file's bytes; equal for equal pictures.

    Raises:
        RenderError: the picture cannot be encoded.
    """
    cv2 = opencv()
    options = [cv2.IMWRITE_PNG_COMPRESSION, _PNG_LEVEL]
    if hasattr(cv2, "IMWRITE_PNG_FILTER"):  # from OpenCV 4.11 on
        options += [cv2.IMWRITE_PNG_FILTER, cv2.IMWRITE_PNG_FILTER_NONE]
    return _encode(".png", image, options)


def jpeg(image: NDArray[np.uint8], quality: int = 85, restart: int = 0) -> bytes:
    """Encode a picture as JPEG.

    Args:
        image: (height, width, 3), blue, green, red.
        quality: from 1, worst, to 100, best.
        restart: a restart marker, whose coding begins anew, after so many blocks of 16 x 16 pixels; 0 for none.

    Returns:
        The file's bytes; equal for equal pictures.

    Raises:
        RenderError: the picture cannot be encoded.
        ValueError: the quality is out of range.
    """
    if not 1 <= quality <= 100:
        raise ValueError(f"the quality of a JPEG is between 1 and 100 (got {quality})")
    cv2 = opencv()
    return _encode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, quality, cv2.IMWRITE_JPEG_RST_INTERVAL, restart])


def write_picture(path: Path, image: NDArray[np.uint8]) -> None:
    """Write a picture whole or not at all: aside first, then renamed.

    Args:
        path: of the file; its ending, ``.png``, ``.jpg`` or ``.jpeg``, says the format.
        image: (height, width, 3), blue, green, red.

    Raises:
        RenderError: the ending is another one, the picture cannot be encoded, or the file cannot be written.
    """
    encoders = {".png": png, ".jpg": jpeg, ".jpeg": jpeg}
    encoder = encoders.get(path.suffix.lower())
    if encoder is None:
        raise RenderError(f"{path}: no picture format ends in {path.suffix!r}; use .png, .jpg or .jpeg")
    try:
        data = encoder(image)
    except RenderError as error:
        raise RenderError(f"{path}: {error}") from error
    try:
        write_whole(path, data)
    except OSError as error:
        raise RenderError(f"{path}: the picture cannot be written: {error.strerror or error}") from error


def _encode(ending: str, image: NDArray[np.uint8], options: List[int]) -> bytes:
    cv2 = opencv()
    if image.ndim != 3 or image.shape[2] != 3 or image.dtype.name != "uint8" or not image.size:
        raise RenderError(
            f"a picture of shape {image.shape} and type {image.dtype.name} cannot be encoded as {ending}; "
            "it must be (height, width, 3) of uint8, not empty"
        )
    try:
        done, data = cv2.imencode(ending, image, options)
    except cv2.error as error:
        raise RenderError(f"OpenCV cannot encode a picture of shape {image.shape} as {ending}: {error}") from error
    if not done:
        raise RenderError(f"OpenCV cannot encode a picture of shape {image.shape} as {ending}")
    return bytes(data)
