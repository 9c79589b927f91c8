"""One copy of the checkout, one wheel, one installation of it and one catkin workspace for all tests here."""

from __future__ import annotations

import importlib.util
import shutil
import sys
from importlib import metadata
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.packaging.builds import Environment, build, copy_checkout, link_distributions, make_environment, run
from tests.packaging.spaces import Workspace, catkin_make, need_catkin

ABOUT = ["--description", "Looks after a yard.", "--maintainer", "Ann", "--email", "ann@example.org"]


@pytest.fixture(scope="session")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Copy the checkout: nobody edits the copy, and builds leave their traces there."""
    return copy_checkout(ROOT, tmp_path_factory.mktemp("packaging") / "a checkout")


@pytest.fixture(scope="session")
def wheel(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the wheel from the copy."""
    _need("setuptools", "wheel")
    return build(tree, "wheel", tmp_path_factory.mktemp("packaging") / "dist")


@pytest.fixture(scope="session")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Environment:
    """Install the wheel into an environment that holds nothing but what the wheel asks for, and no ROS."""
    _need("packaging", "pip")
    environment = make_environment(tmp_path_factory.mktemp("packaging") / "environment")
    pip = [sys.executable, "-m", "pip", "--python", str(environment.python), "install", "--quiet", "--no-index"]
    run([*pip, "--no-deps", str(wheel)], environment.folder)
    (site,) = environment.folder.glob("lib/python*/site-packages")
    (info,) = site.glob("rqt_mrta_py-*.dist-info")
    requires = metadata.PathDistribution(info).requires or []
    unmet = link_distributions([name.split(";")[0] for name in requires if "'test'" not in name], site)
    if unmet:
        pytest.skip(f"not in this environment: {', '.join(unmet)}")
    return environment


@pytest.fixture(scope="session")
def workspace(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    """Let mrta make a workspace with an architecture and two applications; add this repository, and build."""
    need_catkin()
    folder = tmp_path_factory.mktemp("workspace").resolve() / "ws"
    for plan in (
        ["architecture", "fetch_first", "--type", "ST-SR-IA"],
        ["application", "yard", "--architecture", "fetch_first", "--robots", "2", "--tasks", "3"],
        ["application", "gate", "--architecture", "mrta_alliance", "--robots", "3", "--tasks", "4"],
    ):
        mrta = [sys.executable, "-m", "rqt_mrta_py", "new", *plan, *ABOUT, "--workspace", str(folder)]
        run(mrta, folder.parent, ROS_PACKAGE_PATH=str(folder / "src"))
    assert (folder / "src" / "CMakeLists.txt").is_symlink()
    shutil.copytree(tree, folder / "src" / "rqt_mrta_py")
    return catkin_make(folder)


def _need(*modules: str) -> None:
    # Looked for, not imported: setuptools patches the standard library when it is.
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    if missing:
        pytest.skip(f"not installed: {', '.join(missing)}")
