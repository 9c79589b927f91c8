"""The taxonomy, by the table of spellings that rqt_mrta reads."""

from __future__ import annotations

import pytest

from rqt_mrta_py.model import AllocationType, RobotType, TaskType, Taxonomy

ROBOTS = {
    RobotType.SINGLE_TASK: "single_task,ST,st,SINGLE_TASK,SingleTask,Single Task,Single Task (ST)",
    RobotType.MULTI_TASK: "multi_task,MT,mt,MULTI_TASK,MultiTask,Multi Task,Multi Task (MT)",
}
TASKS = {
    TaskType.SINGLE_ROBOT: "single_robot,SR,sr,SINGLE_ROBOT,SingleRobot,Single Robot,Single Robot (SR)",
    TaskType.MULTI_ROBOT: "multi_robot,MR,mr,MULTI_ROBOT,MultiRobot,Multi Robot,Multi Robot (MR)",
}
ALLOCATIONS = {
    AllocationType.INSTANTANEOUS: "instantaneous_assignment,IA,ia,INSTANTANEOUS_ASSIGNMENT,InstantaneousAssignment,"
    "Instantaneous Assignment,Instantaneous Assignment (IA)",
    AllocationType.TIME_EXTENDED: "time_extended_assignment,TA,ta,TIME_EXTENDED_ASSIGNMENT,TimeExtendedAssignment,"
    "Time-Extended Assignment,Time-Extended Assignment (TA)",
}


@pytest.mark.parametrize("axis", [ROBOTS, TASKS, ALLOCATIONS], ids=["robots", "tasks", "allocations"])
def test_axis_reads_every_accepted_spelling_and_no_other(axis: dict) -> None:
    kind = type(next(iter(axis)))
    for member, spellings in axis.items():
        for spelling in spellings.split(","):
            assert kind.parse(spelling) is member
    assert set(kind.spellings()) == {word for spellings in axis.values() for word in spellings.split(",")}
    for other in ("", "xx", "St", "Time Extended Assignment", " ST"):
        assert kind.parse(other) is kind.UNKNOWN


@pytest.mark.parametrize(
    ("text", "printed"),
    [("ST-SR-IA", "ST-SR-IA"), ("mt-mr-ta", "MT-MR-TA"), ("-SR-", "-SR-"), ("ST", "ST--"), ("", "--"), ("x-y-z", "--")],
)
def test_taxonomy_prints_what_it_read_and_leaves_unknown_axes_blank(text: str, printed: str) -> None:
    assert str(Taxonomy.parse(text)) == printed


@pytest.mark.parametrize(
    ("wanted", "offered", "accepted"),
    [
        ("--", "ST-SR-IA", True),
        ("--", "--", True),
        ("ST-SR-IA", "ST-SR-IA", True),
        ("MT-SR-IA", "ST-SR-IA", False),
        ("ST-MR-IA", "ST-SR-IA", False),
        ("ST-SR-TA", "ST-SR-IA", False),
        ("-SR-", "MT-SR-TA", True),
        ("ST--", "-SR-IA", False),
        ("-SR-", "ST--IA", False),
        ("--IA", "ST-SR-", False),
    ],
)
def test_taxonomy_as_a_filter_takes_blanks_for_anything(wanted: str, offered: str, accepted: bool) -> None:
    assert Taxonomy.parse(wanted).accepts(Taxonomy.parse(offered)) is accepted
