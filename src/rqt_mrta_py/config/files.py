"""Files read whole, and files that are there whole or not at all."""

from __future__ import annotations

from pathlib import Path

from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["read_file", "write_whole"]


def read_file(path: Path) -> bytes:
    """Read a file whole.

    Raises:
        ConfigError: it cannot be read; says why.
    """
    try:
        return path.read_bytes()
    except OSError as error:
        raise ConfigError([Problem(str(path), 0, "", f"cannot be read: {error.strerror or error}")]) from error


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
