"""What a plugin implements, read from its source without importing anything of it."""

from __future__ import annotations

import ast
import importlib.util
from importlib.machinery import PathFinder
from pathlib import Path
from typing import Dict, Iterator, List, Mapping, Optional, Sequence, Set, Tuple, Union

from rqt_mrta_py.hooks.contract import HOOKS

__all__ = ["hooks_in", "implemented_hooks", "plugin_source"]

_MARKER = "hookimpl"
_Scope = Union[ast.Module, ast.ClassDef]


def implemented_hooks(plugin: str, folder: Path) -> Optional[Tuple[str, ...]]:
    """Tell which hooks a plugin implements.

    Args:
        plugin: ``module`` or ``module:object``.
        folder: of its package, whose ``src`` is looked into where the module is on no path.

    Returns:
        Names of hooks, in the order of the contract; None if its source cannot be found or read.
    """
    module, _, attribute = plugin.partition(":")
    path = plugin_source(module, folder)
    if path is None:
        return None
    try:
        return hooks_in(path.read_bytes(), attribute)
    except (OSError, SyntaxError, ValueError):
        return None


def plugin_source(module: str, folder: Path) -> Optional[Path]:
    """Find the file that an import would read, without importing the packages above it.

    Args:
        module: dotted name.
        folder: of the package that registers it.

    Returns:
        The file; None if there is none, or the module is no Python source.
    """
    return _located(module, None) or _located(module, [str(folder / "src")])


def hooks_in(source: Union[str, bytes], attribute: str = "") -> Tuple[str, ...]:
    """Read which hooks a module's source implements.

    Args:
        source: of the module.
        attribute: the object of the module that is the plugin: a class, or what is made from a class by a call;
            empty: the module itself.

    Returns:
        Names of hooks, in the order of the contract. A name that the module imports counts if it is a hook's.

    Raises:
        SyntaxError: the source is no Python.
        ValueError: the source holds null bytes.
    """
    tree = ast.parse(source)
    markers = {_MARKER, *_aliases(tree)}
    found: Set[str] = set()
    for scope in _scopes(tree, attribute):
        found.update(_marked(scope, markers))
    return tuple(hook for hook in HOOKS if hook in found)


def _located(module: str, search: Optional[List[str]]) -> Optional[Path]:
    top, *rest = module.split(".")
    try:
        spec = importlib.util.find_spec(top) if search is None else PathFinder.find_spec(top, search)
        name = top
        for part in rest:
            if spec is None or spec.submodule_search_locations is None:
                return None
            name = f"{name}.{part}"
            spec = PathFinder.find_spec(name, list(spec.submodule_search_locations))
    except (ImportError, KeyError, ValueError):
        return None
    if spec is None or not spec.has_location or spec.origin is None or not spec.origin.endswith(".py"):
        return None
    return Path(spec.origin)


def _aliases(tree: ast.Module) -> Iterator[str]:
    """Give the names under which the module imports the marker."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            yield from (alias.asname for alias in node.names if alias.name == _MARKER and alias.asname)


def _scopes(tree: ast.Module, attribute: str) -> Iterator[_Scope]:
    """Give the module, or the class behind one of its objects with the classes it is derived from."""
    if not attribute:
        yield tree
        return
    classes = {node.name: node for node in ast.walk(tree) if isinstance(node, ast.ClassDef)}
    made = {
        target.id: node.value.func.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and isinstance(node.value.func, ast.Name)
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    yield from _with_bases(made.get(attribute, attribute.rpartition(".")[2]), classes, set())


def _with_bases(name: str, classes: Mapping[str, ast.ClassDef], seen: Set[str]) -> Iterator[ast.ClassDef]:
    if name not in classes or name in seen:
        return
    seen.add(name)
    yield classes[name]
    for base in classes[name].bases:
        if isinstance(base, ast.Name):
            yield from _with_bases(base.id, classes, seen)


def _marked(scope: _Scope, markers: Set[str]) -> Iterator[str]:
    """Give the hooks that a module's or class's own functions are marked to implement."""
    for node in _statements(scope.body):
        if isinstance(node, ast.ImportFrom):
            yield from (alias.asname or alias.name for alias in node.names)
        elif isinstance(node, ast.Assign):
            names = [target.id for target in node.targets if isinstance(target, ast.Name)]
            if isinstance(node.value, ast.Call):
                yield from _hook(node.value.func, markers, names)
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            for decorator in node.decorator_list:
                yield from _hook(decorator, markers, [node.name])


def _statements(body: Sequence[ast.stmt]) -> Iterator[ast.stmt]:
    """Give the statements of a scope, those under ``if``, ``try`` and ``with`` included."""
    for node in body:
        yield node
        if isinstance(node, (ast.If, ast.Try, ast.With)):
            for part in ("body", "orelse", "finalbody"):
                yield from _statements(getattr(node, part, []))
            for handler in getattr(node, "handlers", []):
                yield from _statements(handler.body)


def _hook(mark: ast.expr, markers: Set[str], names: Sequence[str]) -> Iterator[str]:
    """Give the hooks that a mark makes of functions with these names; none if it is not the marker."""
    options: Dict[str, ast.expr] = {}
    if isinstance(mark, ast.Call):
        options = {keyword.arg: keyword.value for keyword in mark.keywords if keyword.arg}
        mark = mark.func
    named = mark.id if isinstance(mark, ast.Name) else mark.attr if isinstance(mark, ast.Attribute) else ""
    if named in markers:
        specname = options.get("specname")
        yield from [str(specname.value)] if isinstance(specname, ast.Constant) and specname.value else names
