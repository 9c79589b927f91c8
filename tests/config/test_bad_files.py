"""Files that are wrong in one way each, and what is said of them."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict, Tuple

import pytest

from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError

READERS: Dict[str, Callable[[bytes, str], object]] = {
    "application": lambda text, path: read_application(text, path, "pkg"),
    "tasks": read_tasks,
    "scenario": read_scenario,
}


def read_bad(path: Path) -> object:
    reader = READERS.get(path.name.split("_")[0], lambda text, name: read_architecture(text, name, "pkg"))
    return reader(path.read_bytes(), path.name)


SAID: Dict[str, Tuple[str, ...]] = {
    "application_empty.xml": ("1: application: is missing or empty; it names the application and its robots",),
    "application_misspelt_robots.xml": ("3: application/robts: is not expected here; nearest is 'robots'",),
    "application_robot_twice.xml": (
        "5: application/robots/robot_1/id: 'robot1' names two robots; the first one is in line 4",
    ),
    "application_says_architecture.xml": (
        "1: @format: says 'architecture', but the file is read as 'application'; say 'application'",
    ),
    "application_task_twice.xml": (
        "6: application/robots/robot_0/tasks/task_1/id: 't' stands twice; name each task once",
    ),
    "architecture_cut_off.xml": ("4: is not well-formed XML: Premature end of data in tag architecture line 2",),
    "architecture_entity_bomb.xml": ("3: declares the entity 'a'; entities are not accepted",),
    "architecture_external_entity.xml": ("2: declares the entity 'secret'; entities are not accepted",),
    "architecture_is_an_application.xml": (
        "1: @format: says 'application', but the file is read as 'architecture'; say 'architecture'",
        "1: architecture: is missing or empty; it names the architecture and its topics",
        "2: application: belongs to an application, but the file is read as an architecture",
    ),
    "architecture_name_twice.xml": ("4: architecture/name: stands twice; the first one is in line 3",),
    "architecture_other_root.xml": ("1: launch: is not the root of such a file; accepted: rqt_mrta",),
    "architecture_stray_text.xml": ("2: architecture: holds the text 'ST'; only elements are expected here",),
    "architecture_unknown_attribute.xml": ("1: @formt: is not expected here; nearest is 'format'",),
    "architecture_unknown_config_id.xml": (
        "5: architecture/robots/config_id: 'params' is no id of this file; nearest is 'a_params'",
        "6: architecture/robots/launch_id: 'nothing' is no id of this file; there is none",
    ),
    "architecture_unknown_element.xml": (
        "4: architecture/robots/busy_robot: is not expected here; nearest is 'busy_robots'",
    ),
    "architecture_without_name.xml": ("2: architecture/name: is missing or empty; give a text",),
    "array_outside_params.xml": (
        "5: configs/config_0/array_0: is an array outside a params; put it into a params_<number>",
    ),
    "array_without_size.xml": (
        "5: configs/config_0/params_0: holds the array 'sensor@index@', but no param named 'size'; add one of type int",
    ),
    "config_id_twice.xml": ("5: configs/config_1/id: 'p' names two configs; the first one is in line 4",),
    "config_id_with_space.xml": ("4: configs/config_0/id: must not contain a space (got 'my params')",),
    "config_unnumbered.xml": ("4: configs/config: bears no number; call it config_0, the next one config_1 and so on",),
    "param_misspelt.xml": ("5: configs/config_0/parm_0: is not expected here; nearest is 'param_<number>'",),
    "param_name_twice.xml": ("6: configs/config_0/param_1/name: 'a' stands twice here; the first one is in line 5",),
    "param_number_twice.xml": ("6: configs/config_0/params_0: number 0 is taken by param_0 in line 5; count on",),
    "param_wrong_default.xml": (
        "5: configs/config_0/param_0/default: must be a whole number (got '3.5')",
        "6: configs/config_0/param_1/default: must be a finite number (got 'nan')",
        "7: configs/config_0/param_2/default: must be true or false (got 'yes')",
    ),
    "scenario_arena_inside_out.yaml": ("1: arena/max_x: must be above min_x, which is 0 m (got -4)",),
    "scenario_event_misspelt.yaml": (
        "5: events[0]/kind: must be one of robot_stops, robot_returns, robot_removed, robot_sticks, robot_comes_free, "
        "robot_slows, robot_clock_shifts, radio_fails, radio_returns, radio_partitions, radio_heals, radio_changes, "
        "task_appears, task_withdrawn, task_reassigned (got 'robot_stop')",
        "5: events[0]/time: must be a number from 0 s (got -1)",
        "6: events[1]/robot: is missing; give a text",
    ),
    "scenario_no_ros_name.yaml": (
        "4: robots[1]/id: must be a name that ROS accepts: letters, digits and _ (got 'second-one')",
        "4: robots[1]/sensors[0]/topic: must be a name that ROS accepts (got '1st scan'), such as scan",
    ),
    "scenario_obstacle_sizes.yaml": (
        "5: obstacles[0]/size: must be a list of 3 numbers [m] (got [1, 2])",
        "6: obstacles[1]/size: must be above 0 m in each direction (got [1.0, 0.0, 1.0])",
        "7: obstacles[2]/size: of a cylinder begins with its diameter twice (got [1.0, 2.0, 1.0])",
        "8: obstacles[3]/shape: must be one of box, cylinder (got 'ball')",
    ),
    "scenario_out_of_range.yaml": (
        "4: duration: must be a number above 0 s (got 0)",
        "5: control_rate: must be a whole number from 1 to 1000 Hz (got 20.5)",
        "6: picture_period: must be a number from 0 s (got -1)",
        "7: robot_defaults/sensors[0]/rate: must be a number above 0 Hz (got 0)",
    ),
    "scenario_robot_twice.yaml": ("4: robots[1]/id: 'robot1' names two robots; the first one is in line 3",),
    "scenario_unknown_robot.yaml": ("5: events[0]/robot: 'robot2' is no robot of the scenario; nearest is 'robot1'",),
    "scenario_without_robots.yaml": (
        "1: robots: is missing; give a list of mappings (id, start, model, sensors, capabilities, map)",
    ),
    "tasks_alias_bomb.yaml": ("5: holds more than 100000 values",),
    "tasks_alias_of_itself.yaml": ("2: refers to 't', which is not complete here",),
    "tasks_cut_off.yaml": ("3: is not YAML: expected ',' or '}', but got '<stream end>'",),
    "tasks_empty.yaml": ("1: is empty; accepted: tasks",),
    "tasks_id_twice.yaml": ("3: tasks[1]/id: 'a' names two tasks; the first one is in line 2",),
    "tasks_in_a_circle.yaml": (
        "2: tasks[0]/predecessors: go round in a circle: a after b after c after a; take one of them out",
    ),
    "tasks_key_twice.yaml": ("4: id: stands twice; the first one is in line 2",),
    "tasks_not_a_list.yaml": (
        "1: tasks: must be a list of mappings (id, kind, layers, place, capabilities, predecessors, resources, "
        "robots, expected_duration, perpetual, data) (got {'a': 1})",
    ),
    "tasks_not_finite.yaml": (
        "4: holds .inf; numbers must be finite",
        "4: holds .nan; numbers must be finite",
    ),
    "tasks_number_key.yaml": ("2: has the key 1; keys are texts: put it in quotes",),
    "tasks_out_of_range.yaml": (
        "4: tasks[0]/robots: must be a whole number from 1 (got 0)",
        "5: tasks[0]/expected_duration: must be a number above 0 s (got 0)",
    ),
    "tasks_tag.yaml": ("1: carries the tag 'tag:yaml.org,2002:python/object/apply:os.system'; tags are not accepted",),
    "tasks_two_documents.yaml": ("2: begins a second document; one is expected",),
    "tasks_unknown_key.yaml": (
        "2: tasks[0]/duration: is not known; nearest is 'expected_duration'",
        "3: tasks[1]/kind: is missing; give a text",
        "3: tasks[1]/knd: is not known; nearest is 'kind'",
    ),
    "tasks_unknown_predecessor.yaml": (
        "2: tasks[0]/predecessors: names 'mark_out', which is no task here; nearest is 'markout'",
    ),
    "tasks_wrong_types.yaml": (
        "2: tasks[0]/id: must be a text (got 7); put it in quotes",
        "4: tasks[0]/robots: must be a whole number from 1 (got 1.5)",
        "5: tasks[0]/expected_duration: must be a number above 0 s (got '1e3'); YAML takes this for a text: "
        "no quotes, and a dot before an exponent, such as 1.0e-3",
        "6: tasks[0]/perpetual: must be true or false (got 'maybe')",
        "7: tasks[0]/capabilities: must be a list of texts (got 'lift')",
        "8: tasks[0]/place: must be a mapping (got [1, 2]); accepted: x, y, yaw",
    ),
    "topic_negative_timeout.xml": (
        "6: architecture/robots/busy_robots/topic/queue_size: must be a whole number from 0 (got 'many')",
        "6: architecture/robots/busy_robots/topic/timeout: must be above 0 s (got '-1'); give a positive number",
    ),
    "topic_relative.xml": (
        "4: architecture/robots/busy_robots/topic/name: must be an absolute topic (got 'busy'); begin with "
        "/, then letters, digits, _ and /, or @robot_id@ and @task_id@ for the name of a robot or task",
    ),
    "topic_without_type_and_field.xml": (
        "4: architecture/robots/busy_robots/topic/field: is missing; give the field with the id, or "
        "@robot_id@ or @task_id@ in the name",
        "4: architecture/robots/busy_robots/topic/type: is missing or empty; give a text",
    ),
    "topic_wrong_type_and_field.xml": (
        "4: architecture/robots/busy_robots/topic/field: must be a path of fields joined by / (got "
        "'data.id'), such as header/frame_id",
        "4: architecture/robots/busy_robots/topic/type: must be a message type (got 'String'), such as std_msgs/String",
    ),
}


def test_bad_files_are_all_in_the_table(data: Path) -> None:
    found = {path.name for path in (data / "bad").iterdir()}

    assert found == set(SAID)


@pytest.mark.parametrize("name", sorted(SAID))
def test_bad_file_is_refused_with_everything_that_is_wrong(data: Path, name: str) -> None:
    with pytest.raises(ConfigError) as caught:
        read_bad(data / "bad" / name)

    assert [str(problem) for problem in caught.value.problems] == [f"{name}:{said}" for said in SAID[name]]
