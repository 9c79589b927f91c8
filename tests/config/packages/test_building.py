from __future__ import annotations

from pathlib import Path

import pytest

from rqt_mrta_py.config.packages.building import build_package, listing
from rqt_mrta_py.errors import ConfigError

FILES = {"package.xml": "<package/>\n", "src/yard/__init__.py": "", "config/a.yaml": "a: ä\n"}


def test_listing_holds_files_and_folders_sorted() -> None:
    assert listing(FILES) == ("config/", "config/a.yaml", "package.xml", "src/", "src/yard/", "src/yard/__init__.py")


def test_package_is_whole_and_nothing_else_is_left(tmp_path: Path) -> None:
    folder = tmp_path / "ws" / "src" / "yard"
    build_package(folder, FILES, {})
    assert {path: (folder / path).read_text(encoding="utf-8") for path in FILES} == FILES
    assert list(folder.parent.iterdir()) == [folder]
    assert folder.stat().st_mode == (tmp_path / "ws").stat().st_mode


def test_link_of_a_workspace_is_made(tmp_path: Path) -> None:
    toplevel = tmp_path / "toplevel.cmake"
    toplevel.write_text("")
    source = tmp_path / "ws" / "src"
    build_package(source / "yard", FILES, {source / "CMakeLists.txt": toplevel})
    assert (source / "CMakeLists.txt").resolve() == toplevel


@pytest.mark.parametrize("kind", ["folder", "empty folder", "file", "dangling link"])
def test_what_is_there_is_left_alone(tmp_path: Path, kind: str) -> None:
    folder = tmp_path / "yard"
    if kind == "file":
        folder.write_text("mine")
    elif kind == "dangling link":
        folder.symlink_to(tmp_path / "nowhere")
    else:
        folder.mkdir()
    if kind == "folder":
        (folder / "mine.txt").write_text("mine")
    before = sorted(tmp_path.rglob("*"))
    with pytest.raises(ConfigError) as caught:
        build_package(folder, FILES, {})
    assert str(caught.value) == f"{folder}: The given package [yard] already exists."
    assert sorted(tmp_path.rglob("*")) == before


def test_failure_leaves_neither_package_nor_folders_nor_link(tmp_path: Path) -> None:
    source = tmp_path / "ws" / "src"
    files = {**FILES, "src": "a file where others need a folder"}
    with pytest.raises(ConfigError, match=r"cannot be written: .*; nothing was changed"):
        build_package(source / "yard", files, {source / "CMakeLists.txt": tmp_path})
    assert list(tmp_path.iterdir()) == []


def test_interrupt_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(_self: Path, _target: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "rename", interrupt)
    with pytest.raises(KeyboardInterrupt):
        build_package(tmp_path / "deep" / "yard", FILES, {})
    assert list(tmp_path.iterdir()) == []
