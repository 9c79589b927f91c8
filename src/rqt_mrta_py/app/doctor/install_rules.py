"""What a CMakeLists.txt installs of its package, told from its commands without running them."""

from __future__ import annotations

import re
from fnmatch import fnmatchcase
from pathlib import Path, PurePosixPath
from typing import Dict, Iterable, Iterator, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.app.doctor.cmake_commands import CMakeArgument, CMakeCommand, cmake_commands

__all__ = ["InstallRules", "read_install_rules"]

_VARIABLE = re.compile(r"\$\{([^${}]*)\}")
_STARS = re.compile(r"\*+")
_KEYWORDS = (
    *("DESTINATION", "PERMISSIONS", "CONFIGURATIONS", "COMPONENT", "RENAME", "OPTIONAL", "TYPE", "EXCLUDE_FROM_ALL"),
    *("USE_SOURCE_PERMISSIONS", "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS", "MESSAGE_NEVER"),
    *("FILES_MATCHING", "PATTERN", "REGEX", "EXCLUDE"),
)
_LONGEST = 100_000
"""Characters that one argument may come to."""

_SHARE = "share"
_PYTHON = "python"


class _Rule(NamedTuple):
    """Some files on their way; ``destination`` is relative to the package's share folder, None outside of it."""

    is_folder: bool
    sources: Tuple[str, ...]
    destination: Optional[str]
    rename: str
    wanted: Tuple[str, ...]
    unwanted: Tuple[str, ...]
    place: str
    line: int


class InstallRules:
    """The rules of one CMakeLists.txt.

    Args:
        rules: for files and folders.
        is_clear: False if something is installed whose name only CMake knows.
        python_line: of the command that installs the modules that setup.py names; 0 if there is none.
    """

    def __init__(self, rules: Sequence[_Rule], is_clear: bool, python_line: int) -> None:
        self._rules = tuple(rules)
        self.is_clear = is_clear
        self.python_line = python_line

    @property
    def sets_python_up(self) -> bool:
        """True if the modules that setup.py names are installed."""
        return self.python_line > 0

    def covers(self, path: str) -> bool:
        """Tell whether a file gets to where ``${prefix}`` and ``$(find ...)`` look for it after installation.

        Args:
            path: of the file, relative to the package, parted by ``/``.
        """
        return any(path in _targets(rule, path) for rule in self._rules)

    def astray(self, path: str) -> Tuple[str, int]:
        """Tell where a file is installed instead: the destination as it is written, and its line; else empty and 0."""
        for rule in self._rules:
            if any(True for _ in _targets(rule._replace(destination=rule.destination or ""), path)):
                return rule.place, rule.line
        return "", 0

    def brings_module(self, folder: str) -> bool:
        """Tell whether a folder with Python code is installed, by whatever means."""
        return self.sets_python_up or any(
            rule.is_folder
            and any(folder == part or folder.startswith(f"{part}/") for part in map(_clean, rule.sources))
            for rule in self._rules
        )


def read_install_rules(text: str, folder: Path, name: str) -> InstallRules:
    """Read what is installed.

    Args:
        text: of the CMakeLists.txt.
        folder: that holds it.
        name: of the package.
    """
    variables: Dict[str, List[str]] = {
        "PROJECT_NAME": [name],
        "CMAKE_PROJECT_NAME": [name],
        "CATKIN_PACKAGE_SHARE_DESTINATION": [f"share/{name}"],
        "CATKIN_GLOBAL_SHARE_DESTINATION": ["share"],
        "CATKIN_PACKAGE_PYTHON_DESTINATION": [f"{_PYTHON}/{name}"],
        "CATKIN_GLOBAL_PYTHON_DESTINATION": [_PYTHON],
        "CATKIN_PACKAGE_BIN_DESTINATION": [f"lib/{name}"],
        "CATKIN_PACKAGE_LIB_DESTINATION": ["lib"],
        "CATKIN_PACKAGE_INCLUDE_DESTINATION": [f"include/{name}"],
        "CATKIN_GLOBAL_BIN_DESTINATION": ["bin"],
        "CATKIN_GLOBAL_LIB_DESTINATION": ["lib"],
        "CATKIN_GLOBAL_INCLUDE_DESTINATION": ["include"],
        "CATKIN_GLOBAL_ETC_DESTINATION": ["etc"],
        "CATKIN_INSTALL_INTO_PREFIX_ROOT": ["0"],
        "CMAKE_CURRENT_SOURCE_DIR": ["."],
        "CMAKE_CURRENT_LIST_DIR": ["."],
        "PROJECT_SOURCE_DIR": ["."],
        "CMAKE_SOURCE_DIR": ["."],
        "CMAKE_INSTALL_PREFIX": ["."],
    }
    rules: List[_Rule] = []
    is_clear, python_line = True, 0
    for command in cmake_commands(text):
        values = _expanded(command.arguments, variables)
        if command.name == "project" and values:
            variables["PROJECT_NAME"] = [values[0]]
        elif command.name == "set" and values:
            variables[values[0]] = [value for value in values[1:] if value not in ("PARENT_SCOPE", "CACHE")]
        elif command.name == "list" and len(values) > 1 and values[0] == "APPEND":
            variables.setdefault(values[1], []).extend(values[2:])
        elif command.name == "file" and len(values) > 1 and values[0] in ("GLOB", "GLOB_RECURSE"):
            variables[values[1]] = _globbed(values, folder)
        elif command.name == "foreach" and values:
            # All rounds at once: rules are only ever asked whether one of them covers a file.
            items = [value for value in values[1:] if value not in ("IN", "ITEMS", "LISTS")]
            by_name = "LISTS" in values
            variables[values[0]] = [x for item in items for x in variables.get(item, [item])] if by_name else items
        elif command.name == "catkin_python_setup":
            python_line = command.line
        elif command.name in ("install", "catkin_install_python"):
            for rule in _rules(command, values, name):
                rules.append(rule)
                is_clear = is_clear and not any("${" in part for part in (*rule.sources, rule.place))
        elif command.name == "include" and values and not values[0].isidentifier():
            is_clear = False
    return InstallRules(rules, is_clear, python_line)


def _expanded(arguments: Iterable[CMakeArgument], variables: Dict[str, List[str]]) -> List[str]:
    """Replace variables; unknown ones stand as they were."""
    values: List[str] = []
    for argument in arguments:
        texts = [argument.text]
        for _ in range(len(_VARIABLE.findall(argument.text))):
            texts = [replaced for text in texts for replaced in _replaced(text, variables)]
            if sum(map(len, texts)) > _LONGEST:
                # Variables that double one another; what they hold stays unknown.
                texts = [argument.text]
                break
        if argument.quoted:
            values.append(";".join(texts) if len(texts) > 1 else "".join(texts))
        else:
            values.extend(part for text in texts for part in text.split(";") if part)
    return values


def _replaced(text: str, variables: Dict[str, List[str]]) -> List[str]:
    for match in _VARIABLE.finditer(text):
        if match.group(1) in variables:
            head, tail = text[: match.start()], text[match.end() :]
            return [f"{head}{value}{tail}" for value in variables[match.group(1)]]
    return [text]


def _globbed(values: Sequence[str], folder: Path) -> List[str]:
    found: List[str] = []
    skip = False
    for value in values[2:]:
        if skip or value in ("RELATIVE", "LIST_DIRECTORIES", "CONFIGURE_DEPENDS"):
            skip = value in ("RELATIVE", "LIST_DIRECTORIES")
            continue
        # Two stars are no more than one to CMake, and an error to pathlib.
        pattern = _STARS.sub("*", _clean(value))
        if "${" in pattern or pattern.startswith("/") or ".." in PurePosixPath(pattern).parts:
            found.append(value)
            continue
        if not pattern:
            continue
        globbed = folder.rglob(pattern) if values[0] == "GLOB_RECURSE" else folder.glob(pattern)
        found.extend(sorted(path.relative_to(folder).as_posix() for path in globbed))
    return found


def _rules(command: CMakeCommand, values: Sequence[str], name: str) -> Iterator[_Rule]:
    kind = values[0] if values else ""
    if kind not in ("FILES", "PROGRAMS", "DIRECTORY"):
        return
    sources: List[str] = []
    given: Dict[str, List[str]] = {}
    excluded: List[str] = []
    keyword, pattern = "", ""
    for value in values[1:]:
        if value == "EXCLUDE":
            excluded.append(pattern)
        elif value in _KEYWORDS:
            keyword = value
        elif not keyword:
            sources.append(_clean(value) if value != "." else ".")
        else:
            given.setdefault(keyword, []).append(value)
            pattern = value if keyword in ("PATTERN", "REGEX") else pattern
    wanted = [each for each in given.get("PATTERN", []) if each not in excluded] if "FILES_MATCHING" in values else []
    sources = [f"{source}/" if source and raw.endswith("/") else source for source, raw in zip(sources, values[1:])]
    place = given.get("DESTINATION", [""])[0]
    yield _Rule(
        is_folder=kind == "DIRECTORY",
        sources=tuple(sources),
        destination=_within_share(place, name),
        rename=given.get("RENAME", [""])[0],
        wanted=tuple(wanted),
        unwanted=tuple(excluded),
        place=place,
        line=command.line,
    )


def _within_share(place: str, name: str) -> Optional[str]:
    parts = PurePosixPath(_clean(place)).parts
    return "/".join(parts[2:]) if parts[:2] == (_SHARE, name) else None


def _targets(rule: _Rule, path: str) -> Iterator[str]:
    """Give where a file goes, relative to the package's share folder."""
    if rule.destination is None:
        return
    for raw in rule.sources:
        source = _clean(raw)
        if not rule.is_folder:
            if source == path:
                yield _joined(rule.destination, rule.rename or PurePosixPath(path).name)
            continue
        inner = _below(path, source)
        if inner is None or not _is_wanted(rule, inner):
            continue
        head = "" if raw.endswith("/") or source in ("", ".") else PurePosixPath(source).name
        yield _joined(rule.destination, head, inner)


def _below(path: str, folder: str) -> Optional[str]:
    if folder in ("", "."):
        return path
    return path[len(folder) + 1 :] if path.startswith(f"{folder}/") else None


def _is_wanted(rule: _Rule, inner: str) -> bool:
    parts = PurePosixPath(inner).parts
    if any(fnmatchcase(part, pattern) for pattern in rule.unwanted for part in parts):
        return False
    return not rule.wanted or any(fnmatchcase(parts[-1], pattern) for pattern in rule.wanted)


def _clean(path: str) -> str:
    text = str(PurePosixPath(path)) if path else ""
    return "" if text == "." else text


def _joined(*parts: str) -> str:
    return "/".join(part for part in parts if part)
