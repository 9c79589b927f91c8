"""The ladder of rooms: model <- config <- hooks <- {transport | supervisor | robot | sim | render} <- app."""

from __future__ import annotations

import ast
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, Iterator, List, Tuple

import pytest

ROOT = Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src" / "rqt_mrta_py"
PLUGINS = ROOT / "plugins"

BESIDE = ("errors", "wording")

LADDER: Dict[str, FrozenSet[str]] = {
    "errors": frozenset(),
    "wording": frozenset(),
    "model": frozenset({"errors"}),
    "config": frozenset({*BESIDE, "model"}),
    "hooks": frozenset({*BESIDE, "model", "config"}),
}
MIDDLE = ("transport", "supervisor", "robot", "sim", "render")
for room in MIDDLE:
    LADDER[room] = frozenset({*BESIDE, "model", "config", "hooks"})
LADDER["app"] = frozenset({*BESIDE, "model", "config", "hooks", *MIDDLE})

DOORS = {
    "rospy": "transport/ros1",
    "genpy": "transport/ros1",
    "genmsg": "transport/ros1",
    "rosgraph": "transport/ros1",
    "pybullet": "sim/bullet",
    "rosbags": "transport",
    "cv2": "render",
    "matplotlib": "render",
}
STDLIB_ONLY = "model"
THIRD_PARTY = frozenset(DOORS) | {"numpy", "scipy", "lxml", "yaml", "pluggy", "catkin_pkg", "rospkg", "lz4", "rich"}


@lru_cache(maxsize=None)
def imported_modules(path: Path) -> List[Tuple[int, str]]:
    """List line and dotted name of everything a file imports, type-only and lazy imports included."""
    found = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found += [(node.lineno, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}:{node.lineno}: relative import"
            found.append((node.lineno, node.module or ""))
    return found


def python_files(folder: Path) -> List[Path]:
    return sorted(path for path in folder.rglob("*.py") if "build" not in path.parts)


def room_of(path: Path) -> str:
    return path.relative_to(SOURCE).parts[0].replace(".py", "")


def test_rooms_import_lower_rooms_only() -> None:
    wrong = []
    for path in python_files(SOURCE):
        room = room_of(path)
        if room in ("__init__", "__main__"):
            continue
        for line, module in imported_modules(path):
            parts = module.split(".")
            if parts[0] == "rqt_mrta_py" and len(parts) > 1 and parts[1] not in LADDER[room] | {room}:
                wrong.append(f"{path.relative_to(ROOT)}:{line}: {room} imports {parts[1]}")
    assert wrong == []


def test_plugins_import_model_and_hooks_only() -> None:
    wrong = []
    for path in python_files(PLUGINS):
        allowed = {"app"} if "scripts" in path.parts else {"model", "hooks"}
        for line, module in imported_modules(path):
            parts = module.split(".")
            if parts[0] == "rqt_mrta_py" and (len(parts) < 2 or parts[1] not in allowed):
                wrong.append(f"{path.relative_to(ROOT)}:{line}: {module}")
    assert wrong == []


@pytest.mark.parametrize("library", sorted(DOORS))
def test_heavy_libraries_have_one_door(library: str) -> None:
    door = SOURCE / DOORS[library]
    wrong = [
        f"{path.relative_to(ROOT)}:{line}"
        for path in python_files(SOURCE) + python_files(PLUGINS)
        for line, module in imported_modules(path)
        if module.split(".")[0] == library and door not in path.parents
    ]
    assert wrong == []


def test_model_needs_the_standard_library_only() -> None:
    wrong = [
        f"{path.relative_to(ROOT)}:{line}: {module}"
        for path in python_files(SOURCE / STDLIB_ONLY)
        for line, module in imported_modules(path)
        if module.split(".")[0] in THIRD_PARTY
    ]
    assert wrong == []


def eager_imports(tree: ast.AST) -> Iterator[str]:
    """Yield what is imported outside of functions, type-only imports included."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
        elif not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            yield from eager_imports(node)


def test_modules_import_without_cycles() -> None:
    """Imports inside functions do not count; a lazy one cannot make a cycle at start-up."""
    names = {}
    for path in python_files(SOURCE):
        parts = ("rqt_mrta_py", *path.relative_to(SOURCE).with_suffix("").parts)
        names[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    edges: Dict[str, List[str]] = {}
    for name, path in names.items():
        targets = eager_imports(ast.parse(path.read_text(encoding="utf-8")))
        edges[name] = [target for target in targets if target in names and not name.startswith(target + ".")]
    done: List[str] = []
    path_now: List[str] = []

    def visit(name: str) -> None:
        assert name not in path_now, f"import cycle: {' -> '.join([*path_now[path_now.index(name) :], name])}"
        if name in done:
            return
        path_now.append(name)
        for target in edges[name]:
            visit(target)
        path_now.pop()
        done.append(name)

    for name in sorted(names):
        visit(name)
