"""Parameters from their nested form: the original's example, every problem by its path, defaults as in the template."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import Any, Dict, Tuple
from xml.etree import ElementTree

import pytest
import yaml
from mrta_alliance.parameters import (
    AllianceParameters,
    BehaviourSetParameters,
    SensorParameters,
)
from mrta_alliance.reading import find_problems, read_parameters

from rqt_mrta_py.config.parameters.context import ParameterContext
from rqt_mrta_py.config.parameters.resolving import resolve_parameters
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.hooks import ParameterRangeError
from tests.plugins.mrta_alliance.team import behaviour_set, nested

ORIGINAL = """
name: robot1
spin_rate: 5.0
broadcast_rate: 2
timeout_duration: 2.0
buffer_horizon: 10.0
sensors:
  size: 1
  sensor0: {plugin_name: my_pkg/bool_sensor, topic_name: ok, timeout_duration: 5.0, buffer_horizon: 5.0}
behaviour_sets:
  size: 1
  behaviour_set0:
    task_id: patrol
    task_expected_duration: 60.0
    motivational_behaviour:
      threshold: 30.0
      acquiescence: {yielding_delay: 20.0, giving_up_delay: 40.0}
      impatience: {fast_rate: 1.5}
      sensory_feedback: {plugin_name: my_pkg/evaluator, sensors: {size: 1, sensor0: {topic_name: ok}}}
"""


def test_reading_understands_a_file_of_the_original_nodes() -> None:
    assert read_parameters(yaml.safe_load(ORIGINAL), ["patrol"]) == AllianceParameters(
        behaviour_sets=(
            BehaviourSetParameters(
                "patrol", 60.0, 30.0, 20.0, 40.0, 1.5, 0.0, 0.0, evaluator="my_pkg/evaluator", sensors=("ok",)
            ),
        ),
        spin_rate=5.0,
        broadcast_rate=2.0,
        timeout_duration=2.0,
        buffer_horizon=10.0,
        sensors=(SensorParameters("ok", 5.0, 5.0, "my_pkg/bool_sensor"),),
    )


def test_reading_takes_defaults_for_what_is_missing() -> None:
    told = read_parameters({"behaviour_sets": {"behaviour_set0": {"task_id": "patrol"}}}, ["patrol"])
    assert told == AllianceParameters((BehaviourSetParameters("patrol"),))


def put(path: str, value: Any) -> Dict[str, Any]:
    """Give sound parameters with one value replaced."""
    told = yaml.safe_load(ORIGINAL)
    inner = told
    *way, last = path.split("/")
    for name in way:
        inner = inner[name]
    inner[last] = value
    return told


SET = "behaviour_sets/behaviour_set0"
INNER = f"{SET}/motivational_behaviour"


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        ("spin_rate", 0.0, "must be above 0 Hz (got 0)"),
        ("broadcast_rate", -2.0, "must be above 0 Hz (got -2)"),
        ("timeout_duration", 0.0, "must be above 0 s (got 0)"),
        ("timeout_duration", float("nan"), "must be above 0 s (got nan)"),
        ("timeout_duration", "2.0", "must be a number (got '2.0')"),
        (
            "timeout_duration",
            0.5,
            "must be above the period of announcements, 0.5 s (got 0.5), or robots at work would count as stopped",
        ),
        ("buffer_horizon", 1.5, "must be at least timeout_duration = 2 s (got 1.5)"),
        ("sensors/size", -1, "must be a whole number, at least 0 (got -1)"),
        ("sensors/sensor0/topic_name", "", "must name a topic (got nothing)"),
        ("sensors/sensor0/timeout_duration", 0, "must be above 0 s (got 0)"),
        ("sensors/sensor0/buffer_horizon", -1.0, "must be above 0 s (got -1)"),
        ("sensors/sensor0/plugin_name", "", "must name a sensor (got nothing)"),
        ("strict_original", "yes", "must be true or false (got 'yes')"),
        ("low_level_feedback", 1, "must be true or false (got 1)"),
        ("behaviour_sets/size", True, "must be a whole number, at least 0 (got True)"),
        ("behaviour_sets", 5, "must be a group of parameters (got 5)"),
        (INNER, "calm", "must be a group of parameters (got 'calm')"),
        (f"{INNER}/impatience", [1.5], "must be a group of parameters (got [1.5])"),
        (f"{INNER}/sensory_feedback/sensors", 1, "must be a group of parameters (got 1)"),
        (f"{SET}/task_id", "cook", "must be a task of this robot (got 'cook'); there are: patrol, border-patrol"),
        (f"{SET}/task_id", "border-patrol", "must be fit for a topic (got 'border-patrol'); letters, digits and _ are"),
        (f"{SET}/task_expected_duration", 0.0, "must be above 0 s (got 0)"),
        (
            f"{SET}/task_expected_duration",
            20.0,
            "must be above threshold / fast_rate = 20 s (got 20), or announcing the task would slow nobody down",
        ),
        (f"{INNER}/threshold", 0.0, "must be above 0 (got 0)"),
        (f"{INNER}/acquiescence/yielding_delay", -1.0, "must be at least 0 s (got -1)"),
        (f"{INNER}/acquiescence/giving_up_delay", 0.0, "must be above 0 s (got 0)"),
        (f"{INNER}/impatience/fast_rate", 0.0, "must be above 0 (got 0)"),
        (f"{INNER}/impatience/head_start", -0.1, "must be at least 0 (got -0.1)"),
        (f"{INNER}/impatience/fairness", -0.1, "must be at least 0 (got -0.1)"),
        (f"{INNER}/sensory_feedback/plugin_name", "", "must name a sensory evaluator (got nothing)"),
        (f"{INNER}/sensory_feedback/plugin_name", 7, "must be a text (got 7)"),
        (
            f"{INNER}/sensory_feedback/sensors/sensor0/topic_name",
            "scan",
            "must be the topic of one of the robot's own sensors (got 'scan'); there are: ok",
        ),
    ],
)
def test_reading_finds_what_is_wrong_with_one_value(path: str, value: Any, message: str) -> None:
    told = put(path, value)
    problems = find_problems(told, ["patrol", "border-patrol"])
    assert (path, message) in problems
    if not path.startswith("sensors"):  # a set that names a broken sensor cannot be sound either
        assert len(problems) == 1
    with pytest.raises(ParameterRangeError) as caught:
        read_parameters(told, ["patrol", "border-patrol"])
    assert caught.value.problems == tuple(problems)


def test_reading_finds_everything_at_once() -> None:
    told = nested(behaviour_set("patrol", 0.0), behaviour_set("patrol"), behaviour_set("patrol"), spin_rate=-1.0)
    told["behaviour_sets"]["size"] = 4
    assert [problem.path for problem in find_problems(told, ["patrol"])] == [
        "behaviour_sets/behaviour_set0/motivational_behaviour/impatience/fast_rate",
        "behaviour_sets/behaviour_set2/task_id",
        "behaviour_sets/behaviour_set3",
        "spin_rate",
    ]


def test_reading_refuses_two_sets_for_one_task() -> None:
    told = nested(behaviour_set("patrol"), behaviour_set("patrol"))
    assert find_problems(told, ["patrol"]) == [
        ("behaviour_sets/behaviour_set1/task_id", "must differ from the other behaviour sets' (got 'patrol' again)")
    ]


def test_parameters_refuse_themselves_with_every_problem() -> None:
    with pytest.raises(ParameterRangeError) as caught:
        BehaviourSetParameters("", threshold=0.0)
    assert str(caught.value) == (
        "task_id: must name a task (got nothing); motivational_behaviour/threshold: must be above 0 (got 0)"
    )


def template_defaults(root: Path) -> Dict[str, str]:
    """Read every default of the template by its path, numbered elements left out."""
    tree = ElementTree.parse(root / "plugins/architectures/mrta_alliance/rqt_mrta.xml")
    config = tree.find("configs/config_0")
    found: Dict[str, str] = {}

    def walk(element: ElementTree.Element, path: str) -> None:
        for child in element:
            kind = child.tag.rstrip("0123456789")
            name = f"{path}{child.findtext('name')}"
            if kind == "param_":
                found[name] = child.findtext("default") or ""
            elif kind in ("params_", "array_"):
                walk(child, f"{name}/")

    assert config is not None
    walk(config, "")
    return found


def test_template_has_a_default_for_every_parameter(root: Path) -> None:
    assert [path for path, default in template_defaults(root).items() if not default] == []


def test_template_and_dataclasses_agree_on_defaults(root: Path) -> None:
    """Save for head_start: files of the original nodes lack it and mean none."""
    defaults = template_defaults(root)
    inner = "behaviour_sets/behaviour_set@index@/motivational_behaviour"
    paths = {
        "spin_rate": "spin_rate",
        "broadcast_rate": "broadcast_rate",
        "timeout_duration": "timeout_duration",
        "buffer_horizon": "buffer_horizon",
        "task_expected_duration": "behaviour_sets/behaviour_set@index@/task_expected_duration",
        "threshold": f"{inner}/threshold",
        "yielding_delay": f"{inner}/acquiescence/yielding_delay",
        "giving_up_delay": f"{inner}/acquiescence/giving_up_delay",
        "fast_rate": f"{inner}/impatience/fast_rate",
        "fairness": f"{inner}/impatience/fairness",
    }
    coded = {
        field.name: field.default for made in (AllianceParameters, BehaviourSetParameters) for field in fields(made)
    }
    assert {name: float(defaults[path]) for name, path in paths.items()} == {name: coded[name] for name in paths}
    assert defaults[f"{inner}/sensory_feedback/plugin_name"] == coded["evaluator"]
    sensor = {field.name: field.default for field in fields(SensorParameters)}
    for name in ("timeout_duration", "buffer_horizon"):
        assert float(defaults[f"sensors/sensor@index@/{name}"]) == sensor[name]
    assert defaults["sensors/sensor@index@/plugin_name"] == sensor["plugin_name"]
    switches = ("strict_original", "low_level_feedback")
    assert {name: defaults[name] for name in switches} == dict.fromkeys(switches, "false")
    assert {coded[name] for name in switches} == {False}
    assert (coded["head_start"], defaults[f"{inner}/impatience/head_start"]) == (0.0, "0.5")


@pytest.mark.parametrize("tasks", [("patrol",), ("patrol", "inspect", "report", "cook")])
def test_template_alone_suits_any_robot(root: Path, tasks: Tuple[str, ...]) -> None:
    path = root / "plugins/architectures/mrta_alliance/rqt_mrta.xml"
    architecture = read_architecture(path.read_bytes(), str(path), "mrta_alliance")
    (template,) = [config for config in architecture.configs if config.id == architecture.robot_config_id]
    context = ParameterContext("robot1", tasks, False, "app", str(path), str(path))
    values = resolve_parameters(template, (), context).values
    assert values["name"] == "robot1"
    told = read_parameters(values, tasks)
    assert [each.task_id for each in told.behaviour_sets] == list(tasks)
    assert {each.head_start for each in told.behaviour_sets} == {0.5}
    assert told.sensors == ()
