"""Files that are there whole or not at all."""

from __future__ import annotations

from pathlib import Path

__all__ = ["write_whole"]


def write_whole(path: Path, data: bytes) -> None:
    """Write a file aside and rename it; whatever happens, nothing half-written is left.

    Args:
        path: where it shall be; its folder exists.
        data: its content.

    Raises:
        OSError: it cannot be written; what stood there before stands there still.
    """
    aside = path.with_name(f".{path.name}.part")
    try:
        aside.write_bytes(data)
        aside.replace(path)
    except OSError:
        try:
            aside.unlink()
        except OSError:
            pass
        raise
