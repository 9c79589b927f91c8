"""``mrta list``: what is registered and who implements what, without importing anybody's code."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.app.loading.own_plugins import OWN_PLUGINS
from rqt_mrta_py.hooks.contract import HOOKS
from tests.app.cli.conftest import Command

OBSERVER = (
    "from rqt_mrta_py.hooks import hookimpl\n\n\n"
    "@hookimpl\ndef mrta_on_event(event):\n    pass\n\n\n"
    "raise RuntimeError('imported')\n"
)


def cells(table: str) -> List[List[str]]:
    return [[cell.strip() for cell in line.split("  ") if cell.strip()] for line in table.splitlines()]


def plugins(command: Command) -> Dict[str, Any]:
    document = json.loads(command("list", "plugins", "--json").out)
    assert document["schema"] == "rqt_mrta_py/list/1"
    return {entry["module"]: entry for entry in document["plugins"]}


def test_list_plugins_shows_module_package_and_hooks_unimported(command: Command, stranger: Path) -> None:
    stranger.write_text(OBSERVER)

    told = command("list", "plugins")

    assert (told.status, told.err) == (0, "")
    rows = cells(told.out)
    assert rows[:2] == [["PLUGIN", "PACKAGE", "HOOKS"], ["stranger_plugin", "stranger", "mrta_on_event"]]
    assert "stranger_plugin" not in sys.modules


def test_list_plugins_ends_with_the_projects_own_rooms(command: Command) -> None:
    listed = plugins(command)

    assert tuple(listed)[-len(OWN_PLUGINS) :] == OWN_PLUGINS
    assert {listed[module]["name"] for module in OWN_PLUGINS} == {"rqt_mrta_py"}
    assert listed["rqt_mrta_py.supervisor.plugin"]["hooks"] == [
        "mrta_register_incident_rules",
        "mrta_register_statistics",
    ]


def test_list_plugins_says_so_where_there_is_no_source(command: Command, stranger: Path) -> None:
    assert not stranger.exists()

    assert cells(command("list", "plugins").out)[1] == ["stranger_plugin", "stranger", "unknown: no source found"]
    assert plugins(command)["stranger_plugin"]["hooks"] is None


def test_list_plugins_marks_those_that_are_blocked(
    command: Command, stranger: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stranger.write_text(OBSERVER)
    monkeypatch.setenv("RQT_MRTA_PY_BLOCK_PLUGINS", "stranger")

    assert cells(command("list", "plugins").out)[1][0] == "stranger_plugin (blocked)"
    assert [module for module, entry in plugins(command).items() if entry["blocked"]] == ["stranger_plugin"]


def test_list_hooks_names_every_hook_with_who_implements_it(command: Command, stranger: Path) -> None:
    stranger.write_text(OBSERVER)

    rows = cells(command("list", "hooks").out)
    document = json.loads(command("list", "hooks", "--json").out)

    assert rows[0] == ["KIND", "NAME", "IMPLEMENTED BY"]
    assert [row[1] for row in rows[1:]] == list(HOOKS)
    implementers = {row["name"]: row["implemented_by"] for row in document["hooks"]}
    assert implementers["mrta_on_event"][0] == "stranger_plugin"
    assert implementers["mrta_register_planners"] == ["rqt_mrta_py.robot.plugin"]


def test_list_shows_all_kinds_but_hooks(command: Command) -> None:
    rows = cells(command("list").out)
    document = json.loads(command("list", "--json").out)

    assert {row[0] for row in rows[1:]} == {"architecture", "application", "plugin"}
    assert list(document) == ["schema", "architectures", "applications", "plugins"]
    assert ["plugin", "rqt_mrta_py", "rqt_mrta_py.sim.plugin"] in [row[:3] for row in rows]


def test_a_type_lets_no_plugin_through_for_they_have_none(command: Command) -> None:
    assert json.loads(command("list", "plugins", "--type", "ST-SR-IA", "--json").out)["plugins"] == []


def test_listing_imports_no_plugin_and_no_heavy_library() -> None:
    """What ``mrta list`` imports decides how long a user waits for it."""
    program = (
        "import sys\n"
        "from rqt_mrta_py.app.cli.main import main\n"
        "main(['list'])\n"
        "names = {name.partition('.')[0] for name in sys.modules}\n"
        "heavy = {'numpy', 'scipy', 'cv2', 'pybullet', 'rosbags', 'matplotlib', 'rich', 'mrta_alliance', 'pluggy'}\n"
        "print(sorted(names & heavy), file=sys.stderr)\n"
    )

    done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True, timeout=60)

    assert done.stderr == "[]\n"
