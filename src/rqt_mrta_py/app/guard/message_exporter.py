"""An exporter of messages whose failures carry its name, and whose files are there whole or not at all."""

from __future__ import annotations

import os
from pathlib import Path
from typing import BinaryIO, Callable, Dict, List, Mapping

from rqt_mrta_py.app.guard.asking import guarded
from rqt_mrta_py.app.outputs.folder import OutputError, OutputFolder, safe_file_name
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import Heard, MessageExporter, Stamped, Subscription
from rqt_mrta_py.model import MissionRecord

__all__ = ["GuardedMessageExporter"]


class GuardedMessageExporter:
    """An exporter of messages among others: it hears nothing while the mission goes on, and gives no bytes.

    Args:
        name: of the exporter.
        exporter: to be guarded.
    """

    def __init__(self, name: str, exporter: MessageExporter) -> None:
        self.name = name
        self._who = f"exporter {name}"
        self._exporter = exporter
        self._folder = Path()
        self._files: Dict[str, BinaryIO] = {}

    def subscriptions(self) -> List[Subscription]:
        """Want to hear nothing."""
        return []

    def hear(self, heard: Heard) -> None:
        """Hear nothing."""

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        """Give no files; they are written message by message."""
        return {}

    def begin(self, record: MissionRecord, folder: OutputFolder) -> None:
        """Begin the files below a folder of outputs."""
        self._folder = folder.path / "export" / safe_file_name(self.name)
        self._ask(self._exporter.begin, record, self._create)

    def take(self, stamped: Stamped) -> None:
        """Take the next message."""
        self._ask(self._exporter.take, stamped)

    def end(self) -> None:
        """Complete the files."""
        self._ask(self._exporter.end)
        for name, file in self._files.items():
            self._ask(file.close, what=name)

    def keep(self) -> None:
        """Give the files, which are complete, their names."""
        for name in list(self._files):
            self._ask(self._aside(name).replace, self._folder / name, what=name)
            del self._files[name]

    def discard(self) -> None:
        """Take away what is not complete."""
        for name, file in self._files.items():
            try:
                file.close()
            except OSError:
                # What could not be written is not wanted any more.
                pass
            self._aside(name).unlink()
        self._files.clear()

    def _create(self, name: str) -> BinaryIO:
        if not isinstance(name, str) or name != safe_file_name(name):
            raise HookError(
                f"{self._who}: {name!r} is no file name; letters, digits, '.', '_' and '-' are accepted, no folders"
            )
        if name in self._files:
            raise HookError(f"{self._who}: creates {name} twice")
        path = self._aside(name)
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            self._files[name] = path.open("wb")
        except OSError as error:
            raise OutputError(f"{self._folder / name}: cannot be written: {error.strerror}") from error
        return self._files[name]

    def _ask(self, ask: Callable[..., object], *arguments: object, what: str = "") -> None:
        def carefully(*passed: object) -> None:
            try:
                ask(*passed)
            except OSError as error:
                path = self._folder / what
                raise OutputError(f"{path}: cannot be written: {error.strerror or error}") from error

        guarded(self._who, carefully, *arguments)

    def _aside(self, name: str) -> Path:
        return self._folder / f".{name}.{os.getpid()}.part"
