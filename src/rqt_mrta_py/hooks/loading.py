"""Importing the plugins that discovery found, in its order."""

from __future__ import annotations

import importlib
import logging
import sys
from types import ModuleType
from typing import Iterable, NamedTuple, Tuple, Union

from rqt_mrta_py.config.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.errors import HookError, Problem
from rqt_mrta_py.hooks.manager import PluginManager

__all__ = ["LoadFailure", "load_plugin", "load_plugins"]

_log = logging.getLogger("rqt_mrta_py.hooks")


class LoadFailure(NamedTuple):
    """A plugin that could not be loaded.

    Attributes:
        package: that registers it.
        module: as registered.
        problem: where it is registered and what went wrong.
        error: to be raised by whoever needs the plugin.
    """

    package: str
    module: str
    problem: Problem
    error: HookError


def load_plugins(source: Union[Registry, Iterable[Registration]], manager: PluginManager) -> Tuple[LoadFailure, ...]:
    """Import and register plugins, in order; one that fails is left out and the others go on.

    Args:
        source: what was discovered; registrations that are no plugins are passed over.
        manager: takes the plugins in, each under its module's name; one registered twice counts once.

    Returns:
        The plugins that failed. Whether one was needed is the caller's to know.
    """
    registrations = source.registrations if isinstance(source, Registry) else source
    failures = []
    for registration in registrations:
        if registration.kind is not RegistrationKind.PLUGIN or registration.plugin in manager.names:
            continue
        try:
            load_plugin(registration, manager)
        except HookError as error:
            _log.info("event=plugin_failed package=%s module=%s", registration.package, registration.plugin)
            problem = Problem(str(registration.manifest), registration.line, registration.plugin, str(error))
            failures.append(LoadFailure(registration.package, registration.plugin, problem, error))
    return tuple(failures)


def load_plugin(registration: Registration, manager: PluginManager) -> None:
    """Import one plugin and register it.

    Args:
        registration: of kind PLUGIN.
        manager: takes the plugin in.

    Raises:
        HookError: the module cannot be imported, naming package, module and cause; or it does not keep the contract.
    """
    module_name, _, attribute = registration.plugin.partition(":")
    try:
        plugin: object = _import(module_name, registration)
        for part in attribute.split(".") if attribute else ():
            plugin = getattr(plugin, part)
    except (Exception, SystemExit) as error:
        raise HookError(
            f"package {registration.package!r}: plugin {registration.plugin!r} cannot be imported: "
            f"{type(error).__name__}: {error}"
        ) from error
    manager.register(plugin, registration.plugin)


def _import(module: str, registration: Registration) -> ModuleType:
    try:
        return importlib.import_module(module)
    except ImportError:
        source = registration.folder / "src"
        if str(source) in sys.path or not source.is_dir():
            raise
    # A package that is neither installed nor sourced; behind everything that is.
    sys.path.append(str(source))
    importlib.invalidate_caches()
    return importlib.import_module(module)
