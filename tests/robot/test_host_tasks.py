"""Tasks that appear, are withdrawn, are reassigned, wait for others, or ask for too much."""

from __future__ import annotations

import re
from typing import List, Optional

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import BehaviourStep, Outgoing, Perception, TaskReport
from rqt_mrta_py.model import Pose, Progress, Task
from rqt_mrta_py.robot import RobotHost
from tests.robot.hosting import DIG, MOW, Digger, Scripted, about, hear_progress, make_host, progress_codes

RUNNING, DONE, FAILED, UNREACHABLE, APPEARED, WITHDRAWN, REASSIGNED = range(7)


class Stage:
    """A host, tick by tick, whose agent chooses what the test wants next."""

    def __init__(self, **setup: object) -> None:
        self.wanted: Optional[str] = None
        self.agent = Scripted(lambda _: self.wanted)
        self.host: RobotHost = make_host(self.agent, **setup)  # type: ignore[arg-type]
        self._tick = -1

    def step(self, wanted: Optional[str] = None) -> List[Outgoing]:
        self.wanted = wanted
        self._tick += 1
        return list(self.host.step(self._tick, 1.0 + self._tick / 20))

    def tell(self, task: str, progress: int, robot: str = "", definition: str = "") -> None:
        hear_progress(self.host, task, robot, progress, definition=definition)

    @property
    def applicable(self) -> List[str]:
        return [task for task, yes in self.agent.told[-1].applicable.items() if yes]

    @property
    def reports(self) -> List[TaskReport]:
        return list(self.agent.told[-1].reports)


def warnings(said: List[Outgoing]) -> List[str]:
    return [line["msg"] for line in about(said, "/rosout") if line["level"] == 4]


def test_host_carries_out_a_withdrawn_task_that_appears_again() -> None:
    digger = Digger()
    stage = Stage(dig=digger)
    stage.step("dig1")
    stage.tell("dig1", WITHDRAWN)
    stage.step("dig1")
    assert stage.host.task is None
    stage.tell("dig1", APPEARED)
    stage.step("dig1")
    assert digger.started == 2
    assert stage.host.task == "dig1"


def test_later_task_is_not_applicable_and_not_begun_until_it_appears() -> None:
    stage = Stage(tasks=(DIG,), later=(MOW,))
    said = stage.step("mow1")
    assert stage.applicable == ["dig1"]
    assert warnings(said) == ["robot=robot1 task=mow1 chosen, but it is not there yet"]
    stage.tell("mow1", APPEARED)
    said = stage.step("mow1")
    assert stage.applicable == ["dig1", "mow1"]
    assert stage.reports == [TaskReport("mow1", Progress.APPEARED)]
    assert progress_codes(said) == [("mow1", RUNNING)]


def test_later_task_that_is_withdrawn_before_it_appears_works_once_it_appears() -> None:
    stage = Stage(tasks=(DIG,), later=(MOW,))
    stage.tell("mow1", WITHDRAWN)
    stage.step()
    assert stage.applicable == ["dig1"]
    stage.tell("mow1", APPEARED)
    stage.step()
    assert stage.applicable == ["dig1", "mow1"]


def test_task_that_nobody_knew_becomes_the_robots_own() -> None:
    stage = Stage(tasks=(DIG,), capabilities=frozenset({"spade"}))
    stage.tell("/dig2", APPEARED, definition="{id: dig2, kind: dig, place: {x: 1, y: 2}, capabilities: [spade]}")
    said = stage.step("dig2")
    task = Task("dig2", "dig", Pose(1.0, 2.0), ("spade",))
    assert stage.reports == [TaskReport("dig2", Progress.APPEARED, definition=task)]
    assert stage.applicable == ["dig1", "dig2"]
    assert progress_codes(said) == [("dig2", RUNNING)]
    assert stage.agent.told[-1].cost("dig2") == 3.5


@pytest.mark.parametrize(
    ("definition", "problem"),
    [
        ("{id: new, kind: sow}", "no behaviour carries out the kind 'sow'; there are 'dig', 'mow'"),
        ("{id: new, kind: dig, capabilities: [arm]}", "it asks for 'arm', which this robot cannot do"),
        ("{id: new, kind: mow}", "behaviour 'mow' cannot begin: ValueError: no blade for 'new'"),
        ("{id: other, kind: dig}", "task_yaml: defines 'other'"),
        ("{id: new}", "task_yaml:1: kind: is missing; give a text"),
        ("{id: new, kind: dig, robots: 0, perpetual: 7}", "task_yaml:1: perpetual: .* \\(and 1 more\\)"),
        ("]", "task_yaml:1: is not YAML: .*"),
        ("", "this robot does not know it, and nobody says what it is"),
    ],
)
def test_task_that_the_robot_cannot_make_its_own_is_a_warning_and_nothing_else(definition: str, problem: str) -> None:
    mower = Digger()

    def refuse(task: Task, _: Perception) -> bool:
        raise ValueError(f"no blade\n for {task.id!r}")

    mower.applicable = refuse  # type: ignore[method-assign]
    stage = Stage(tasks=(DIG,), capabilities=frozenset(), mow=mower)
    stage.step("dig1")
    stage.tell("new", APPEARED, definition=definition)
    said = stage.step("dig1")
    (warning,) = warnings(said)
    assert re.fullmatch(f"robot=robot1 task=new appeared, but {problem}", warning)
    assert stage.reports == []
    assert stage.applicable == ["dig1"]
    assert stage.host.task == "dig1"
    assert warnings(stage.step("dig1")) == []


def test_known_task_appears_though_the_text_is_nonsense() -> None:
    stage = Stage(tasks=(DIG,), later=(MOW,))
    stage.tell("mow1", APPEARED, definition="{")
    said = stage.step()
    assert [line.split(":")[0] for line in warnings(said)] == ["robot=robot1 task=mow1 appeared, but task_yaml"]
    assert stage.reports == [TaskReport("mow1", Progress.APPEARED)]
    assert stage.applicable == ["dig1", "mow1"]


def test_task_of_others_does_not_become_the_robots_own() -> None:
    stage = Stage(tasks=(DIG,), others=frozenset({"dig2"}))
    stage.tell("dig2", APPEARED, definition="{id: dig2, kind: dig}")
    assert warnings(stage.step()) == []
    assert stage.reports == [TaskReport("dig2", Progress.APPEARED, definition=Task("dig2", "dig"))]
    assert stage.applicable == ["dig1"]


def test_task_that_appears_as_something_else_is_begun_anew_as_that() -> None:
    digger, mower = Digger(), Digger()
    stage = Stage(dig=digger, mow=mower)
    stage.step("dig1")
    stage.tell("dig1", APPEARED, definition="{id: dig1, kind: dig}")
    stage.step("dig1")
    assert (digger.started, stage.host.task) == (1, "dig1")
    stage.tell("dig1", APPEARED, definition="{id: dig1, kind: mow}")
    stage.step("dig1")
    assert (digger.started, mower.started, stage.host.task) == (1, 1, "dig1")
    stage.tell("dig1", APPEARED, definition="{id: dig1, kind: sow}")
    stage.step()
    assert stage.host.task is None
    assert stage.applicable == ["mow1"]


def test_task_waits_for_its_predecessors_whoever_does_them() -> None:
    last = Task("mow2", "mow", predecessors=("dig1", "mow1", "dig2"))
    stage = Stage(tasks=(DIG, MOW, last), others=frozenset({"dig2"}))
    said = stage.step("mow2")
    assert warnings(said) == ["robot=robot1 task=mow2 chosen, but 'dig1', 'mow1', 'dig2' must be done before"]
    stage.tell("dig2", DONE, "robot2")
    stage.tell("dig1", DONE)
    stage.tell("mow1", FAILED, "robot2")
    stage.step()
    assert "mow2" not in stage.applicable
    stage.tell("mow1", APPEARED)
    stage.tell("mow1", DONE, "robot2")
    stage.step()
    assert stage.applicable == ["mow2"]
    stage.tell("dig1", APPEARED)
    stage.step()
    assert stage.applicable == ["dig1"]


def test_task_follows_what_the_robot_itself_has_done() -> None:
    digger = Digger((BehaviourStep(progress=Progress.DONE),))
    stage = Stage(tasks=(DIG, Task("mow2", "mow", predecessors=("dig1",))), dig=digger)
    stage.step("dig1")
    assert stage.applicable == ["dig1"]
    stage.step()
    assert stage.applicable == ["mow2"]


def test_task_that_asks_for_too_much_is_never_carried_out() -> None:
    heavy = Task("dig2", "dig", capabilities=("spade", "crane"))
    asked: List[str] = []
    digger = Digger()

    def applicable(task: Task, _: Perception) -> bool:
        asked.append(task.id)
        return True

    digger.applicable = applicable  # type: ignore[method-assign]
    stage = Stage(tasks=(DIG, heavy), capabilities=frozenset({"spade"}), dig=digger)
    said = stage.step("dig2")
    assert warnings(said) == ["robot=robot1 task=dig2 chosen, but it asks for 'crane', which this robot cannot do"]
    assert stage.applicable == ["dig1"]
    assert set(asked) == {"dig1"}
    unchecked = Stage(tasks=(DIG, heavy))
    unchecked.step()
    assert unchecked.applicable == ["dig1", "dig2"]


def test_robot_that_was_paused_does_not_know_what_appeared_meanwhile() -> None:
    stage = Stage(tasks=(DIG,), later=(MOW,))
    stage.host.pause()
    stage.tell("mow1", APPEARED)
    stage.host.resume()
    stage.step()
    assert stage.applicable == ["dig1"]


texts = st.sampled_from(
    [
        "",
        "{",
        "id: dig1",
        "{id: dig1, kind: dig}",
        "{id: dig1, kind: mow}",
        "{id: new, kind: mow, predecessors: [dig1]}",
    ]
)
messages = st.tuples(
    st.sampled_from(["dig1", "mow1", "mow2", "new", "", "/", "a\nb"]),
    st.integers(0, 8),
    st.sampled_from(["", "robot1", "/robot2"]),
    texts | st.text(max_size=20),
)


@settings(max_examples=200, deadline=None)
@given(st.lists(messages | st.sampled_from([None, "dig1", "mow1", "mow2"]), max_size=30))
def test_host_goes_on_whatever_is_said_of_tasks(story: list) -> None:
    """What it carries out is always one of its own; a task that is not applicable is not begun; one line a warning."""
    stage = Stage(tasks=(DIG, MOW), later=(Task("mow2", "mow", capabilities=("blade",)),), capabilities=frozenset())
    for each in story:
        if isinstance(each, tuple):
            stage.tell(each[0], each[1], each[2], each[3])
            continue
        before = stage.host.task
        said = stage.step(each)
        begun = [task for task, code in progress_codes(said) if code == RUNNING]
        assert all(task in stage.applicable for task in begun)
        assert stage.host.task in (before, each, None)
        assert "mow2" not in stage.applicable
        assert all("\n" not in line for line in warnings(said))
