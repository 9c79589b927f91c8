"""Files read whole, and files that are there whole or not at all, one by one or several together."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Dict, List, Mapping, Optional

from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["read_file", "read_if_there", "write_together", "write_whole"]


def read_file(path: Path, *, any_kind: bool = False) -> bytes:
    """Read a file whole.

    Args:
        path: of the file.
        any_kind: read what is no regular file too, such as a pipe that the user names; one in a package could hang us.

    Raises:
        ConfigError: it cannot be read; says why.
    """
    try:
        if not any_kind and path.exists() and not (path.is_file() or path.is_dir()):
            raise ConfigError([Problem(str(path), 0, "", "is a pipe or device; a regular file is accepted")])
        return path.read_bytes()
    except OSError as error:
        raise _unreadable(path, error) from error


def read_if_there(path: Path) -> Optional[bytes]:
    """Read a file whole; None where there is none.

    Raises:
        ConfigError: it cannot be read, or its name is longer than names can be; says why.
    """
    try:
        if not path.is_file():
            return None
    except OSError as error:
        raise _unreadable(path, error) from error
    return read_file(path)


def write_whole(path: Path, data: bytes) -> None:
    """Write a file aside and rename it; whatever happens, nothing half-written is left.

    Args:
        path: where it shall be; its folder exists.
        data: its content.

    Raises:
        OSError: it cannot be written; what stood there before stands there still.
    """
    aside = _beside(path, "part")
    _remove(aside)
    try:
        _write_new(aside, data)
        aside.replace(path)
    except BaseException:
        _remove(aside)
        raise


def write_together(texts: Mapping[Path, Optional[str]]) -> None:
    """Write and remove files, all of them or none.

    Files are written aside, with the rights of those they replace, and renamed at the end. What a link points to is
    replaced, not the link. Folders are made where they are missing.

    Args:
        texts: content by path; None: the file shall not be there.

    Raises:
        ConfigError: one of them cannot be written or removed; says why. Everything is as it was before.
    """
    change = _Change()
    path = Path()
    try:
        for path, text in texts.items():
            change.prepare(path, text)
        for path in texts:
            change.carry_out(path)
    except OSError as error:
        change.undo()
        message = f"cannot be written: {error.strerror or error}; nothing was changed"
        raise ConfigError([Problem(str(path), 0, "", message)]) from error
    except BaseException:
        change.undo()
        raise
    change.finish()


class _Change:
    """Files on their way from what they were to what they shall be."""

    def __init__(self) -> None:
        self._targets: Dict[Path, Path] = {}
        self._new: Dict[Path, Path] = {}
        self._old: Dict[Path, Path] = {}
        self._placed: List[Path] = []
        self._folders: List[Path] = []

    def prepare(self, path: Path, text: Optional[str]) -> None:
        target = self._targets[path] = path if text is None else _behind_links(path)
        if target.is_dir():
            raise IsADirectoryError(None, "Is a directory")
        if text is None:
            return
        if target in self._new:
            raise FileExistsError(None, f"it and another of these files are {target}")
        self._make_folder(target.parent)
        self._new[target] = aside = _beside(target, "part")
        _remove(aside)
        _write_new(aside, text.encode("utf-8"))
        if target.exists():
            shutil.copymode(target, aside)

    def carry_out(self, path: Path) -> None:
        target = self._targets[path]
        if target.exists() or target.is_symlink():
            # Noted first, for Ctrl-C may come at any time.
            before = self._old[target] = _beside(target, "before")
            target.replace(before)
        if target in self._new:
            self._placed.append(target)
            self._new[target].replace(target)

    def undo(self) -> None:
        for target in self._placed:
            if target not in self._old:
                _remove(target)
        for target, before in self._old.items():
            if os.path.lexists(before):
                before.replace(target)
        for aside in self._new.values():
            _remove(aside)
        for folder in reversed(self._folders):
            try:
                folder.rmdir()
            except OSError:
                pass

    def finish(self) -> None:
        for before in self._old.values():
            _remove(before)

    def _make_folder(self, folder: Path) -> None:
        missing = []
        while not folder.exists():
            missing.append(folder)
            folder = folder.parent
        for each in reversed(missing):
            each.mkdir()
            self._folders.append(each)


def _behind_links(path: Path) -> Path:
    try:
        return path.resolve()
    except RuntimeError as error:
        raise OSError(None, "Too many levels of symbolic links") from error


def _write_new(path: Path, data: bytes) -> None:
    """Write a file where none is; a link in its place, whoever put it there, is not followed."""
    with path.open("xb") as file:
        file.write(data)


def _beside(target: Path, ending: str) -> Path:
    """Name a file beside another that no other process uses."""
    return target.with_name(f".{target.name}.{os.getpid()}.{ending}")


def _unreadable(path: Path, error: OSError) -> ConfigError:
    return ConfigError([Problem(str(path), 0, "", f"cannot be read: {error.strerror or error}")])


def _remove(path: Path) -> None:
    try:
        path.unlink()
    except OSError:
        pass
