"""Verbs that plugins add to the command."""

from __future__ import annotations

import argparse
import logging
from typing import Any, Dict, NamedTuple, Sequence

from rqt_mrta_py.app.cli.common import ProgressLine, complain_about
from rqt_mrta_py.app.cli.stdout import standard_output
from rqt_mrta_py.app.guard import guarded
from rqt_mrta_py.errors import HookError, MrtaError, UsageError
from rqt_mrta_py.wording import accepted, shown

__all__ = ["add_plugin_verb", "help_on_plugin_verbs"]

_log = logging.getLogger("rqt_mrta_py.app")
_HOOK = "mrta_register_verbs"


class _PluginVerb(NamedTuple):
    """One verb, its name, who messages say it is, and the plugins of this command."""

    name: str
    who: str
    verb: Any
    manager: Any


def add_plugin_verb(name: str, own: Sequence[str], verbs: Any, common: argparse.ArgumentParser) -> None:
    """Add the one verb of a plugin that is asked for.

    Args:
        name: of the verb.
        own: verbs of the command itself.
        verbs: takes the verb's parser in.
        common: arguments of every verb.

    Raises:
        UsageError: there is no such verb; says which is nearest.
        HookError: the plugin does not keep the contract, or raises.
    """
    found = _load(own)
    if name not in found:
        raise UsageError(f"{name}: there is no such verb; {accepted(name, [*own, *found])}")
    plugin_verb = found[name]
    who, verb = plugin_verb.who, plugin_verb.verb
    parser = verbs.add_parser(name, parents=[common], description=verb.help)
    with plugin_verb.manager.patience.limit(f"{who}: add_arguments"):
        guarded(f"{who}: add_arguments", verb.add_arguments, parser)
    guarded(f"{who}: its help page", parser.format_help)
    parser.set_defaults(main=lambda options: _run(plugin_verb, options))


def help_on_plugin_verbs(own: Sequence[str]) -> str:
    """Write a section of the command's help page; empty if plugins add no verbs.

    Args:
        own: verbs of the command itself.
    """
    try:
        found = _load(own)
    except MrtaError as error:
        return f"\nverbs of plugins cannot be told: {error}\n"
    if not found:
        return ""
    width = max(map(len, found))
    lines = [f"  {name.ljust(width)}  {found[name].verb.help}" for name in sorted(found)]
    return "\n".join(["", "verbs of plugins:", *lines, ""])


def _load(own: Sequence[str]) -> Dict[str, _PluginVerb]:
    from rqt_mrta_py.app.compose import compose

    host = compose()
    complain_about(host.problems)
    found = {}
    for name, verb in host.manager.registered(_HOOK).items():
        who = f"plugin {host.manager.owner(_HOOK, name)!r}: verb {name!r}"
        if name in own:
            _log.warning("%s is one of the command's own and is left out", who)
        elif not (isinstance(verb.help, str) and callable(verb.add_arguments) and callable(verb.main)):
            raise HookError(f"{who}: help must be a text, add_arguments and main functions")
        else:
            found[name] = _PluginVerb(name, who, verb, host.manager)
    return found


def _run(plugin_verb: _PluginVerb, options: argparse.Namespace) -> int:
    from rqt_mrta_py.app.cli.verb_tools import HostTools

    with ProgressLine(plugin_verb.name, options.quiet, unit="%") as progress:
        tools = HostTools(plugin_verb.who, plugin_verb.manager, progress)
        try:
            status: Any = guarded(plugin_verb.who, plugin_verb.verb.main, options, tools)
        except BaseException:
            tools.take_back()
            raise
    if not isinstance(status, int):
        raise HookError(f"{plugin_verb.who}: returned {shown(status)}; an exit status is needed")
    with standard_output():
        pass  # on leaving, what the verb printed has been written
    return status
