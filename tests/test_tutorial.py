"""Replays docs/tutorial.md: types what the page types, in one shell, and expects what the page shows.

The page's blocks of ``console`` are the session. A line with ``$`` is typed, those with ``>`` go on with it; what
follows is printed, on standard output or standard error. There ``...`` stands for any text, a line that holds nothing
else for any number of lines, and blanks for any number of blanks: columns of tables are as wide as what else is in
them. The page's folders stand for folders of the test's.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Dict, List, NamedTuple

import pytest

from tests.conftest import ROOT

PAGE = ROOT / "docs" / "tutorial.md"
WORKSPACE = "/home/ada/robots"
CHECKOUT = "/home/ada/rqt_mrta_py"
AFTER_EACH = "---- typed ----"


class Typed(NamedTuple):
    """A command of the page: its lines without prompts, and the lines that follow it."""

    command: str
    shown: List[str]


def session(text: str) -> List[Typed]:
    """List the commands of a page, in order."""
    found: List[Typed] = []
    for block in re.findall(r"^```console\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        for line in block.splitlines():
            if line.startswith("$ "):
                found.append(Typed(line[2:], []))
            elif line.startswith(">") and not found[-1].shown:
                found[-1] = Typed(f"{found[-1].command}\n{line[2:]}", [])
            else:
                found[-1].shown.append(line)
    return found


def looks_like(shown: List[str]) -> str:
    """Give the regular expression of what lines of the page stand for."""
    lines = [
        r"(?:.*\n)*?" if line.strip() == "..." else r".*?".join(map(re.escape, line.split("..."))) + r"\n"
        for line in shown
    ]
    return re.sub(r"(?:\\ )+", "[ ]+", "".join(lines))


SESSION = session(PAGE.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def printed(tmp_path_factory: pytest.TempPathFactory) -> List[str]:
    """Type the whole session; give what each command prints."""
    home = tmp_path_factory.mktemp("home")
    folder = home / "robots"
    script = "".join(f"{each.command}\n__status=$?; echo '{AFTER_EACH}'; (exit $__status)\n" for each in SESSION)
    done = subprocess.run(
        ["bash", "--noprofile", "--norc", "-c", script.replace(WORKSPACE, str(folder))],
        cwd=home,
        env=environment(home),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        check=False,
    )
    told = done.stdout.replace(str(folder), WORKSPACE).replace(str(ROOT), CHECKOUT)
    return told.split(f"{AFTER_EACH}\n")[:-1]


def environment(home: Path) -> Dict[str, str]:
    """Give a new user's environment, in which the commands of the page are those of this checkout."""
    commands = home / "bin"
    commands.mkdir()
    for name, module in (("mrta", "rqt_mrta_py"), ("pytest", "pytest")):
        (commands / name).write_text(f'#!/bin/sh\nexec "{sys.executable}" -m {module} "$@"\n', encoding="utf-8")
        (commands / name).chmod(0o755)
    strange = ("ROS_", "CMAKE_PREFIX_PATH", "PYTEST_", "MRTA_")
    return {
        **{name: value for name, value in os.environ.items() if not name.startswith(strange)},
        "HOME": str(home),
        "PATH": os.pathsep.join([str(commands), os.environ["PATH"]]),
        "PYTHONPATH": os.pathsep.join([str(ROOT / "src"), os.environ.get("PYTHONPATH", "")]),
        # Lines come in the order in which they are written, as on a terminal.
        "PYTHONUNBUFFERED": "1",
    }


@pytest.mark.parametrize("number", range(len(SESSION)), ids=[each.command.splitlines()[0] for each in SESSION])
def test_commands_print_what_the_page_shows(number: int, printed: List[str]) -> None:
    assert len(printed) == len(SESSION)
    shown = SESSION[number].shown
    assert re.fullmatch(looks_like(shown), printed[number]), "\n".join(["shown:", *shown, "printed:", printed[number]])


def test_page_shows_what_the_issue_of_a_tutorial_is() -> None:
    """A page without its session, or with everything elided, would pass all else."""
    typed = "\n".join(each.command for each in SESSION)
    for verb in ("new architecture", "new application", "list", "configure", "run", "doctor", "review"):
        assert f"mrta {verb}" in typed
    complaints = [line for each in SESSION for line in each.shown if re.match(r"yard_watch/\S+:\d+: ", line)]
    assert {line.split(":")[0].split("/")[1] for line in complaints} >= {
        "package.xml",
        "rqt_mrta.xml",
        "config",
        "tasks.yaml",
        "scenario.yaml",
    }


@pytest.mark.parametrize(
    ("shown", "told", "same"),
    [
        (["a", "b"], "a\nb\n", True),
        (["a"], "a\nb\n", False),
        (["a", "..."], "a\nb\nc\n", True),
        (["a", "...", "c"], "a\nc\n", True),
        (["in ... s"], "in 2.5 s\n", True),
        (["in ... s"], "in 2\n5 s\n", False),
        (["a.c"], "abc\n", False),
        (["a  b"], "a   b\n", True),
        (["a  b"], "ab\n", False),
        ([], "", True),
        ([], "a\n", False),
    ],
)
def test_elided_text_may_be_anything_and_nothing_else_may(shown: List[str], told: str, same: bool) -> None:
    assert (re.fullmatch(looks_like(shown), told) is not None) is same


def test_sessions_are_read_with_lines_that_go_on() -> None:
    page = "Text.\n\n```console\n$ cat > f <<END\n> one\n> END\n$ cat f\none\n```\n\n```python\n$ no\n```\n"
    assert session(page) == [Typed("cat > f <<END\none\nEND", []), Typed("cat f", ["one"])]
