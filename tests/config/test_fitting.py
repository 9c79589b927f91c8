"""Tasks against an architecture's taxonomy."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, List

import pytest

from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.fitting import misfit_problems
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.config.yaml.lines import YamlLines
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import ArchitectureSpec, Task, Taxonomy

MANIFEST = "<package><name>{}</name><depend>rqt_mrta_py</depend><export><rqt_mrta_py {}/></export></package>"
TASKS = "tasks:\n- {id: dig, kind: dig}\n- id: lift\n  kind: lift\n  robots: 2\n  predecessors: [dig]\n"


def said(taxonomy: str) -> List[str]:
    tasks = [Task("dig", "dig", expected_duration=5.0), Task("lift", "lift", robots=2, predecessors=("dig",))]
    spec = ArchitectureSpec("auction", "Auction", Taxonomy.parse(taxonomy))
    return [str(problem) for problem in misfit_problems(spec, tasks, TASKS, "tasks.yaml")]


def test_task_of_several_robots_does_not_fit_single_robot_tasks() -> None:
    assert said("ST-SR-IA") == [
        "tasks.yaml:5: tasks[1]/robots: is 2, but auction (ST-SR-IA) gives each task to one robot; give 1, or choose "
        "an architecture for tasks of several robots (mrta list architectures --type=-MR-)"
    ]


@pytest.mark.parametrize("taxonomy", ["ST-MR-IA", "MT-MR-TA", "--", "ST--IA"])
def test_order_and_duration_fit_every_architecture_and_several_robots_all_but_one_type(taxonomy: str) -> None:
    assert said(taxonomy) == []


def test_mission_that_does_not_fit_is_refused_unless_it_need_not_fit(
    tmp_path: Path, write: Callable[[str, str], Path]
) -> None:
    write("ws/yard/package.xml", MANIFEST.format("yard", 'application="rqt_mrta.xml" tasks="tasks.yaml"'))
    write(
        "ws/yard/rqt_mrta.xml",
        "<rqt_mrta><application><name>Yard</name><architecture>auction</architecture>"
        "<robots><robot_0><id>r1</id></robot_0></robots></application></rqt_mrta>",
    )
    write("ws/yard/tasks.yaml", TASKS)
    write("ws/auction/package.xml", MANIFEST.format("auction", 'architecture="rqt_mrta.xml"'))
    write(
        "ws/auction/rqt_mrta.xml",
        "<rqt_mrta><architecture><name>A</name><tasks><type>SR</type></tasks></architecture></rqt_mrta>",
    )
    registry = discover({"ROS_PACKAGE_PATH": str(tmp_path / "ws")}, "/nowhere", (), (), ())

    with pytest.raises(ConfigError, match=r"tasks\.yaml:5: tasks\[1\]/robots: is 2, but auction \(-SR-\)"):
        load_mission(registry, "yard")
    assert [task.id for task in load_mission(registry, "yard", must_fit=False).tasks] == ["dig", "lift"]


@pytest.mark.parametrize(
    ("element", "line", "given"),
    [
        ("tasks", 1, True),
        ("tasks[0]/kind", 2, True),
        ("tasks[1]", 3, True),
        ("tasks[1]/robots", 5, True),
        ("tasks[1]/place/x", 3, False),
        ("tasks[2]", 1, False),
        ("tasks[1]/robots[0]", 5, False),
        ("robots", 1, False),
    ],
)
def test_lines_are_found_by_the_names_of_problems(element: str, line: int, given: bool) -> None:
    lines = YamlLines(TASKS)

    assert (lines.of(element), lines.has(element)) == (line, given)


def test_no_line_is_known_of_what_is_no_yaml() -> None:
    assert YamlLines("tasks: [").of("tasks") == 0
