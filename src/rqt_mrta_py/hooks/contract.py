"""Whether a plugin keeps the contract: checked when it is registered, so that no mistake stays silent.

pluggy would ignore a hook that does not exist until somebody asks, and an argument with a default for ever.
"""

from __future__ import annotations

import inspect
from typing import Any, Dict, List, Mapping

from rqt_mrta_py.hooks.specs import PROJECT, HookSpecs
from rqt_mrta_py.wording import accepted, nearest

__all__ = ["HOOKS", "contract_breaches"]

_PREFIX = "mrta_"
_MARK = f"{PROJECT}_impl"
_ORDER_OPTIONS = ("tryfirst", "trylast", "hookwrapper", "wrapper")


def _signature(member: Any) -> inspect.Signature:
    """Give a signature without annotations, and without the ``self`` of a specification."""
    signature = inspect.signature(member)
    parameters = [
        parameter.replace(annotation=parameter.empty)
        for parameter in signature.parameters.values()
        if parameter.name != "self"
    ]
    return signature.replace(parameters=parameters, return_annotation=inspect.Signature.empty)


HOOKS: Mapping[str, inspect.Signature] = {
    name: _signature(member)
    for name, member in vars(HookSpecs).items()
    if name.startswith(_PREFIX) and inspect.isfunction(member)
}
"""Every hook, with its signature without annotations."""


def contract_breaches(plugin: object) -> List[str]:
    """Find where a plugin does not keep the contract; properties of the plugin are not looked behind.

    Args:
        plugin: a module or object with functions marked by ``hookimpl``.

    Returns:
        A phrase for each breach, naming the implementation, the hook and both signatures; in order of names.
    """
    breaches: List[str] = []
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
                breaches.append(f"{name}{_signature(member)} is not marked; put @hookimpl above it")
            continue
        hook = options.get("specname") or name
        breaches.extend(_misfits(hook, name, _signature(member), options))
        if hook in taken:
            breaches.append(f"{taken[hook]} and {name} both implement {hook}; one plugin answers a hook once")
        taken[hook] = name
    return breaches


def _misfits(hook: str, name: str, signature: inspect.Signature, options: Mapping[str, Any]) -> List[str]:
    own = f"{name}{signature}"
    if hook not in HOOKS:
        match = nearest(hook, HOOKS)
        if match is None:
            return [f"{own} implements {hook}, which is no hook; {accepted(hook, HOOKS)}"]
        return [f"{own} implements {hook}, which is no hook; nearest is {match}{HOOKS[match]}"]
    contract = f"the contract says {hook}{HOOKS[hook]}"
    misfits = []
    for parameter in signature.parameters.values():
        if parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD):
            misfits.append(f"{own} takes {parameter}, which no hook fills in; {contract}")
        elif parameter.name not in HOOKS[hook].parameters:
            misfits.append(f"{own} asks for {parameter.name!r}, which the hook does not give; {contract}")
        elif parameter.default is not parameter.empty:
            misfits.append(f"{own} has a default for {parameter.name!r}, which then is never given; {contract}")
    misfits.extend(
        f"{own} asks for {option}, but plugins are asked in the order of discovery; leave it out"
        for option in _ORDER_OPTIONS
        if options.get(option)
    )
    return misfits
