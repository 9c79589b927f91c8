"""An exporter whose failures carry its name."""

from __future__ import annotations

from typing import Any, List, Mapping

from rqt_mrta_py.app.guard.asking import guarded, wishes_of
from rqt_mrta_py.app.outputs.folder import safe_file_name
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import Exporter, Heard, Subscription
from rqt_mrta_py.model import MissionRecord

__all__ = ["GuardedExporter"]


class GuardedExporter:
    """An exporter whose failures carry its name."""

    def __init__(self, name: str, exporter: Exporter) -> None:
        self._who = f"exporter {name}"
        self._exporter = exporter

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear."""
        return wishes_of(self._who, self._exporter)

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        guarded(self._who, self._exporter.hear, heard)

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        """Give the content of each file, checked to be that."""
        files: Any = guarded(self._who, self._exporter.export, record)
        if not isinstance(files, Mapping):
            raise HookError(f"{self._who}: answers {type(files).__name__}; a mapping of bytes by file name is accepted")
        for name, content in files.items():
            if not isinstance(name, str) or name != safe_file_name(name):
                raise HookError(
                    f"{self._who}: {name!r} is no file name; letters, digits, '.', '_' and '-' are accepted, no folders"
                )
            if not isinstance(content, bytes):
                raise HookError(f"{self._who}: {name}: is {type(content).__name__}; bytes are accepted")
        return files
