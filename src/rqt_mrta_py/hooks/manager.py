"""The plugin manager: who implements which hook, checked against the contract, asked in a defined order.

pluggy keeps specifications and implementations; order and isolation are ours. pluggy would ask the plugin registered
last first and stop at the first exception; here plugins are asked one by one in the order of their registration,
so that every answer and every failure can be told with the plugin's name.
"""

from __future__ import annotations

import inspect
import logging
from types import ModuleType
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple

import pluggy

from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks.answers import registration_breach
from rqt_mrta_py.hooks.contract import HOOKS, contract_breaches
from rqt_mrta_py.hooks.parameters import ParameterProblem
from rqt_mrta_py.hooks.patience import OutOfPatienceError, Patience
from rqt_mrta_py.hooks.specs import PROJECT, HookSpecs
from rqt_mrta_py.hooks.trace import HookTrace
from rqt_mrta_py.wording import accepted, shown

__all__ = ["PluginManager"]

_log = logging.getLogger("rqt_mrta_py.hooks")


class _Implementation(NamedTuple):
    """One plugin's function for one hook; ``who`` names both in messages."""

    plugin: str
    function: Callable[..., Any]
    arguments: Tuple[str, ...]
    who: str


class _Registered(NamedTuple):
    """What all plugins register by one hook, and which plugin each name is from."""

    values: Mapping[str, Any]
    owners: Mapping[str, str]


class _Pluggy(pluggy.PluginManager):
    """pluggy, without looking behind properties of a plugin."""

    def parse_hookimpl_opts(self, plugin: Any, name: str) -> Any:
        """Give the options of a marked implementation; None for any other attribute."""
        if isinstance(inspect.getattr_static(plugin, name, None), property):
            return None
        return super().parse_hookimpl_opts(plugin, name)


class PluginManager:
    """Knows all plugins of one command.

    Plugins are asked in the order of their registration; for what they register once, until another plugin comes.
    Of two plugins that register one name, the first wins.

    Args:
        patience: how long a plugin may take to answer; by default a minute.
        trace: writes each call down; None for none.

    Attributes:
        patience: as given.
    """

    def __init__(self, patience: Optional[Patience] = None, trace: Optional[HookTrace] = None) -> None:
        self.patience = Patience() if patience is None else patience
        self._trace = trace
        self._pluggy = _Pluggy(PROJECT)
        self._pluggy.add_hookspecs(HookSpecs)
        self._names: List[str] = []
        self._implementations: Dict[str, List[_Implementation]] = {}
        self._registered: Dict[str, _Registered] = {}
        self._dismissed: Set[str] = set()

    @property
    def names(self) -> Tuple[str, ...]:
        """The registered plugins, in order."""
        return tuple(self._names)

    def implementers(self, hook: str) -> Tuple[str, ...]:
        """List the plugins that implement a hook, in the order in which they are asked."""
        return tuple(implementation.plugin for implementation in self._asked(hook))

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
        self._implementations.clear()
        self._registered.clear()
        self.patience.know(plugin.__name__ if isinstance(plugin, ModuleType) else type(plugin).__module__)
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
        return dict(self._join(hook).values)

    def owner(self, hook: str, name: str) -> str:
        """Tell whose registration won a name.

        Args:
            hook: ``mrta_register_*``.
            name: that is registered.

        Returns:
            The plugin's name.

        Raises:
            KeyError: nobody registers this name.
            HookError: as ``registered`` does.
        """
        return self._join(hook).owners[name]

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
        for implementation in self._asked(hook):
            answer = self._ask(implementation, hook, arguments)
            if not isinstance(answer, Sequence) or isinstance(answer, (str, bytes)):
                raise _misfit(implementation, f"returned {shown(answer)}; a sequence of problems is needed")
            for problem in answer:
                if not isinstance(problem, ParameterProblem):
                    raise _misfit(implementation, f"returned {shown(problem)}; a ParameterProblem is needed")
                found.append(problem)
        return tuple(found)

    def notify(self, hook: str, **arguments: Any) -> None:
        """Tell all observers; one that raises is logged by name, the others are told all the same.

        One that does not return in time is logged too, and this hook of it is not called again.

        Args:
            hook: ``mrta_on_*``.
            **arguments: exactly those of the hook.
        """
        self._expect(hook, "mrta_on_", arguments)
        for implementation in self._asked(hook):
            if implementation.who in self._dismissed:
                continue
            try:
                self._call(implementation, hook, arguments)
            except OutOfPatienceError as error:
                self._dismissed.add(implementation.who)
                _log.error("event=observer_dismissed plugin=%s hook=%s: %s", implementation.plugin, hook, error)
            except Exception:  # noqa: BLE001 - an observer never stops what it observes
                _log.exception("event=observer_failed plugin=%s hook=%s", implementation.plugin, hook)

    def _join(self, hook: str) -> _Registered:
        self._expect(hook, "mrta_register_", {})
        if hook not in self._registered:
            joined: Dict[str, Any] = {}
            owners: Dict[str, str] = {}
            for implementation in self._asked(hook):
                for name, value in self._answered(implementation, hook).items():
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
            self._registered[hook] = _Registered(joined, owners)
        return self._registered[hook]

    def _answered(self, implementation: _Implementation, hook: str) -> Mapping[str, Any]:
        answer = self._ask(implementation, hook, {})
        if not isinstance(answer, Mapping):
            raise _misfit(implementation, f"returned {shown(answer)}; a mapping by name is needed")
        for name, value in answer.items():
            breach = registration_breach(hook, name, value)
            if breach is not None:
                raise _misfit(implementation, breach)
        return answer

    def _ask(self, implementation: _Implementation, hook: str, arguments: Mapping[str, Any]) -> Any:
        try:
            return self._call(implementation, hook, arguments)
        except OutOfPatienceError:
            raise
        except Exception as error:
            raise _misfit(implementation, f"raised {type(error).__name__}: {error}") from error

    def _call(self, implementation: _Implementation, hook: str, arguments: Mapping[str, Any]) -> Any:
        given = [arguments[name] for name in implementation.arguments]
        with self.patience.limit(implementation.who):
            if self._trace is None:
                return implementation.function(*given)
            return self._trace.call(implementation.plugin, hook, implementation.function, *given)

    def _asked(self, hook: str) -> List[_Implementation]:
        if hook not in self._implementations:
            found = {each.plugin_name: each for each in getattr(self._pluggy.hook, hook).get_hookimpls()}
            self._implementations[hook] = [
                _Implementation(name, found[name].function, tuple(found[name].argnames), f"plugin {name!r}: {hook}")
                for name in self._names
                if name in found
            ]
        return self._implementations[hook]

    def _expect(self, hook: str, role: str, arguments: Mapping[str, Any]) -> None:
        if hook not in HOOKS or not hook.startswith(role):
            raise ValueError(f"{hook!r} is no {role}* hook; {accepted(hook, [h for h in HOOKS if role in h])}")
        wanted = tuple(HOOKS[hook].parameters)
        if set(wanted) != set(arguments):
            raise TypeError(f"{hook}{HOOKS[hook]} was called with ({', '.join(arguments)})")


def _misfit(implementation: _Implementation, message: str) -> HookError:
    return HookError(f"{implementation.who} {message}")
