"""Problems of a draft, told so that the user finds them: by option, or by a line of the file as it is."""

from __future__ import annotations

from difflib import SequenceMatcher
from pathlib import Path
from typing import Dict, Iterable, List, Mapping, Sequence

from rqt_mrta_py.config.editing.values import SetValue
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.model import normalise_id

__all__ = ["MANY_LINES", "as_options"]

MANY_LINES = 10_000
"""Files longer than this are compared faster and more coarsely."""


def as_options(
    problems: Iterable[Problem], edits: Sequence[object], edited: Mapping[Path, str], configs: Sequence[str]
) -> List[Problem]:
    """Tell problems of texts that were never written.

    Args:
        problems: with lines of the edited texts.
        edits: that were made.
        edited: texts by path.
        configs: ids of the architecture's configs, which stand for no single robot.

    Returns:
        The problems: those of a value that was set name the option; others the line that the file has now, or none
        where it has no such line.
    """
    paths: Dict[str, str] = {}
    for edit in edits:
        if isinstance(edit, SetValue):
            path = normalise_id(edit.path.strip())
            paths[path] = path
            paths.update((path[len(name) + 1 :], path) for name in configs if path.startswith(f"{name}/"))
    lines = {str(path): _lines(path, text) for path, text in edited.items()}
    told = []
    for problem in problems:
        given = paths.get(problem.element) or paths.get(problem.element.partition("/")[2])
        if given is not None:
            told.append(Problem("--set", 0, given, problem.message))
        elif problem.path in lines:
            line = lines[problem.path].get(problem.line, 0)
            told.append(Problem(problem.path, line, problem.element, problem.message))
        else:
            told.append(problem)
    return told


def _lines(path: Path, text: str) -> Dict[int, int]:
    """Give the lines of a file by those of its edited text."""
    before = read_file(path).decode("utf-8", "replace").splitlines()
    matcher = SequenceMatcher(None, before, text.splitlines(), autojunk=len(before) > MANY_LINES)
    blocks = matcher.get_matching_blocks()
    return {block.b + step + 1: block.a + step + 1 for block in blocks for step in range(block.size)}
