from __future__ import annotations

from typing import List

import pytest

from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Task, Taxonomy

MISSION = Mission(
    ApplicationSpec("a", "A", robots=(ApplicationRobot("some", ("rest", "dig")), ApplicationRobot("any"))),
    ArchitectureSpec("b", "B", Taxonomy()),
    tuple(Task(name, "kind") for name in ("dig", "fill", "rest")),
)


@pytest.mark.parametrize(
    ("robot", "tasks"),
    [("some", ["dig", "rest"]), ("any", ["dig", "fill", "rest"]), ("stranger", ["dig", "fill", "rest"])],
)
def test_tasks_of_a_robot_are_its_own_in_the_missions_order_and_all_where_it_names_none(
    robot: str, tasks: List[str]
) -> None:
    assert [task.id for task in MISSION.tasks_of(robot)] == tasks
