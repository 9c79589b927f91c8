"""One mission of border_patrol, run once and looked at by many tests; the command, run in an empty folder."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import List, Tuple

import pytest

from rqt_mrta_py.app.cli.main import main
from tests.app.outputs import Mrta, Outputs

PLUGIN_MANIFEST = """<package format="3">
  <name>stranger</name> <version>0.1.0</version> <description>d</description>
  <maintainer email="a@b.c">m</maintainer> <license>l</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export> <rqt_mrta_py plugin="stranger_plugin"/> </export>
</package>
"""


@pytest.fixture(scope="session")
def patrol(tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Run border_patrol for 150 s: robot3 is lost at 60 s, robot2 is away from 100 to 135 s."""
    folder = tmp_path_factory.mktemp("patrol") / "run"
    status = main(["run", "border_patrol", "--duration", "150", "--pictures", "10", "--out", str(folder), "-q"])
    assert status == 0
    return Outputs(folder)


@pytest.fixture(scope="session")
def short_patrol(tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Run border_patrol for 2 s: for what holds of any run."""
    folder = tmp_path_factory.mktemp("short_patrol") / "run"
    status = main(["run", "border_patrol", "--duration", "2", "--pictures", "0", "--out", str(folder), "-q"])
    assert status == 0
    return Outputs(folder)


@pytest.fixture(scope="session")
def patrol_review(patrol: Outputs, tmp_path_factory: pytest.TempPathFactory) -> Outputs:
    """Review the bag of that run."""
    folder = tmp_path_factory.mktemp("patrol") / "review"
    status = main(["review", str(patrol.bag), "--pictures", "10", "--out", str(folder), "-q"])
    assert status == 0
    return Outputs(folder)


@pytest.fixture
def mrta(capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Mrta:
    """Run a command in an empty folder; gives its status and its lines on stderr."""
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)

    def run(*arguments: str) -> Tuple[int, List[str]]:
        try:
            status = main(list(arguments))
        except SystemExit as stop:
            status = int(stop.code or 0)
        return status, capsys.readouterr().err.splitlines()

    return run


@pytest.fixture
def yard(tmp_path: Path, root: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Copy border_patrol to a package of one's own that can be broken, and put it on the path."""
    package = tmp_path / "packages" / "yard"
    shutil.copytree(str(root / "plugins" / "applications" / "border_patrol"), str(package))
    manifest = package / "package.xml"
    manifest.write_text(manifest.read_text().replace("<name>border_patrol</name>", "<name>yard</name>"))
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "packages"))
    return package


@pytest.fixture
def stranger(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Put a stranger's plugin package on the path; gives the file of its module, to be written."""
    source = tmp_path / "packages" / "stranger" / "src"
    source.mkdir(parents=True)
    (source.parent / "package.xml").write_text(PLUGIN_MANIFEST)
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "packages"))
    monkeypatch.syspath_prepend(str(source))
    monkeypatch.delitem(__import__("sys").modules, "stranger_plugin", raising=False)
    return source / "stranger_plugin.py"
