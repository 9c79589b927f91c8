"""Packages with several mistakes: one hides no other."""

from __future__ import annotations

from tests.app.doctor.conftest import Workspace

TASKS = "tasks:\n  - {id: wonder, kind: wonder}\n"
SCENARIO = """arena: {min_x: -3, min_y: -3, max_x: 3, max_y: 3}
robots:
  - id: robot2
    start: {x: 0, y: 0}
    sensors: [{kind: localizer, topic: pose, rate: 10}]
"""


def with_scenario(workspace: Workspace, text: str) -> None:
    """Let yard be simulated, under an architecture that can be."""
    tag = 'tasks="${prefix}/tasks.yaml"'
    workspace.replace("yard/package.xml", tag, f'{tag} scenario="${{prefix}}/scenario.yaml"')
    workspace.replace("yard/package.xml", "<exec_depend>auction<", "<exec_depend>nearest_robot<")
    workspace.replace("yard/CMakeLists.txt", "tasks.yaml", "tasks.yaml scenario.yaml")
    workspace.replace("yard/rqt_mrta.xml", ">auction<", ">nearest_robot<")
    workspace.replace("yard/rqt_mrta.xml", ">robot1_bidder<", ">robot1_nearest_robot_params<")
    workspace.write("yard/scenario.yaml", text)


def test_a_task_that_is_not_listed_hides_no_kind_that_nobody_registers(workspace: Workspace) -> None:
    workspace.write("yard/tasks.yaml", TASKS)

    listed, kind = workspace.told()

    assert listed == "yard/rqt_mrta.xml:10: robot1/tasks: 'wander' is not in tasks.yaml; nearest is 'wonder'"
    assert kind.startswith("yard/tasks.yaml:2: tasks[0]/kind: ")
    assert "'wonder'" in kind


def test_a_robot_that_is_not_of_the_team_hides_no_sensor_that_nobody_registers(workspace: Workspace) -> None:
    with_scenario(workspace, SCENARIO)

    missing, strange, sensor = workspace.told()

    assert missing == "yard/scenario.yaml:2: robots: the application also has robot1; say where they start"
    assert strange == "yard/scenario.yaml:3: robots[0]/id: 'robot2' is no robot of the application; nearest is 'robot1'"
    assert sensor.startswith("yard/scenario.yaml:5: robots[0]/sensors[0]: no sensor 'localizer'")


def test_a_missing_file_is_told_once(workspace: Workspace) -> None:
    (workspace.folder / "yard/tasks.yaml").unlink()

    (only,) = workspace.told()

    assert only.startswith("yard/package.xml:16: export/rqt_mrta_py/@tasks: names a file that does not exist")
