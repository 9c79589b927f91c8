"""Whatever is edited, in whatever order: the application loads, or nothing changes and the problems are told."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any, Dict, List

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.editing.configuring import plan_configuration
from rqt_mrta_py.config.editing.robots import AddRobot, RemoveRobot, RenameRobot
from rqt_mrta_py.config.editing.tasks import AddTask, RemoveTask, RenameTask
from rqt_mrta_py.config.editing.values import SetValue, UnsetValue
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.errors import ConfigError
from tests.config.editing.yard import APPLICATION, ARCHITECTURE, FILES, MANIFEST, SCENARIO, TASKS

THERE = st.sampled_from(["robot1", "robot2", "robot2", "robot3"])
NEW = st.sampled_from(["scout", "on", "a/b", "robot1", "x y", ""])
ROBOTS = THERE | NEW
TASKS_THERE = st.sampled_from(["dig", "carry", "rest", "rest"])
TASKS_NEW = st.sampled_from(["nap", "12", "a:b", "{x}", "é", "dig"])
PATHS = st.sampled_from(["rate", "name", "sets/size", "sets/set0/drive/gain", "sets/set2/task_id", "sets/set1", "x"])
TEXTS = st.sampled_from(["1", "2.5", "-3", "abc", "on", "<&>", "@task_id@", "", "é"])
EDITS = st.one_of(
    st.builds(AddRobot, NEW, st.lists(TASKS_THERE, max_size=2).map(tuple)),
    st.builds(RemoveRobot, THERE | NEW),
    st.builds(RenameRobot, THERE, NEW),
    st.builds(AddTask, TASKS_NEW, st.lists(THERE, max_size=2).map(tuple), st.sampled_from(["wander", None])),
    st.builds(RemoveTask, TASKS_THERE | TASKS_NEW),
    st.builds(RenameTask, TASKS_THERE, TASKS_NEW),
    st.builds(SetValue, st.builds("{}/{}".format, THERE, PATHS), TEXTS),
    st.builds(SetValue, st.just("robot1/rate"), st.sampled_from(["1", "2.5"])),
    st.builds(UnsetValue, st.builds("{}/{}".format, ROBOTS, PATHS)),
)


def write(folder: Path) -> Path:
    for name in ("home", "yard"):
        (folder / name).mkdir()
    (folder / "home" / "package.xml").write_text(
        MANIFEST.format(name="home", export='architecture="${prefix}/rqt_mrta.xml"')
    )
    (folder / "home" / "rqt_mrta.xml").write_text(ARCHITECTURE.replace("{name}", "home"))
    yard = folder / "yard"
    (yard / "package.xml").write_text(MANIFEST.format(name="yard", export=FILES))
    (yard / "rqt_mrta.xml").write_text(APPLICATION)
    (yard / "tasks.yaml").write_text(TASKS.replace("    predecessors: [dig]\n", ""))
    (yard / "scenario.yaml").write_text(SCENARIO[: SCENARIO.index("events:")])
    return yard


def contents(folder: Path) -> Dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(st.lists(EDITS, min_size=1, max_size=3), min_size=1, max_size=4))
def test_any_edits_leave_an_application_that_loads(rounds: List[List[Any]]) -> None:
    with tempfile.TemporaryDirectory() as name:
        yard = write(Path(name))
        registry = discover({"ROS_PACKAGE_PATH": name})
        for edits in rounds:
            before = contents(yard)
            try:
                plan_configuration(registry, "yard", None, edits).carry_out()
            except ConfigError:
                assert contents(yard) == before
                continue
            mission = load_mission(registry, "yard")
            assert sorted(mission.parameters) == sorted(robot.id for robot in mission.application.robots)
            text = (yard / "rqt_mrta.xml").read_text(encoding="utf-8")
            assert text.startswith(APPLICATION[: APPLICATION.index("    <robots>")])
            assert plan_configuration(registry, "yard").changes == ()
