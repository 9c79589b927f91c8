"""The plugin manager: who implements which hook, checked against the contract, asked in a defined order.

pluggy keeps specifications and implementations; order and isolation are ours. pluggy would ask the plugin registered
last first and stop at the first exception; here plugins are asked one by one in the order of their registration,
so that every answer and every failure can be told with the plugin's name.
"""

from __future__ import annotations

import inspect
import logging
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Sequence, Tuple

import pluggy

from rqt_mrta_py.config.wording import accepted, nearest, shown
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks.parameters import ParameterProblem
from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.specs import PROJECT, HookSpecs

__all__ = ["PluginManager"]

_log = logging.getLogger("rqt_mrta_py.hooks")

_PREFIX = "mrta_"
_MARK = f"{PROJECT}_impl"
_ORDER_OPTIONS = ("tryfirst", "trylast", "hookwrapper", "wrapper")
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
        self._hooks: Dict[str, inspect.Signature] = {
            name: _signature(member)
            for name, member in vars(HookSpecs).items()
            if name.startswith(_PREFIX) and inspect.isfunction(member)
        }

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
        complaints = self._complaints(plugin)
        if complaints:
            raise HookError(f"plugin {name!r}: {'; '.join(complaints)}")
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
        if hook not in self._hooks or not hook.startswith(role):
            raise ValueError(f"{hook!r} is no {role}* hook; {accepted(hook, [h for h in self._hooks if role in h])}")
        wanted = tuple(self._hooks[hook].parameters)
        if set(wanted) != set(arguments):
            raise TypeError(f"{hook}{self._hooks[hook]} was called with ({', '.join(arguments)})")

    def _complaints(self, plugin: object) -> List[str]:
        complaints: List[str] = []
        taken: Dict[str, str] = {}
        for name in dir(plugin):
            if isinstance(inspect.getattr_static(plugin, name, None), property):
                continue
            member = getattr(plugin, name, None)
            if not inspect.isroutine(member):
                continue
            options = getattr(member, _MARK, None)
            if not isinstance(options, dict):
                if name.startswith(_PREFIX):
                    complaints.append(f"{name}{_signature(member)} is not marked; put @hookimpl above it")
                continue
            hook = options.get("specname") or name
            complaints.extend(self._misfits(hook, name, _signature(member), options))
            if hook in taken:
                complaints.append(f"{taken[hook]} and {name} both implement {hook}; one plugin answers a hook once")
            taken[hook] = name
        return complaints

    def _misfits(self, hook: str, name: str, signature: inspect.Signature, options: Mapping[str, Any]) -> List[str]:
        own = f"{name}{signature}"
        if hook not in self._hooks:
            match = nearest(hook, self._hooks)
            if match is None:
                return [f"{own} implements {hook}, which is no hook; {accepted(hook, self._hooks)}"]
            return [f"{own} implements {hook}, which is no hook; nearest is {match}{self._hooks[match]}"]
        contract = f"the contract says {hook}{self._hooks[hook]}"
        misfits = []
        for parameter in signature.parameters.values():
            if parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD):
                misfits.append(f"{own} takes {parameter}, which no hook fills in; {contract}")
            elif parameter.name not in self._hooks[hook].parameters:
                misfits.append(f"{own} asks for {parameter.name!r}, which the hook does not give; {contract}")
            elif parameter.default is not parameter.empty:
                misfits.append(f"{own} has a default for {parameter.name!r}, which then is never given; {contract}")
        misfits.extend(
            f"{own} asks for {option}, but plugins are asked in the order of discovery; leave it out"
            for option in _ORDER_OPTIONS
            if options.get(option)
        )
        return misfits


def _signature(member: Any) -> inspect.Signature:
    """Give a signature without annotations, and without the ``self`` of a specification."""
    signature = inspect.signature(member)
    parameters = [
        parameter.replace(annotation=parameter.empty)
        for parameter in signature.parameters.values()
        if parameter.name != "self"
    ]
    return signature.replace(parameters=parameters, return_annotation=inspect.Signature.empty)


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
