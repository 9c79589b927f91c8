from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict

import pytest
import yaml

from rqt_mrta_py.config.discovery.registration import Registry
from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.editing.configuring import Configuration, plan_configuration
from rqt_mrta_py.config.editing.robots import AddRobot, RemoveRobot, RenameRobot
from rqt_mrta_py.config.editing.tasks import AddTask, RemoveTask, RenameTask
from rqt_mrta_py.config.editing.values import SetValue
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.errors import ConfigError
from tests.config.editing.yard import APPLICATION, SCENARIO, TASKS

Configure = Callable[..., Configuration]


def gains(registry: Registry, robot: str, architecture: Any = None) -> Dict[str, float]:
    """Give what each task of a robot was given: it must stay with its task whatever comes and goes."""
    sets = load_mission(registry, "yard", architecture).parameters[robot]["sets"]
    elements = [sets[f"set{index}"] for index in range(sets["size"])]
    return {element["task_id"]: element["drive"]["gain"] for element in elements}


def lists(registry: Registry) -> Dict[str, Any]:
    return {robot.id: robot.tasks for robot in load_mission(registry, "yard").application.robots}


def without_events(yard: Path) -> None:
    (yard / "scenario.yaml").write_text(SCENARIO[: SCENARIO.index("events:")])


def test_a_task_comes_to_its_robots(configure: Configure, yard: Path, registry: Registry) -> None:
    configure(AddTask("dock", ("robot1", "robot3"), "wander", (0.5, -1.0, 1.5)))
    entry = "  - {id: dock, kind: wander, place: {x: 0.5, y: -1.0, yaw: 1.5}}\n"
    assert (yard / "tasks.yaml").read_text() == TASKS + entry
    assert lists(registry) == {
        "robot1": ("dig", "carry", "rest", "dock"),
        "robot2": ("carry", "rest"),
        "robot3": ("dig", "dock"),
    }
    assert gains(registry, "robot1") == {"dig": 1.5, "carry": 1.0, "rest": 0.5, "dock": 1.0}
    assert gains(registry, "robot3") == {"dig": 1.0, "dock": 1.0}


def test_a_task_takes_a_free_place_where_others_of_its_kind_have_places(
    configure: Configure, registry: Registry
) -> None:
    """Robots stand at (1, 3), (3, 1), (2, 2), tasks at (1, 1), (3, 3): no place is farther than 1 m from all."""
    configure(AddTask("dock", kind="go_to_place"))
    place = load_mission(registry, "yard").tasks[-1].place
    assert place is not None
    assert (place.x, place.y) == (2.0, 1.0)
    configure(AddTask("nap", kind="wander"))
    mission = load_mission(registry, "yard")
    assert {task.id: task.place for task in mission.tasks}["nap"] is None
    assert lists(registry)["robot2"] == ("carry", "rest", "dock", "nap")


def test_a_kind_that_all_tasks_share_needs_not_be_named(configure: Configure, yard: Path, registry: Registry) -> None:
    without_events(yard)
    configure(RemoveTask("rest"), AddTask("dock"))
    assert load_mission(registry, "yard").tasks[-1].kind == "go_to_place"


def test_a_task_goes_and_the_values_of_others_stay_theirs(configure: Configure, yard: Path, registry: Registry) -> None:
    """robot1 names the tasks of two elements; its third takes what is left."""
    without_events(yard)
    (yard / "tasks.yaml").write_text(TASKS.replace("    predecessors: [dig]\n", ""))
    configure(SetValue("robot2/sets/set1/drive/gain", "4"), AddTask("x", ("robot3",), "wander"))
    configure(RemoveTask("carry"))
    assert gains(registry, "robot1") == {"dig": 1.5, "rest": 0.5}
    assert gains(registry, "robot2") == {"rest": 4.0}
    configure(RemoveTask("dig"))
    assert gains(registry, "robot1") == {"rest": 0.5}
    assert lists(registry) == {"robot1": ("rest",), "robot2": ("rest",), "robot3": ("x",)}
    assert [task.id for task in read_tasks((yard / "tasks.yaml").read_text(), "t")] == ["rest", "x"]
    text = (yard / "tasks.yaml").read_text()
    assert text.startswith("# What there is to do.\ntasks:\n  - {id: rest, kind: wander, perpetual: true}\n")


def test_configs_that_list_tasks_follow(configure: Configure, yard: Path) -> None:
    without_events(yard)
    (yard / "tasks.yaml").write_text(TASKS.replace("    predecessors: [dig]\n", ""))
    configure(AddTask("dock", ("robot3",), "wander"))
    shared = yard / "config" / "tasks_params.yaml"
    assert yaml.safe_load(shared.read_text())["tasks"] == {
        "size": 3,
        "task0": {"id": "dig", "layer": "none"},
        "task1": {"id": "carry", "layer": "arm"},
        "task2": {"id": "dock", "layer": "none"},
    }
    configure(RemoveTask("dig"), RenameTask("carry", "haul"))
    assert yaml.safe_load(shared.read_text())["tasks"] == {
        "size": 2,
        "task0": {"id": "haul", "layer": "arm"},
        "task1": {"id": "dock", "layer": "none"},
    }


def test_everything_that_names_a_task_follows_its_new_id(configure: Configure, yard: Path, registry: Registry) -> None:
    configure()
    configure(RenameTask("dig", "dredge"), RenameTask("rest", "nap"))
    expected = APPLICATION.replace(">dig<", ">dredge<").replace(">rest<", ">nap<")
    assert (yard / "rqt_mrta.xml").read_text() == expected
    assert (yard / "tasks.yaml").read_text() == TASKS.replace("dig", "dredge").replace("rest", "nap")
    assert (yard / "scenario.yaml").read_text() == SCENARIO.replace("rest", "nap")
    assert gains(registry, "robot1") == {"dredge": 1.5, "carry": 1.0, "nap": 0.5}


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (AddTask("dig"), "--add-task: dig: is the id of a task already; give another"),
        (AddTask("a b"), "must be a name without spaces (got 'a b')"),
        (AddTask("dock"), "--add-task: dock: is of no kind; give --kind, such as go_to_place or wander"),
        (AddTask("dock", ("robot5",), "wander"), "--add-task: dock: 'robot5' is no robot; nearest is 'robot3'"),
        (RemoveTask("digg"), "--remove-task: digg: is no task; nearest is 'dig'"),
        (RemoveTask("dig"), "tasks.yaml:7: tasks[1]/predecessors: names 'dig', which is to be removed; "),
        (RemoveTask("rest"), "scenario.yaml:10: events[2]/task: names 'rest', which is to be removed; change this "),
        (RenameTask("digg", "x"), "--rename-task: digg: is no task; nearest is 'dig'"),
        (RenameTask("dig", "carry"), "--rename-task: carry: is the id of a task already; give another"),
    ],
)
def test_what_cannot_be_done_with_a_task_is_told(configure: Configure, yard: Path, edit: object, message: str) -> None:
    with pytest.raises(ConfigError) as caught:
        configure(edit)
    assert message in str(caught.value)
    assert ((yard / "rqt_mrta.xml").read_text(), (yard / "tasks.yaml").read_text()) == (APPLICATION, TASKS)


def test_a_robot_keeps_its_last_task(configure: Configure, yard: Path) -> None:
    (yard / "tasks.yaml").write_text(TASKS.replace("    predecessors: [dig]\n", ""))
    with pytest.raises(ConfigError, match="is the only task of robot3, which without a list would take every task"):
        configure(RemoveTask("dig"))


def test_without_a_tasks_file_tasks_are_what_robots_list(yard: Path) -> None:
    manifest = yard / "package.xml"
    manifest.write_text(manifest.read_text().replace('tasks="${prefix}/tasks.yaml" ', ""))
    registry = discover({"ROS_PACKAGE_PATH": str(yard.parent)})
    edits = (AddTask("dock", ("robot3",)), RenameTask("rest", "nap"))
    plan_configuration(registry, "yard", None, edits).carry_out()
    assert lists(registry) == {
        "robot1": ("dig", "carry", "nap"),
        "robot2": ("carry", "nap"),
        "robot3": ("dig", "dock"),
    }
    with pytest.raises(ConfigError, match=r"has no kind and no place but its id, for there is no tasks\.yaml"):
        plan_configuration(registry, "yard", None, [AddTask("deck", kind="wander")])


def test_a_robot_that_lists_no_tasks_takes_every_new_one(configure: Configure, yard: Path, registry: Registry) -> None:
    text = APPLICATION.replace(" <tasks> <task_0> <id>dig</id> </task_0> </tasks> </robot_2>", " </robot_2>")
    (yard / "rqt_mrta.xml").write_text(text)
    configure(AddTask("nap", ("robot3",), "wander"))
    assert lists(registry) == {"robot1": ("dig", "carry", "rest"), "robot2": ("carry", "rest"), "robot3": ()}
    assert list(gains(registry, "robot3")) == ["dig", "carry", "rest", "nap"]
    with pytest.raises(ConfigError, match="robot3 lists no tasks, so it takes every task; list its tasks in"):
        configure(AddTask("doze", ("robot1",), "wander"))


def test_files_under_other_architectures_follow(configure: Configure, yard: Path, registry: Registry) -> None:
    without_events(yard)
    (yard / "tasks.yaml").write_text(TASKS.replace("    predecessors: [dig]\n", ""))
    configure(SetValue("robot1/sets/set2/drive/gain", "7"), SetValue("robot2/rate", "9"), architecture="away")
    configure(
        RenameRobot("robot1", "digger"),
        RemoveTask("carry"),
        RenameTask("rest", "nap"),
        AddTask("dock", ("digger",), "wander"),
        AddRobot("robot4", ("nap",)),
    )
    assert gains(registry, "digger", "away") == {"dig": 1.0, "nap": 7.0, "dock": 1.0}
    parameters = load_mission(registry, "yard", "away").parameters
    assert (parameters["digger"]["name"], parameters["robot2"]["rate"]) == ("digger", 9.0)
    configure(RemoveRobot("robot2"))
    names = sorted(path.name for path in (yard / "config" / "away").iterdir())
    assert names == ["digger_params.yaml", "robot3_params.yaml", "robot4_params.yaml", "tasks_params.yaml"]
