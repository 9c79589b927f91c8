"""What must hold for Python 3.8, catkin and pip alike."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("src", "plugins", "bootstrap", "scripts", "tests", "bench")


def sources() -> list[Path]:
    named = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*.py")]
    stubs = [path for path in ROOT.glob("**/scripts/*") if path.is_file() and not path.suffix]
    return sorted([ROOT / "setup.py", *named, *stubs])


@pytest.mark.parametrize("path", sources(), ids=lambda path: str(path.relative_to(ROOT)))
def test_source_keeps_to_the_grammar_of_python_3_8(path: Path) -> None:
    ast.parse(path.read_text(encoding="utf-8"), str(path), feature_version=(3, 8))


def test_every_place_names_the_same_version() -> None:
    setup = re.search(r'^    version="([^"]+)"', (ROOT / "setup.py").read_text(encoding="utf-8"), re.MULTILINE)
    package = re.search(
        r'^__version__ = "([^"]+)"', (ROOT / "src/rqt_mrta_py/__init__.py").read_text(encoding="utf-8"), re.MULTILINE
    )
    assert setup is not None
    assert package is not None
    # catkin refuses a setup.py that disagrees with package.xml.
    assert setup[1] == package[1] == ElementTree.parse(ROOT / "package.xml").findtext("version")


def test_mypy_is_told_of_every_plugins_sources() -> None:
    named = re.findall(
        r'^    "(plugins/[^"]+/src)",$', (ROOT / "pyproject.toml").read_text(encoding="utf-8"), re.MULTILINE
    )
    assert {str(path.relative_to(ROOT)) for path in ROOT.glob("plugins/*/*/src")} <= set(named)


def test_messages_of_the_package_build_with_catkins_dependencies() -> None:
    used = {
        match[1]
        for path in sorted((ROOT / "msg").glob("*.msg"))
        for match in re.finditer(r"^(\w+_msgs)/", path.read_text(encoding="utf-8"), re.MULTILINE)
    }
    build = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    generated = re.search(r"generate_messages\(DEPENDENCIES ([^)]*)\)", build)
    assert generated is not None
    assert used <= set(generated[1].split())
    assert used <= {element.text for element in ElementTree.parse(ROOT / "package.xml").iter("depend")}
