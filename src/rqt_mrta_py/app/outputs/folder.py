"""The folder that a run or review leaves: nothing outside it, nothing half-written in it."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, Iterable, Mapping, Optional

from rqt_mrta_py.config.files import write_whole
from rqt_mrta_py.errors import MrtaError, UsageError

__all__ = ["OutputError", "OutputFolder", "safe_file_name"]

_PICTURES = "[0-9]*.[0-9][0-9][0-9].png"


class OutputError(MrtaError):
    """A file of the outputs cannot be written."""


def safe_file_name(text: str) -> str:
    """Make a file name of any text: letters, digits, ``.``, ``_`` and ``-`` stay, the rest becomes ``_``."""
    return re.sub(r"[^A-Za-z0-9._-]", "_", text).strip(".") or "_"


class OutputFolder:
    """The folder of one run or review."""

    def __init__(self, path: Path) -> None:
        self.path = path

    @classmethod
    def create(cls, explicit: Optional[Path], name: str, force: bool) -> OutputFolder:
        """Choose and make the folder.

        Args:
            explicit: what the user asked for; None to choose ``runs/<name>``, then ``-2``, ``-3``, ... in the caller's
                folder.
            name: of the run, any text.
            force: allow an explicit folder that is not empty.

        Raises:
            UsageError: the explicit folder is not empty and force is not given, or it is a file.
            OutputError: it cannot be made.
        """
        try:
            if explicit is not None:
                return cls._explicit(explicit, force)
            runs = Path.cwd() / "runs"
            runs.mkdir(exist_ok=True)
            number = 1
            while True:
                path = runs / (safe_file_name(name) + ("" if number == 1 else f"-{number}"))
                try:
                    path.mkdir()
                    return cls(path)
                except FileExistsError:
                    number += 1
        except OSError as error:
            raise OutputError(
                f"{error.filename or 'runs'}: the folder for the outputs cannot be made: {error.strerror}; "
                "give another one with --out"
            ) from error

    @classmethod
    def _explicit(cls, path: Path, force: bool) -> OutputFolder:
        if path.exists() and not path.is_dir():
            raise UsageError(f"--out {path}: is a file; give a folder")
        if path.is_dir() and any(path.iterdir()) and not force:
            raise UsageError(f"--out {path}: the folder is not empty; give another one, or --force to write into it")
        path.mkdir(parents=True, exist_ok=True)
        return cls(path)

    def monitor(self, wanted: bool) -> Optional[Path]:
        """Make the folder of the monitor pictures; those of an earlier run go, and nothing else does.

        Args:
            wanted: False if there will be no pictures; then an earlier run's folder and pictures of the whole go too.

        Returns:
            The folder; None if it is not wanted.
        """
        path = self.path / "monitor"
        try:
            for picture in path.glob(_PICTURES):
                picture.unlink()
            if wanted:
                path.mkdir(exist_ok=True)
                return path
            if path.is_dir() and not any(path.iterdir()):
                path.rmdir()
            self._remove("dashboard.png")
            self._remove("communication.png")
        except OSError as error:
            raise OutputError(f"{error.filename}: cannot be replaced: {error.strerror}") from error
        return None

    def film(self, wanted: bool) -> Optional[Path]:
        """Give the path of the film; one of an earlier run goes.

        Args:
            wanted: False if there will be none.
        """
        try:
            self._remove("monitor.webm")
        except OSError as error:
            raise OutputError(f"{error.filename}: cannot be replaced: {error.strerror}") from error
        return self.path / "monitor.webm" if wanted else None

    def _remove(self, name: str) -> None:
        path = self.path / name
        if path.exists():
            path.unlink()

    def write_json(self, name: str, value: Mapping[str, Any]) -> None:
        """Write one JSON document, keys in their given order."""
        self.write_text(name, json.dumps(value, indent=2, ensure_ascii=False, allow_nan=False) + "\n")

    def write_lines(self, name: str, values: Iterable[Mapping[str, Any]]) -> None:
        """Write one JSON document a line."""
        lines = [json.dumps(value, ensure_ascii=False, allow_nan=False) + "\n" for value in values]
        self.write_text(name, "".join(lines))

    def write_text(self, name: str, text: str) -> None:
        """Write a text file."""
        self.write_bytes(name, text.encode("utf-8"))

    def write_bytes(self, name: str, content: bytes) -> None:
        """Write a file, making the folders it stands in.

        Args:
            name: relative to this folder, parts joined by ``/``.
            content: of the file.
        """
        path = self.path / name
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(path, content)
        except OSError as error:
            raise OutputError(f"{path}: cannot be written: {error.strerror}") from error
