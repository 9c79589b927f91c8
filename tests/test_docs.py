"""What the documentation says is so."""

from __future__ import annotations

import importlib.util
import re
import shlex
from pathlib import Path
from typing import List

import pytest

from rqt_mrta_py.app.cli.main import _parser
from rqt_mrta_py.config import discover
from rqt_mrta_py.hooks import HookSpecs
from rqt_mrta_py.hooks.manager import PluginManager

ROOT = Path(__file__).resolve().parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


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


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
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
