"""The commands of a CMakeLists.txt (cmake-language(7)): comments, brackets and quotes as CMake reads them."""

from __future__ import annotations

import re
from typing import Iterator, List, NamedTuple, Tuple

__all__ = ["CMakeArgument", "CMakeCommand", "cmake_commands"]

_TOKEN = re.compile(
    r"""
      (?P<space>[ \t\r\n]+)
    | (?P<bracket>\#?\[(?P<equals>=*)\[(?P<inner>.*?)\](?P=equals)\])
    | (?P<comment>\#[^\n]*)
    | "(?P<quoted>(?:\\.|[^"\\])*)"
    | (?P<open>\()
    | (?P<close>\))
    | (?P<plain>(?:\\.|\$\{[^}\n]*\}|[^\s()"\#\\])+)
    | (?P<other>.)
    """,
    re.DOTALL | re.VERBOSE,
)
_ESCAPE = re.compile(r"\\([^A-Za-z0-9;])")
_NAME = re.compile(r"[A-Za-z_]\w*\Z", re.ASCII)


class CMakeArgument(NamedTuple):
    """One argument, variables in it not yet replaced; a list is parted at ``;`` unless it is quoted."""

    text: str
    quoted: bool = False


class CMakeCommand(NamedTuple):
    """One invocation; ``name`` is in lower case, ``line`` is 1-based."""

    name: str
    arguments: Tuple[CMakeArgument, ...]
    line: int


def cmake_commands(text: str) -> Tuple[CMakeCommand, ...]:
    """Read all commands of a file, whether CMake would come to them or not.

    Args:
        text: of the file; what is no command is passed over.

    Returns:
        The commands in file order.
    """
    return tuple(_commands(text))


def _commands(text: str) -> Iterator[CMakeCommand]:
    name, name_line, depth, line = "", 0, 0, 1
    arguments: List[CMakeArgument] = []
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup or ""
        here, line = line, line + match.group().count("\n")
        if kind in ("space", "comment") or match.group().startswith("#"):
            continue
        if depth == 0:
            if kind == "open" and name:
                depth, arguments = 1, []
            else:
                is_name = kind == "plain" and _NAME.match(match.group()) is not None
                name, name_line = (match.group().lower(), here) if is_name else ("", 0)
        elif kind == "open":
            depth += 1
        elif kind == "close":
            depth -= 1
            if depth == 0:
                yield CMakeCommand(name, tuple(arguments), name_line)
                name = ""
        elif match.group("bracket") is not None:
            arguments.append(CMakeArgument(match.group("inner"), quoted=True))
        elif kind == "quoted":
            arguments.append(CMakeArgument(_ESCAPE.sub(r"\1", match.group("quoted")), quoted=True))
        elif kind == "plain":
            arguments.append(CMakeArgument(_ESCAPE.sub(r"\1", match.group())))
