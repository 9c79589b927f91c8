"""Whatever a package holds, it is told in problems."""

from __future__ import annotations

import os
from pathlib import Path
from typing import List

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.app.doctor.conftest import Workspace, manifest

FILES = (
    "auction/package.xml",
    "auction/CMakeLists.txt",
    "auction/rqt_mrta.xml",
    "auction/launch/bidder.launch",
    "yard/package.xml",
    "yard/rqt_mrta.xml",
    "yard/tasks.yaml",
)


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.sampled_from(FILES), st.integers(0, 2000), st.integers(0, 200), st.binary(max_size=12))
def test_any_bytes_in_any_file_are_told_in_problems(
    workspace: Workspace, name: str, start: int, length: int, put: bytes
) -> None:
    path = workspace.folder / name
    whole = path.read_bytes()
    start %= len(whole)
    try:
        path.write_bytes(whole[:start] + put + whole[start + length :])
        told: List[str] = workspace.told()
        assert all(": " in line for line in told)
    finally:
        path.write_bytes(whole)


@pytest.mark.parametrize("name", FILES)
def test_a_folder_in_the_place_of_a_file_is_told(workspace: Workspace, name: str) -> None:
    (workspace.folder / name).unlink()
    (workspace.folder / name).mkdir()
    assert isinstance(workspace.told(), list)


@pytest.mark.parametrize("pattern", ["", ".", "**x", "a**/b", "launch/../../../../../*", "/*", "[", "~/*"])
def test_patterns_of_files_that_nobody_means_are_passed_over(workspace: Workspace, pattern: str) -> None:
    """Some ended in an error of pathlib, and one walked through all folders of the machine."""
    text = (workspace.folder / "auction/CMakeLists.txt").read_text()
    globs = "".join(f'file({each} found "{pattern}")\n' for each in ("GLOB", "GLOB_RECURSE"))
    workspace.write("auction/CMakeLists.txt", f"{text}{globs}install(FILES ${{found}} DESTINATION share)\n")
    assert workspace.told("auction") == []


def test_links_that_lead_nowhere_or_around_are_passed_over(workspace: Workspace) -> None:
    (workspace.folder / "yard/launch").mkdir()
    (workspace.folder / "yard/launch/a.launch").symlink_to("nowhere")
    (workspace.folder / "yard/around").symlink_to("..")
    workspace.write("listener/package.xml", manifest("listener", "rqt_mrta_py", tag=""))
    (workspace.folder / "listener/a.py").symlink_to("nowhere")
    assert [line.split(": ")[0] for line in workspace.told()] == [
        "listener/package.xml:11",
        "yard/launch/a.launch",
    ]


def test_a_manifest_with_a_namespace_is_read_as_any_other(workspace: Workspace) -> None:
    workspace.replace("yard/package.xml", '<package format="3">', '<package format="3" xmlns="http://a.example">')
    assert workspace.told() == []


def test_an_include_of_itself_comes_to_an_end(workspace: Workspace) -> None:
    workspace.write("yard/launch/a.launch", '<launch><include file="$(find yard)/launch/a.launch"/></launch>')
    assert workspace.told() == []


def test_a_plugin_whose_check_raises_is_told_by_its_name(workspace: Workspace, tmp_path: Path) -> None:
    workspace.replace("auction/package.xml", 'rqt_mrta.xml"/>', 'rqt_mrta.xml" plugin="raising_auction"/>')
    workspace.write(
        "auction/src/raising_auction/__init__.py",
        "from rqt_mrta_py.hooks import hookimpl\n\n\n@hookimpl\ndef mrta_check_parameters(parameters):\n"
        "    raise ZeroDivisionError('of all things')\n",
    )
    workspace.replace("yard/package.xml", "${prefix}/tasks.yaml", "tasks.yaml")
    told = workspace.told("yard", "auction")
    assert [line for line in told if "raising_auction" in line and "ZeroDivisionError: of all things" in line]
    assert [line for line in told if line.startswith("yard/package.xml:16")]


@pytest.mark.parametrize("name", ["config/robot9_auction_params.yaml", "launch/one.launch"])
def test_a_pipe_is_no_file_and_nobody_waits_for_its_writer(workspace: Workspace, name: str) -> None:
    path = workspace.folder / "yard" / name
    path.parent.mkdir(exist_ok=True)
    path.unlink(missing_ok=True)
    os.mkfifo(path)
    assert any("is a pipe or device; a regular file is accepted" in line for line in workspace.told())
