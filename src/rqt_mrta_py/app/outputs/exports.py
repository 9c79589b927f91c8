"""Files in other programs' formats, as exporters give them."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Sequence

from rqt_mrta_py.app.guard import GuardedExporter, GuardedMessageExporter, made
from rqt_mrta_py.app.outputs.asked_for import asked_for
from rqt_mrta_py.app.outputs.folder import OutputFolder, safe_file_name
from rqt_mrta_py.hooks import Exporter, ExporterFactory, ExporterSetup
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Mission, MissionRecord

__all__ = ["exporters_for", "write_exports"]


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
    chosen = asked_for("--export", "there is no such exporter", names, factories)
    setup = ExporterSetup(mission)
    return {name: _exporter(name, made(f"exporter {name}", factories[name], setup)) for name in chosen}


def _exporter(name: str, part: Any) -> Exporter:
    """Guard an exporter of either kind: what takes messages has ``take``."""
    who = f"exporter {name}"
    if hasattr(part, "take"):
        return GuardedMessageExporter(name, made(who, lambda _: part, None, "begin", "end"))
    return GuardedExporter(name, made(who, lambda _: part, None, "subscriptions", "hear", "export"))


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
