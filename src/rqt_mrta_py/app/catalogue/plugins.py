"""Which plugins there are and what they implement, told without importing any."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.loading.blocking import is_blocked
from rqt_mrta_py.app.loading.own_plugins import OWN_PACKAGE, OWN_PLUGINS
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry

__all__ = ["PluginEntry", "hook_entries", "plugin_entries", "surveyed"]


@dataclass(frozen=True)
class PluginEntry:
    """One plugin.

    Attributes:
        plugin: ``module`` or ``module:object``.
        package: that registers it.
        folder: of the package.
        blocked: True if the user wants it left out.
    """

    plugin: str
    package: str
    folder: Path
    blocked: bool = False


def plugin_entries(registry: Registry, blocked: Sequence[str]) -> List[PluginEntry]:
    """List all plugins, those of this project's own rooms last.

    Args:
        registry: what was found.
        blocked: names of packages and modules that the user wants left out.

    Returns:
        Entries in the order in which plugins are asked; one registered twice counts once.
    """
    found: Dict[str, PluginEntry] = {}
    for registration in registry.of_kind(RegistrationKind.PLUGIN):
        found.setdefault(registration.plugin, _entry(registration, blocked))
    rooms = Path(__file__).resolve().parents[2]
    return [*found.values(), *(PluginEntry(module, OWN_PACKAGE, rooms) for module in OWN_PLUGINS)]


def surveyed(entries: Sequence[PluginEntry]) -> Dict[str, Optional[Tuple[str, ...]]]:
    """Read what plugins implement.

    Args:
        entries: whose source is read.

    Returns:
        Names of hooks by plugin, in the order of the contract; None where there is no source to read.
    """
    from rqt_mrta_py.hooks.survey import implemented_hooks

    return {entry.plugin: implemented_hooks(entry.plugin, entry.folder) for entry in entries}


def hook_entries(entries: Sequence[PluginEntry]) -> Dict[str, List[str]]:
    """Tell who implements each hook.

    Args:
        entries: plugins; blocked ones count for nothing.

    Returns:
        Plugins by hook, in the order in which they are asked; hooks in the order of the contract.
    """
    from rqt_mrta_py.hooks.contract import HOOKS

    implemented = surveyed([entry for entry in entries if not entry.blocked])
    return {hook: [plugin for plugin, hooks in implemented.items() if hook in (hooks or ())] for hook in HOOKS}


def _entry(registration: Registration, blocked: Sequence[str]) -> PluginEntry:
    return PluginEntry(
        registration.plugin, registration.package, registration.folder, is_blocked(registration, blocked)
    )
