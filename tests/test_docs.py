"""What the documentation says is so."""

from __future__ import annotations

import ast
import contextlib
import importlib
import importlib.util
import io
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import List, Tuple

import pytest

from rqt_mrta_py.app.cli.main import _parser
from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.hooks import HookSpecs
from rqt_mrta_py.hooks.manager import PluginManager

ROOT = Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src" / "rqt_mrta_py"
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
INDEX = ROOT / "docs" / "rooms" / "README.md"
ROOM_PAGES = sorted(path for path in INDEX.parent.glob("*.md") if path != INDEX)
ROOMS = sorted(path.parent.name for path in SOURCE.glob("*/__init__.py"))
MAPS = sorted(SOURCE.rglob("__init__.py"))


def of_page(path: Path) -> str:
    return str(path.relative_to(ROOT))


def test_the_page_of_hooks_is_fresh() -> None:
    """If this fails, run: python docs/make_hooks.py."""
    specification = importlib.util.spec_from_file_location("make_hooks", ROOT / "docs" / "make_hooks.py")
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    assert (ROOT / "docs" / "hooks.md").read_text(encoding="utf-8") == module.render()


@pytest.mark.parametrize("name", [name for name in vars(HookSpecs) if name.startswith("mrta_")])
def test_every_hook_states_its_contract_in_five_parts(name: str) -> None:
    text = getattr(HookSpecs, name).__doc__
    takes_arguments = getattr(HookSpecs, name).__code__.co_argcount > 1
    parts = ["Called:", "Returns:", "Combined:", "An exception:", *(["Args:"] if takes_arguments else [])]
    assert [part for part in parts if part not in text] == []


@pytest.mark.parametrize("page", PAGES, ids=of_page)
def test_links_lead_to_files_that_exist(page: Path) -> None:
    targets = re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8"))
    assert [target for target in targets if not (page.parent / target).exists()] == []


def mrta_commands() -> List[List[str]]:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    lines = re.findall(r"^\$ \./run (.+)$", text, re.MULTILINE)
    return [words for words in (shlex.split(line, comments=True) for line in lines) if words]


def test_the_readme_shows_commands() -> None:
    assert len(mrta_commands()) >= 4


@pytest.mark.parametrize("command", mrta_commands(), ids=" ".join)
def test_commands_of_the_readme_are_accepted(command: List[str]) -> None:
    assert callable(_parser().parse_args(command).main)


def test_the_plugin_shown_on_the_page_of_hooks_is_accepted() -> None:
    text = (ROOT / "docs" / "hooks.md").read_text(encoding="utf-8")
    (code,) = [block for block in re.findall(r"```python\n(.*?)```", text, re.DOTALL) if "@hookimpl" in block]
    module = type(importlib)("shown")
    exec(compile(code, "docs/hooks.md", "exec"), module.__dict__)
    manager = PluginManager()
    manager.register(module, "shown")
    assert list(manager.registered("mrta_register_statistics")) == ["incident_count"]


def test_the_registration_shown_in_the_readme_is_found(tmp_path: Path) -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    (lines,) = re.findall(r"```xml\n(.*?)```", text, re.DOTALL)
    package = tmp_path / "mine"
    package.mkdir()
    for name in ("rqt_mrta.xml", "scenario.yaml", "tasks.yaml"):
        (package / name).write_text("", encoding="utf-8")
    (package / "package.xml").write_text(
        '<package format="3"><name>mine</name><version>0.1.0</version><description>d</description>'
        f'<maintainer email="a@b.c">m</maintainer><license>l</license>{lines}</package>',
        encoding="utf-8",
    )
    registry = discover({"ROS_PACKAGE_PATH": str(tmp_path)}, prefix=str(tmp_path), own=(), shares=(), distributions=())
    assert [registration.package for registration in registry.registrations] == ["mine"]
    assert registry.problems == ()


@pytest.mark.parametrize("path", MAPS, ids=of_page)
def test_the_map_of_a_folder_names_everything_in_it(path: Path) -> None:
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    files = [each.stem for each in path.parent.glob("*.py") if not each.stem.startswith("__")]
    folders = [each.parent.name for each in path.parent.glob("*/__init__.py")]
    assert [name for name in sorted([*files, *folders]) if f"``{name}``" not in text] == []


def test_the_index_of_rooms_names_every_room_and_links_every_page() -> None:
    text = INDEX.read_text(encoding="utf-8")
    assert sorted(re.findall(r"^\| \[?(\w+)\]?(?:\(\w+\.md\))? \|", text, re.MULTILINE)) == sorted([*ROOMS, "room"])
    assert sorted(re.findall(r"\]\((\w+)\.md\)", text)) == [page.stem for page in ROOM_PAGES]


def examples(page: Path) -> List[Tuple[str, str]]:
    """List a page's blocks of Python, each with the block of text after it, which is what it prints."""
    pattern = r"```python\n(.*?)```(?:\n+```text\n(.*?)```)?"
    return re.findall(pattern, page.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("page", ROOM_PAGES, ids=of_page)
def test_a_page_of_a_room_has_an_example(page: Path) -> None:
    assert examples(page)


@pytest.mark.parametrize(
    ("page", "code", "printed"),
    [
        pytest.param(page, code, printed, id=f"{page.stem}-{number}")
        for page in ROOM_PAGES
        for number, (code, printed) in enumerate(examples(page))
    ],
)
def test_examples_on_pages_of_rooms_run_and_print_what_they_say(
    page: Path, code: str, printed: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile(code, str(page), "exec"), {"__name__": "example"})
    assert said.getvalue() == printed


def sessions() -> List[Tuple[str, List[str]]]:
    """List the blocks of commands that begin with mrta, each with the page it stands on; a tutorial is one session."""
    return [
        (of_page(page), re.findall(r"^\$ (mrta .+)$", block, re.MULTILINE))
        for page in PAGES
        if page.name != "tutorial.md"
        for block in re.findall(r"```console\n(\$ mrta .*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    ]


@pytest.mark.parametrize(("page", "commands"), sessions(), ids=[" ".join(commands) for _, commands in sessions()])
def test_commands_on_pages_do_their_work(page: str, commands: List[str], tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT / "src"), os.environ.get("PYTHONPATH", "")])}
    for command in commands:
        words = [sys.executable, "-m", "rqt_mrta_py", *shlex.split(command, comments=True)[1:]]
        done = subprocess.run(words, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
        assert (done.returncode, page) == (0, page), f"{command}: {done.stderr}"


def exists(name: str) -> bool:
    """Tell whether a dotted name of this project is a module, or something in one."""
    module, rest = name, []
    while module:
        try:
            found = importlib.import_module(module)
        except ModuleNotFoundError:
            module, _, last = module.rpartition(".")
            rest.insert(0, last)
            continue
        for part in rest:
            if not hasattr(found, part):
                return False
            found = getattr(found, part)
        return True
    return False


@pytest.mark.parametrize("page", [*ROOM_PAGES, INDEX], ids=of_page)
def test_what_pages_of_rooms_name_exists(page: Path) -> None:
    """Files are named from the root or from the sources."""
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    files = re.findall(r"`([\w.-]+/[\w./-]+\.(?:py|xml|yaml|msg|md))`", text)
    roots = (ROOT, SOURCE)
    missing = [name for name in files if not any((root / name).exists() for root in roots)]
    missing += [name for name in re.findall(r"`(rqt_mrta_py(?:\.\w+)+)`", text) if not exists(name)]
    assert missing == []
