"""Whether CMakeLists.txt installs what is exported."""

from __future__ import annotations

import pytest

from tests.app.doctor.conftest import CMAKE, Workspace

SHARE = "${CATKIN_PACKAGE_SHARE_DESTINATION}"
HEAD = "cmake_minimum_required(VERSION 3.5)\nproject(auction)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
LAUNCH = f"install(DIRECTORY launch DESTINATION {SHARE})\n"
FILES = f"install(FILES rqt_mrta.xml DESTINATION {SHARE})\n"
NOT_INSTALLED = (
    "auction/CMakeLists.txt: install: 'rqt_mrta.xml' is not installed, though package.xml:15 exports it; "
    f"give install(FILES rqt_mrta.xml DESTINATION {SHARE})"
)


@pytest.mark.parametrize(
    "rule",
    [
        f"install(FILES rqt_mrta.xml DESTINATION {SHARE})",
        f"INSTALL( FILES\n  # the grammar\n  rqt_mrta.xml #[[ and\n more ]] README\n  DESTINATION {SHARE} )",
        'install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/rqt_mrta.xml" DESTINATION share/${PROJECT_NAME})',
        f"set(CONFIG rqt_mrta.xml b.xml)\ninstall(FILES ${{CONFIG}} DESTINATION {SHARE})",
        f"set(CONFIG a.xml)\nlist(APPEND CONFIG rqt_mrta.xml)\ninstall(FILES ${{CONFIG}} DESTINATION {SHARE}/)",
        f"file(GLOB xml RELATIVE ${{CMAKE_CURRENT_SOURCE_DIR}} *.xml)\ninstall(FILES ${{xml}} DESTINATION {SHARE})",
        f"file(GLOB xml rqt**.xml)\ninstall(FILES ${{xml}} DESTINATION {SHARE})",
        f"foreach(each rqt_mrta.xml other.xml)\n  install(FILES ${{each}} DESTINATION {SHARE})\nendforeach()",
        f"install(DIRECTORY ./ DESTINATION {SHARE} PATTERN .git EXCLUDE)",
        f"install(DIRECTORY . DESTINATION {SHARE} FILES_MATCHING PATTERN *.xml PATTERN *.launch)",
        f"install(FILES [=[rqt_mrta.xml]=] DESTINATION {SHARE})",
        f"install(PROGRAMS rqt_mrta.xml DESTINATION {SHARE})",
    ],
)
def test_a_rule_is_found_in_every_form(workspace: Workspace, rule: str) -> None:
    workspace.write("auction/CMakeLists.txt", f"{HEAD}{LAUNCH}{rule}\n")
    assert workspace.told("auction") == []


@pytest.mark.parametrize(
    "rule",
    [
        "",
        f"# {FILES}",
        f"#[[\n{FILES}]]",
        f'message(STATUS "{FILES.strip()}")',
        f"install(FILES rqt_mrta.xml.in DESTINATION {SHARE})",
        f"install(DIRECTORY . DESTINATION {SHARE} FILES_MATCHING PATTERN *.launch)",
        f"install(DIRECTORY . DESTINATION {SHARE} PATTERN rqt_mrta.xml EXCLUDE)",
    ],
)
def test_what_only_looks_like_a_rule_is_none(workspace: Workspace, rule: str) -> None:
    workspace.write("auction/CMakeLists.txt", f"{HEAD}{LAUNCH}{rule}\n")
    assert workspace.told("auction") == [NOT_INSTALLED]


def test_a_file_that_goes_elsewhere_is_told_with_its_line(workspace: Workspace) -> None:
    workspace.write(
        "auction/CMakeLists.txt", f"{HEAD}{LAUNCH}install(FILES rqt_mrta.xml\n  DESTINATION {SHARE}/config)\n"
    )
    assert workspace.told("auction") == [
        "auction/CMakeLists.txt:6: install: 'rqt_mrta.xml' is installed to share/auction/config, where nobody looks "
        f"for it; give install(FILES rqt_mrta.xml DESTINATION {SHARE})"
    ]


def test_a_renamed_file_is_told(workspace: Workspace) -> None:
    workspace.write(
        "auction/CMakeLists.txt", f"{HEAD}{LAUNCH}install(FILES rqt_mrta.xml DESTINATION {SHARE} RENAME mrta.xml)\n"
    )
    assert len(workspace.told("auction")) == 1


def test_launch_files_are_to_be_installed_and_one_says_enough(workspace: Workspace) -> None:
    workspace.write("auction/launch/another.launch", "<launch/>")
    workspace.write("auction/CMakeLists.txt", f"{HEAD}{FILES}")
    assert workspace.told("auction") == [
        "auction/CMakeLists.txt: install: 'launch/another.launch' is not installed; "
        f"give install(DIRECTORY launch DESTINATION {SHARE})"
    ]


def test_launch_files_may_be_installed_by_the_content_of_their_folder(workspace: Workspace) -> None:
    rule = f"install(DIRECTORY launch/ DESTINATION {SHARE}/launch)\n"
    workspace.write("auction/CMakeLists.txt", f"{HEAD}{FILES}{rule}")
    assert workspace.told("auction") == []


def test_nothing_is_said_where_only_cmake_knows(workspace: Workspace) -> None:
    workspace.write("auction/CMakeLists.txt", f"{HEAD}install(FILES ${{THINGS}} DESTINATION {SHARE})\n")
    assert workspace.told("auction") == []


def test_an_installed_package_needs_no_rules(workspace: Workspace) -> None:
    (workspace.folder / "auction").rename(workspace.folder / "moved")
    (workspace.folder / "share").mkdir()
    (workspace.folder / "moved").rename(workspace.folder / "share" / "auction")
    (workspace.folder / "share/auction/CMakeLists.txt").unlink()
    assert workspace.told("share/auction") == []


def test_a_package_for_catkin_needs_a_cmakelists(workspace: Workspace) -> None:
    (workspace.folder / "auction/CMakeLists.txt").unlink()
    assert workspace.told("auction") == [
        "auction/package.xml:9: buildtool_depend: wants catkin, but there is no CMakeLists.txt beside it; write one"
    ]


def test_the_code_of_a_plugin_is_to_be_installed(workspace: Workspace) -> None:
    workspace.replace("auction/package.xml", 'rqt_mrta.xml"/>', 'rqt_mrta.xml" plugin="installed_auction.plugin"/>')
    workspace.write("auction/src/installed_auction/__init__.py", "")
    workspace.write("auction/src/installed_auction/plugin.py", "")
    assert workspace.told("auction") == [
        "auction/CMakeLists.txt: install: 'src/installed_auction', which package.xml:15 exports as plugin, is not "
        "installed; give catkin_python_setup() and a setup.py"
    ]
    cmake = CMAKE.format(name="auction", files="rqt_mrta.xml")
    workspace.write("auction/CMakeLists.txt", f"{cmake}catkin_python_setup()\n")
    assert workspace.told("auction") == [
        "auction/CMakeLists.txt:9: catkin_python_setup: needs a setup.py, which is missing; write one that names the "
        "package's modules"
    ]
    workspace.write("auction/setup.py", "")
    assert workspace.told("auction") == []
