"""Importing plugins: from registrations to a plugin manager."""

from __future__ import annotations

import importlib
import logging
import sys
from pathlib import Path
from types import ModuleType
from typing import Container, Iterable, Mapping, Optional, Tuple, Union

from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.errors import HookError, Problem
from rqt_mrta_py.hooks.manager import PluginManager

__all__ = ["load_plugin", "load_plugins"]

_log = logging.getLogger("rqt_mrta_py.hooks")


def load_plugins(
    source: Union[Registry, Iterable[Registration]],
    manager: PluginManager,
    forgiving: bool = False,
    only: Optional[Container[str]] = None,
) -> Tuple[Problem, ...]:
    """Import and register plugins, in order; one that cannot be imported is left out and the others go on.

    A plugin may import the packages of others, whatever their order.

    Args:
        source: what was discovered; registrations that are no plugins are passed over.
        manager: takes the plugins in, each under its module's name; one registered twice counts once.
        forgiving: leave out those too that do not keep the contract.
        only: plugins that are wanted, though they may import what others bring; None for all.

    Returns:
        What was left out, one problem for each plugin. Whether one was needed is the caller's to know.

    Raises:
        HookError: a plugin does not keep the contract, a mistake of its author; told before anything is done, unless
            forgiving.
    """
    registrations = tuple(source.registrations if isinstance(source, Registry) else source)
    sources = {
        each.package: each.folder / "src" for each in reversed(registrations) if each.kind is RegistrationKind.PLUGIN
    }
    failures = []
    for registration in registrations:
        if registration.kind is not RegistrationKind.PLUGIN or registration.plugin in manager.names:
            continue
        if only is not None and registration.plugin not in only:
            continue
        is_imported = False
        try:
            plugin = _imported(registration, manager, sources)
            is_imported = True
            manager.register(plugin, registration.plugin)
        except HookError as error:
            if is_imported and not forgiving:
                raise
            _log.info("event=plugin_failed package=%s module=%s", registration.package, registration.plugin)
            failures.append(Problem(str(registration.manifest), registration.line, "", str(error)))
    return tuple(failures)


def load_plugin(registration: Registration, manager: PluginManager) -> None:
    """Import one plugin and register it.

    Args:
        registration: of kind PLUGIN.
        manager: takes the plugin in.

    Raises:
        HookError: the module cannot be imported, naming package, module and cause; or it does not keep the contract.
    """
    own = {registration.package: registration.folder / "src"}
    manager.register(_imported(registration, manager, own), registration.plugin)


def _imported(registration: Registration, manager: PluginManager, sources: Mapping[str, Path]) -> object:
    module_name, _, attribute = registration.plugin.partition(":")
    manager.patience.know(module_name)
    try:
        with manager.patience.limit("importing it"):
            plugin: object = _import(module_name, registration, sources)
            for part in attribute.split(".") if attribute else ():
                plugin = getattr(plugin, part)
    except (Exception, SystemExit) as error:
        raise HookError(
            f"package {registration.package!r}: plugin {registration.plugin!r} cannot be imported: "
            f"{type(error).__name__}: {error}"
        ) from error
    return plugin


def _import(module: str, registration: Registration, sources: Mapping[str, Path]) -> ModuleType:
    """Import a module; packages that are neither installed nor sourced go onto the path, behind everything that is."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        if not _append(registration.folder / "src", module) and not _append_missing(error, sources):
            raise
    while True:
        try:
            return importlib.import_module(module)
        except ModuleNotFoundError as error:
            if not _append_missing(error, sources):
                raise


def _append_missing(error: ImportError, sources: Mapping[str, Path]) -> bool:
    """Put the package of another plugin on the path if it is what an import lacked."""
    package = (error.name or "").partition(".")[0]
    return package in sources and _append(sources[package], package)


def _append(source: Path, module: str) -> bool:
    """Put a folder on the path, once; tell whether that was new."""
    if str(source) in sys.path or not source.is_dir():
        return False
    # Where the package's own folder lies in the current one, Python may have taken it for a namespace of its name.
    name = module.partition(".")[0]
    if name in sys.modules and getattr(sys.modules[name], "__file__", None) is None:
        del sys.modules[name]
    sys.path.append(str(source))
    importlib.invalidate_caches()
    return True
