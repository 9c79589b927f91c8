"""The one place that wires: registry, plugins, codec."""

from __future__ import annotations

import os
from typing import List, Mapping, Optional

from rqt_mrta_py.app.guard import guarded_renderer
from rqt_mrta_py.config import Registry, discover
from rqt_mrta_py.errors import HookError, Problem
from rqt_mrta_py.hooks import Codec, Renderer
from rqt_mrta_py.hooks.loading import load_plugins
from rqt_mrta_py.hooks.manager import PluginManager

__all__ = ["Host", "compose", "registry_only"]


class Host:
    """What every command works with.

    Attributes:
        registry: which packages take part, without any plugin's code imported.
        manager: the plugins, loaded and checked.
        problems: what is wrong with packages and plugins that were skipped.
    """

    def __init__(self, registry: Registry, manager: PluginManager, problems: List[Problem]) -> None:
        self.registry = registry
        self.manager = manager
        self.problems = problems

    def codec(self) -> Codec:
        """Make a codec that knows the message types of every package found."""
        from rqt_mrta_py.transport import RosCodec

        return RosCodec(self._definition)

    def renderer(self, name: str) -> Renderer:
        """Give a renderer by name.

        Raises:
            HookError: nobody registers it.
        """
        renderers: Mapping[str, Renderer] = self.manager.registered("mrta_register_renderers")
        if name not in renderers:
            raise HookError(f"{name}: no plugin draws such a picture; there are: {', '.join(sorted(renderers))}")
        return guarded_renderer(name, renderers[name])

    def _definition(self, type_name: str) -> Optional[str]:
        path = self.registry.message_file(type_name)
        return None if path is None else path.read_text(encoding="utf-8")


def registry_only() -> Registry:
    """Look for packages without importing any plugin's code."""
    return discover(os.environ)


def compose() -> Host:
    """Look for packages and load every plugin: this project's own rooms last, so that a package may replace a name."""
    from rqt_mrta_py.render import plugin as render_plugin
    from rqt_mrta_py.sim import plugin as sim_plugin
    from rqt_mrta_py.supervisor import plugin as supervisor_plugin

    registry = registry_only()
    manager = PluginManager()
    problems = [*registry.problems, *load_plugins(registry, manager)]
    for module in (sim_plugin, supervisor_plugin, render_plugin):
        manager.register(module, module.__name__)
    return Host(registry, manager, problems)
