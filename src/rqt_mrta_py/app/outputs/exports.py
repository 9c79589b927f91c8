"""Files in other programs' formats, as exporters give them."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Sequence

from rqt_mrta_py.app.guard import guarded, made, wishes_of
from rqt_mrta_py.app.outputs.folder import OutputFolder, safe_file_name
from rqt_mrta_py.errors import HookError, UsageError
from rqt_mrta_py.hooks import Exporter, ExporterFactory, ExporterSetup, Heard, Subscription
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission, MissionRecord

__all__ = ["exporters_for", "write_exports"]


class _GuardedExporter:
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


def exporters_for(mission: Mission, names: Sequence[str], manager: PluginManager) -> Dict[str, Exporter]:
    """Make the exporters that the user asks for.

    Args:
        mission: as far as it is known.
        names: of exporters; one named twice counts once.
        manager: plugins, loaded.

    Returns:
        By name, in the order given.

    Raises:
        UsageError: there is no such exporter.
        HookError: one cannot be made; names it.
    """
    if not names:
        return {}
    factories: Mapping[str, ExporterFactory] = manager.registered("mrta_register_exporters")
    for name in names:
        if name not in factories:
            known = ", ".join(sorted(factories)) or "none"
            raise UsageError(f"--export {name}: there is no such exporter; there are: {known}")
    setup = ExporterSetup(mission)
    needs = ("subscriptions", "hear", "export")
    return {name: _GuardedExporter(name, made(f"exporter {name}", factories[name], setup, *needs)) for name in names}


def write_exports(folder: OutputFolder, exporters: Mapping[str, Exporter], record: MissionRecord) -> None:
    """Write the files of every exporter to ``export/<its name>/``.

    Args:
        folder: of the outputs.
        exporters: by name, all messages heard.
        record: everything known of the mission.

    Raises:
        HookError: an exporter raises, or gives what are no files; names it. Files of those before it stay.
        OutputError: a file cannot be written.
    """
    for name, exporter in exporters.items():
        files = exporter.export(record)
        for file_name, content in files.items():
            folder.write_bytes(f"export/{safe_file_name(name)}/{file_name}", content)
