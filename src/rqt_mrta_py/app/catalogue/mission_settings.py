"""What can be set of an application's mission; imports no plugins but those that make missions."""

from __future__ import annotations

import os
from typing import Any, Dict, List, NamedTuple, Optional

from rqt_mrta_py.app.catalogue.plugins import plugin_entries, surveyed
from rqt_mrta_py.app.loading.environment import plugin_settings
from rqt_mrta_py.config.discovery.registration import Registry

__all__ = ["MissionSettings", "mission_settings"]

_HOOK = "mrta_register_mission_makers"


class MissionSettings(NamedTuple):
    """What an application's maker of missions says of itself.

    Attributes:
        rows: each setting's ``name``, ``default`` and ``text``.
        robots: how many take part where nobody says how many; None for all.
    """

    rows: List[Dict[str, Any]]
    robots: Optional[int]


def mission_settings(registry: Registry, application: str) -> MissionSettings:
    """Tell what can be set of an application's mission.

    Args:
        registry: what was found.
        application: its package.

    Raises:
        UsageError: the environment says something of plugins that makes no sense.
        HookError: a plugin that makes missions does not keep the contract.
    """
    from rqt_mrta_py.hooks.loading import load_plugins
    from rqt_mrta_py.hooks.manager import PluginManager

    entries = [entry for entry in plugin_entries(registry, plugin_settings(os.environ).blocked) if not entry.blocked]
    makers = {plugin for plugin, hooks in surveyed(entries).items() if _HOOK in (hooks or ())}
    if not makers:
        return MissionSettings([], None)
    manager = PluginManager()
    load_plugins(registry, manager, only=makers)
    maker = manager.registered(_HOOK).get(application)
    if maker is None:
        return MissionSettings([], None)
    return MissionSettings([dict(setting._asdict()) for setting in maker.settings], maker.robots)
