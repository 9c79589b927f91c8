from __future__ import annotations

from pathlib import Path

from rqt_mrta_py.config.packages.workspace import find_toplevel, look_at_workspace


def make_catkin(prefix: Path) -> Path:
    toplevel = prefix / "share" / "catkin" / "cmake" / "toplevel.cmake"
    toplevel.parent.mkdir(parents=True)
    toplevel.write_text("")
    return toplevel


def test_folder_without_a_toplevel_file_becomes_a_workspace(tmp_path: Path) -> None:
    toplevel = make_catkin(tmp_path / "ros")
    found = look_at_workspace(tmp_path / "ws", {"CMAKE_PREFIX_PATH": f"{tmp_path}/nowhere:{tmp_path}/ros"})
    assert not found.exists
    assert found.links == {tmp_path / "ws" / "src" / "CMakeLists.txt": toplevel}


def test_workspace_of_catkin_make_stays_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "CMakeLists.txt").write_text("")
    found = look_at_workspace(tmp_path, {})
    assert found.exists
    assert found.links == {}


def test_workspace_of_catkin_tools_stays_as_it_is(tmp_path: Path) -> None:
    (tmp_path / ".catkin_tools").mkdir()
    assert look_at_workspace(tmp_path, {}).exists


def test_catkin_of_the_environment_comes_first(tmp_path: Path) -> None:
    first, second = make_catkin(tmp_path / "a"), make_catkin(tmp_path / "b")
    assert find_toplevel({"CMAKE_PREFIX_PATH": f"{tmp_path}/a:{tmp_path}/b"}) == first
    assert find_toplevel({"CMAKE_PREFIX_PATH": f"{tmp_path}/b:{tmp_path}/a"}) == second
