"""The plugin manager: who implements which hook, checked against the contract, asked in a defined order.

pluggy keeps specifications and implementations; order and isolation are ours. pluggy would ask the plugin registered
last first and stop at the first exception; here plugins are asked one by one in the order of their registration,
so that every answer and every failure can be told with the plugin's name.
"""

from __future__ import annotations

import importlib
import inspect
import logging
import sys
from types import ModuleType
from typing import Any, Callable, Dict, Iterable, List, Mapping, NamedTuple, Sequence, Tuple, Union

import pluggy

from rqt_mrta_py.config.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.config.wording import accepted, shown
from rqt_mrta_py.errors import HookError, Problem
from rqt_mrta_py.hooks.contract import HOOKS, contract_breaches
from rqt_mrta_py.hooks.parameters import ParameterProblem
from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.specs import PROJECT, HookSpecs

__all__ = ["PluginManager", "load_plugin", "load_plugins"]

_log = logging.getLogger("rqt_mrta_py.hooks")

_REGISTERED_TYPES: Mapping[str, type] = {"mrta_register_robot_models": RobotModel}
"""Hooks that register values of a type; all others register something to be called."""


class _Implementation(NamedTuple):
    """One plugin's function for one hook."""

    plugin: str
    function: Callable[..., Any]
    arguments: Tuple[str, ...]


class _Pluggy(pluggy.PluginManager):
    """pluggy, without looking behind properties of a plugin."""

    def parse_hookimpl_opts(self, plugin: Any, name: str) -> Any:
        """Give the options of a marked implementation; None for any other attribute."""
        if isinstance(inspect.getattr_static(plugin, name, None), property):
            return None
        return super().parse_hookimpl_opts(plugin, name)


class PluginManager:
    """Knows all plugins of one command.

    Plugins are asked in the order of their registration. Of two plugins that register one name, the first wins.
    """

    def __init__(self) -> None:
        self._pluggy = _Pluggy(PROJECT)
        self._pluggy.add_hookspecs(HookSpecs)
        self._names: List[str] = []

    @property
    def names(self) -> Tuple[str, ...]:
        """The registered plugins, in order."""
        return tuple(self._names)

    def register(self, plugin: object, name: str) -> None:
        """Take a plugin in.

        Args:
            plugin: a module or object with functions marked by ``hookimpl``.
            name: by which messages speak of it.

        Raises:
            HookError: the name or the plugin is there already, or an implementation does not keep the contract;
                names the plugin, the hook and both signatures. Nothing of the plugin is registered then.
        """
        if name in self._names:
            raise HookError(f"plugin {name!r} is registered already")
        breaches = contract_breaches(plugin)
        if breaches:
            raise HookError(f"plugin {name!r}: {'; '.join(breaches)}")
        try:
            self._pluggy.register(plugin, name)
        except ValueError as error:
            raise HookError(f"plugin {name!r} is registered already, under another name") from error
        except pluggy.PluginValidationError as error:
            raise HookError(f"plugin {name!r}: {error}") from error
        self._names.append(name)
        _log.debug("event=registered plugin=%s", name)

    def registered(self, hook: str) -> Dict[str, Any]:
        """Join what all plugins register by one hook.

        Args:
            hook: ``mrta_register_*``.

        Returns:
            What was registered by name, in the order of plugins; of two that register one name the first wins and
            the other is logged.

        Raises:
            HookError: a plugin raised, or returned what the contract does not allow; names plugin and hook.
        """
        self._expect(hook, "mrta_register_", {})
        joined: Dict[str, Any] = {}
        owners: Dict[str, str] = {}
        for implementation in self._implementations(hook):
            answer = _ask(implementation, hook, {})
            if not isinstance(answer, Mapping):
                raise _misfit(implementation, hook, f"returned {shown(answer)}; a mapping by name is needed")
            for name, value in answer.items():
                _check_registered(implementation, hook, name, value)
                if name in joined:
                    _log.warning(
                        "event=collision hook=%s name=%s kept=%s dropped=%s",
                        hook,
                        name,
                        owners[name],
                        implementation.plugin,
                    )
                    continue
                joined[name] = value
                owners[name] = implementation.plugin
        return joined

    def problems(self, hook: str, **arguments: Any) -> Tuple[ParameterProblem, ...]:
        """Join what all plugins find wrong.

        Args:
            hook: ``mrta_check_*``.
            **arguments: exactly those of the hook.

        Returns:
            The problems, in the order of plugins.

        Raises:
            HookError: a plugin raised, or returned what the contract does not allow; names plugin and hook.
        """
        self._expect(hook, "mrta_check_", arguments)
        found: List[ParameterProblem] = []
        for implementation in self._implementations(hook):
            answer = _ask(implementation, hook, arguments)
            if not isinstance(answer, Sequence) or isinstance(answer, (str, bytes)):
                raise _misfit(implementation, hook, f"returned {shown(answer)}; a sequence of problems is needed")
            for problem in answer:
                if not isinstance(problem, ParameterProblem):
                    raise _misfit(implementation, hook, f"returned {shown(problem)}; a ParameterProblem is needed")
                found.append(problem)
        return tuple(found)

    def notify(self, hook: str, **arguments: Any) -> None:
        """Tell all observers; one that raises is logged by name, the others are told all the same.

        Args:
            hook: ``mrta_on_*``.
            **arguments: exactly those of the hook.
        """
        self._expect(hook, "mrta_on_", arguments)
        for implementation in self._implementations(hook):
            try:
                _call(implementation, hook, arguments)
            except Exception:  # noqa: BLE001 - an observer never stops what it observes
                _log.exception("event=observer_failed plugin=%s hook=%s", implementation.plugin, hook)

    def _implementations(self, hook: str) -> List[_Implementation]:
        found = {
            implementation.plugin_name: _Implementation(
                implementation.plugin_name, implementation.function, tuple(implementation.argnames)
            )
            for implementation in getattr(self._pluggy.hook, hook).get_hookimpls()
        }
        return [found[name] for name in self._names if name in found]

    def _expect(self, hook: str, role: str, arguments: Mapping[str, Any]) -> None:
        if hook not in HOOKS or not hook.startswith(role):
            raise ValueError(f"{hook!r} is no {role}* hook; {accepted(hook, [h for h in HOOKS if role in h])}")
        wanted = tuple(HOOKS[hook].parameters)
        if set(wanted) != set(arguments):
            raise TypeError(f"{hook}{HOOKS[hook]} was called with ({', '.join(arguments)})")


def _call(implementation: _Implementation, hook: str, arguments: Mapping[str, Any]) -> Any:
    _log.debug("event=call plugin=%s hook=%s", implementation.plugin, hook)
    return implementation.function(*(arguments[name] for name in implementation.arguments))


def _ask(implementation: _Implementation, hook: str, arguments: Mapping[str, Any]) -> Any:
    try:
        return _call(implementation, hook, arguments)
    except Exception as error:
        raise _misfit(implementation, hook, f"raised {type(error).__name__}: {error}") from error


def _misfit(implementation: _Implementation, hook: str, message: str) -> HookError:
    return HookError(f"plugin {implementation.plugin!r}: {hook} {message}")


def _check_registered(implementation: _Implementation, hook: str, name: object, value: object) -> None:
    if not isinstance(name, str) or not name:
        raise _misfit(implementation, hook, f"registers under {shown(name)}; a name is needed")
    wanted = _REGISTERED_TYPES.get(hook)
    if wanted is None and not callable(value):
        raise _misfit(implementation, hook, f"registers {name!r} as {shown(value)}; something callable is needed")
    if wanted is not None and not isinstance(value, wanted):
        raise _misfit(implementation, hook, f"registers {name!r} as {shown(value)}; a {wanted.__name__} is needed")


def load_plugins(source: Union[Registry, Iterable[Registration]], manager: PluginManager) -> Tuple[Problem, ...]:
    """Import and register plugins, in order; one that cannot be imported is left out and the others go on.

    Args:
        source: what was discovered; registrations that are no plugins are passed over.
        manager: takes the plugins in, each under its module's name; one registered twice counts once.

    Returns:
        What could not be imported, one problem for each plugin. Whether one was needed is the caller's to know.

    Raises:
        HookError: a plugin does not keep the contract; a mistake of its author, told before anything is done.
    """
    registrations = source.registrations if isinstance(source, Registry) else source
    failures = []
    for registration in registrations:
        if registration.kind is not RegistrationKind.PLUGIN or registration.plugin in manager.names:
            continue
        try:
            plugin = _imported(registration)
        except HookError as error:
            _log.info("event=plugin_failed package=%s module=%s", registration.package, registration.plugin)
            failures.append(Problem(str(registration.manifest), registration.line, "", str(error)))
        else:
            manager.register(plugin, registration.plugin)
    return tuple(failures)


def load_plugin(registration: Registration, manager: PluginManager) -> None:
    """Import one plugin and register it.

    Args:
        registration: of kind PLUGIN.
        manager: takes the plugin in.

    Raises:
        HookError: the module cannot be imported, naming package, module and cause; or it does not keep the contract.
    """
    manager.register(_imported(registration), registration.plugin)


def _imported(registration: Registration) -> object:
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
    return plugin


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
