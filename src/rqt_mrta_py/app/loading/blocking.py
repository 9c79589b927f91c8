"""Plugins that the user wants left out: neither imported nor registered."""

from __future__ import annotations

import logging
from typing import Dict, Sequence, Tuple

from rqt_mrta_py.app.loading.environment import BLOCK
from rqt_mrta_py.app.loading.own_plugins import OWN_PACKAGE
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.wording import accepted

__all__ = ["is_blocked", "warn_of_blocking"]

_log = logging.getLogger("rqt_mrta_py.app")


def is_blocked(registration: Registration, blocked: Sequence[str]) -> bool:
    """Tell whether a plugin is to be left out.

    Args:
        registration: of kind PLUGIN; anything else is never blocked.
        blocked: names of packages, of modules, of modules with everything below them.
    """
    return any(name in blocked for name in _names(registration))


def warn_of_blocking(registry: Registry, blocked: Sequence[str]) -> None:
    """Log, a line each, the names that block nothing.

    Args:
        registry: what was found.
        blocked: as the user gave them.
    """
    known: Dict[str, None] = {}
    for registration in registry.registrations:
        known.update(dict.fromkeys(_names(registration)))
    for name in blocked:
        if name.partition(".")[0] == OWN_PACKAGE:
            _log.warning("%s: %s belongs to this project itself and cannot be blocked", BLOCK, name)
        elif name not in known:
            _log.warning("%s: %s is no plugin's module or package; %s", BLOCK, name, accepted(name, known))


def _names(registration: Registration) -> Tuple[str, ...]:
    """Give the names by which a plugin can be blocked; none for what is no plugin."""
    if registration.kind is not RegistrationKind.PLUGIN:
        return ()
    module = registration.plugin.partition(":")[0]
    parts = module.split(".")
    modules = [".".join(parts[:count]) for count in range(1, len(parts) + 1)]
    return tuple(dict.fromkeys((registration.package, *modules, registration.plugin)))
