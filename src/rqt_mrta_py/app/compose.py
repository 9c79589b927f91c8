"""The one place that wires: registry, plugins, codec."""

from __future__ import annotations

import importlib
import logging
import os
import sys
import time
from typing import Dict, Hashable, List, Mapping, Optional

from rqt_mrta_py.app.guard import guarded_renderer
from rqt_mrta_py.app.loading.blocking import is_blocked, warn_of_blocking
from rqt_mrta_py.app.loading.environment import plugin_settings
from rqt_mrta_py.app.loading.own_plugins import OWN_PLUGINS
from rqt_mrta_py.app.loading.registry import registry_only
from rqt_mrta_py.config.discovery.registration import Registry
from rqt_mrta_py.errors import HookError, Problem
from rqt_mrta_py.hooks import Codec, MadeMission, Renderer
from rqt_mrta_py.hooks.loading import load_plugins
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.hooks.patience import Patience
from rqt_mrta_py.hooks.trace import HookTrace

__all__ = ["Host", "compose"]


class Host:
    """What every command works with.

    Attributes:
        registry: which packages take part, without any plugin's code imported.
        manager: the plugins, loaded and checked.
        problems: what is wrong with packages and plugins that were skipped.
        made: missions that makers have made, by what they were asked.
    """

    def __init__(self, registry: Registry, manager: PluginManager, problems: List[Problem]) -> None:
        self.registry = registry
        self.manager = manager
        self.problems = problems
        self.made: Dict[Hashable, MadeMission] = {}

    def codec(self) -> Codec:
        """Make a codec that knows the message types of every package found."""
        from rqt_mrta_py.transport import RosCodec

        return RosCodec(self.registry.message_text)

    def renderer(self, name: str) -> Renderer:
        """Give a renderer by name.

        Raises:
            HookError: nobody registers it.
        """
        renderers: Mapping[str, Renderer] = self.manager.registered("mrta_register_renderers")
        if name not in renderers:
            raise HookError(f"{name}: no plugin draws such a picture; there are: {', '.join(sorted(renderers))}")
        return guarded_renderer(name, renderers[name])


def compose(registry: Optional[Registry] = None, forgiving: bool = False) -> Host:
    """Look for packages and load every plugin: this project's own rooms last, so that a package may replace a name.

    Args:
        registry: the packages; None: those that the environment names.
        forgiving: leave a plugin out that does not keep the contract, and say so among the problems.

    Raises:
        UsageError: the environment says something of plugins that makes no sense.
        HookError: a plugin does not keep the contract, unless forgiving.
    """
    settings = plugin_settings(os.environ)
    registry = registry_only() if registry is None else registry
    warn_of_blocking(registry, settings.blocked)
    patience = Patience() if settings.patience is None else Patience(settings.patience)
    manager = PluginManager(patience, _trace() if settings.trace else None)
    wanted = [each for each in registry.registrations if not is_blocked(each, settings.blocked)]
    problems = [*registry.problems, *load_plugins(wanted, manager, forgiving)]
    for name in OWN_PLUGINS:
        manager.register(importlib.import_module(name), name)
    return Host(registry, manager, problems)


def _trace() -> HookTrace:
    """Make a trace that writes to stderr, whatever else is logged."""
    logger = logging.getLogger("rqt_mrta_py.hooks.trace")
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(logging.Formatter("%(name)s: %(message)s"))
    logger.handlers[:] = [handler]
    logger.propagate = False
    logger.setLevel(logging.INFO)
    return HookTrace(logger, time.perf_counter)
