"""What the wheel holds, and what it says of itself."""

from __future__ import annotations

import ast
import re
import stat
import sys
import tarfile
from pathlib import Path
from typing import Dict, Iterator, List, Set
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest

import rqt_mrta_py
from tests.conftest import ROOT
from tests.packaging.builds import build

METADATA = "rqt_mrta_py-0.1.0.dist-info/METADATA"
DATA = "rqt_mrta_py-0.1.0.data/data/"
IMPORTED_AS = {"PIL": "pillow", "cv2": "opencv-python-headless", "pybullet_data": "pybullet", "yaml": "pyyaml"}
MANIFESTS = [ROOT / "package.xml", *sorted(ROOT.glob("plugins/*/*/package.xml"))]
OF_ROS = {"alliance_msgs", "genmsg", "genpy", "nearest_robot_msgs", "roslib", "rosgraph", "rospy"}


@pytest.fixture(scope="module")
def contents(wheel: Path) -> Dict[str, bytes]:
    with ZipFile(wheel) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def test_wheel_holds_every_python_module(contents: Dict[str, bytes], tree: Path) -> None:
    modules = {path.relative_to(tree / "src").as_posix() for path in (tree / "src").rglob("*.py")}
    schema = "rqt_mrta_py/config/schema"
    grammars = {f"{schema}/{name}" for name in ("architecture.rng", "application.rng")}
    grammars |= {f"{schema}/{name}.schema.json" for name in ("tasks", "scenario", "tolerances")}
    new = "rqt_mrta_py/config/packages/skeleton"
    skeleton = {f"{new}/{name}.py.in" for name in ("agent", "init", "plugin", "setup", "test_agent")}
    skeleton.add(f"{new}/pytest.ini.in")
    page = (tree / "src/rqt_mrta_py/render/report/assets").iterdir()
    assets = {f"rqt_mrta_py/render/report/assets/{path.name}" for path in page if path.suffix in (".css", ".js")}
    assert assets
    assert {name for name in contents if name.startswith("rqt_mrta_py/")} == {
        *modules,
        *grammars,
        *skeleton,
        *assets,
        "rqt_mrta_py/py.typed",
    }


def test_wheel_holds_every_package_under_plugins_whole(contents: Dict[str, bytes], tree: Path) -> None:
    files = {path for path in (tree / "plugins").rglob("*") if path.is_file() and "stubs" not in path.parts}
    for path in files:
        placed = DATA + "share/" + "/".join(path.relative_to(tree / "plugins").parts[1:])
        assert contents[placed] == path.read_bytes()
    assert len(files) > 50


def test_wheel_puts_the_stub_where_no_real_package_lies(contents: Dict[str, bytes]) -> None:
    assert DATA + "share/rqt_mrta_py/stubs/rqt_mrta/package.xml" in contents
    assert DATA + "share/rqt_mrta/package.xml" not in contents


def test_wheel_holds_what_ros_tools_want_of_the_main_package(contents: Dict[str, bytes], tree: Path) -> None:
    share = DATA + "share/rqt_mrta_py/"
    for name in ("package.xml", "msg/Mission.msg", "launch_xml/run.launch", "scripts/mrta", "scripts/in_checkout.py"):
        assert contents[share + name] == (tree / name).read_bytes()
    assert {name for name in contents if name.startswith(share + "msg/")} == {
        f"{share}msg/{path.name}" for path in (tree / "msg").iterdir()
    }


def test_wheel_keeps_run_bits(wheel: Path) -> None:
    with ZipFile(wheel) as archive:
        modes = {entry.filename: entry.external_attr >> 16 for entry in archive.infolist()}
    for folder in ("share/rqt_mrta_py/scripts", "lib/rqt_mrta_py"):
        assert modes[f"{DATA}{folder}/mrta"] & stat.S_IXUSR
        assert not modes[f"{DATA}{folder}/in_checkout.py"] & stat.S_IXUSR


def test_wheel_holds_nothing_that_python_or_tools_left_behind(contents: Dict[str, bytes]) -> None:
    assert [name for name in contents if "__pycache__" in name or name.endswith(".pyc") or ".egg-info" in name] == []


def test_sdist_builds_the_same_wheel(contents: Dict[str, bytes], tree: Path, tmp_path: Path) -> None:
    with tarfile.open(build(tree, "sdist", tmp_path / "sdist")) as archive:
        # The standard library's filter against hostile archives is newer than Python 3.8; this archive is ours.
        if hasattr(tarfile, "data_filter"):
            archive.extraction_filter = staticmethod(tarfile.data_filter)
        archive.extractall(tmp_path)
    unpacked = tmp_path / "rqt_mrta_py-0.1.0"
    with ZipFile(build(unpacked, "wheel", tmp_path / "wheel")) as archive_of_sdist:
        assert {name: archive_of_sdist.read(name) for name in archive_of_sdist.namelist()} == contents
    # It is the catkin package too.
    for name in ("CMakeLists.txt", "package.xml", "env-hooks/55.rqt_mrta_plugins.sh.em", "run", "bootstrap/debian.py"):
        assert (unpacked / name).read_bytes() == (tree / name).read_bytes()


def test_editable_installation_copies_no_plugin(tree: Path, tmp_path: Path, wheel: Path) -> None:
    """Copies below share would stand before the checkout's own and grow stale."""
    with ZipFile(build(tree, "editable", tmp_path / "editable")) as archive:
        assert [name for name in archive.namelist() if ".data/" in name] == []


def test_metadata_are_valid(contents: Dict[str, bytes], wheel: Path) -> None:
    metadata = pytest.importorskip("packaging.metadata")
    parsed = metadata.Metadata.from_email(contents[METADATA], validate=False)
    # Each field is checked against the standard when it is read.
    assert (parsed.name.replace("-", "_"), str(parsed.version)) == ("rqt_mrta_py", "0.1.0")
    assert parsed.summary.startswith("A supervisor")
    assert str(parsed.requires_python) == ">=3.8"
    assert parsed.description_content_type == "text/markdown"
    assert parsed.description.startswith("# rqt_mrta_py\n")
    assert "Typing :: Typed" in parsed.classifiers
    assert wheel.name == "rqt_mrta_py-0.1.0-py3-none-any.whl"


def test_licence_lies_in_the_wheel(contents: Dict[str, bytes], tree: Path) -> None:
    (found,) = [text for name, text in contents.items() if ".dist-info/" in name and name.endswith("/LICENSE")]
    assert found == (tree / "LICENSE").read_bytes()


@pytest.mark.skipif(sys.version_info < (3, 10), reason="Python names its own modules from 3.10 on")
def test_wheel_asks_for_what_is_imported_and_for_nothing_else(contents: Dict[str, bytes]) -> None:
    requirements = pytest.importorskip("packaging.requirements")
    lines = re.findall(r"^Requires-Dist: (.*)$", contents[METADATA].decode(), re.MULTILINE)
    asked = {requirements.Requirement(line).name.lower() for line in lines if not re.search("extra == .test.", line)}
    assert asked == {IMPORTED_AS.get(name, name) for name in foreign_imports()}


def foreign_imports() -> Set[str]:
    """Name what src and the plugins import, lazily or not, of neither Python nor ROS nor this project."""
    own = {"rqt_mrta_py", *(path.name for path in ROOT.glob("plugins/*/*/src/*"))}
    files = [*(ROOT / "src").rglob("*.py"), *ROOT.glob("plugins/*/*/src/**/*.py")]
    found = {name.split(".")[0] for path in files for name in imports(ast.parse(path.read_text(encoding="utf-8")))}
    return found - own - OF_ROS - {*sys.stdlib_module_names}


def imports(module: ast.Module) -> Iterator[str]:
    """Give the names of modules that a module imports, by statement or by the render room's ``require``."""
    for node in ast.walk(module):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.module or ""
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "require":
            name = node.args[0].values[0] if isinstance(node.args[0], ast.JoinedStr) else node.args[0]
            yield from ([str(name.value)] if isinstance(name, ast.Constant) else [])


def test_every_package_has_the_version_of_the_whole() -> None:
    versions = {path.parent.name: ElementTree.parse(path).findtext("version") for path in MANIFESTS}
    assert versions == dict.fromkeys(versions, rqt_mrta_py.__version__)


@pytest.mark.parametrize("path", MANIFESTS[1:], ids=lambda path: path.parent.name)
def test_plugin_package_lies_in_a_folder_of_its_name(path: Path) -> None:
    """The wheel and CMakeLists.txt name packages by their folders."""
    assert ElementTree.parse(path).findtext("name") == path.parent.name


@pytest.mark.parametrize("path", MANIFESTS, ids=lambda path: path.parent.name)
def test_manifest_is_one_that_catkin_accepts(path: Path) -> None:
    package = pytest.importorskip("catkin_pkg.package")
    warnings: List[str] = []
    package.parse_package(str(path), warnings=warnings)
    assert warnings == []
