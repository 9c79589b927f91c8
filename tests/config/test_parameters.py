"""Parameters: templates, substitutions, layers."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.config.parameters.context import ParameterContext
from rqt_mrta_py.config.parameters.layers import Layer, split_overrides, xml_layer, yaml_layer
from rqt_mrta_py.config.parameters.parameter_file import dump_parameters, parse_parameters
from rqt_mrta_py.config.parameters.resolving import ResolvedParameters, locate_problems, resolve_parameters
from rqt_mrta_py.config.parameters.values import check_value, parse_text
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ConfigTemplate, ParameterType

SENSORS = """
<param_0><name>name</name><type>string</type><default>@robot_id@</default></param_0>
<param_1><name>rate</name><type>double</type><default>2</default></param_1>
<params_2><name>sensors</name>
  <param_0><name>size</name><type>int</type><value>@array_size@</value></param_0>
  <array_1><name>sensor@index@</name>
    <param_0><name>topic</name><type>string</type><default>scan@index@</default></param_0>
    <param_1><name>up</name><type>bool</type><default>True</default></param_1>
  </array_1>
</params_2>
<params_3><name>sets</name>
  <array_0><name>set@index@</name>
    <param_0><name>task_id</name><type>string</type><value>@task_id@</value></param_0>
    <param_1><name>impatience/fast_rate</name><type>double</type><default>1.0</default></param_1>
    <params_2><name>impatience</name><param_0><name>slow</name><type>int</type><default>0</default></param_0></params_2>
  </array_0>
  <param_1><name>size</name><type>int</type><value>@array_size@</value><default>7</default></param_1>
</params_3>
"""


def template_of(params: str) -> ConfigTemplate:
    text = (
        f"<rqt_mrta><architecture><name>A</name></architecture><configs><config_0><id>p</id>{params}"
        "</config_0></configs></rqt_mrta>"
    )
    return read_architecture(text, "a.xml", "a").configs[0]


def context(tasks: Sequence[str] = ("dig", "fill"), all_tasks: bool = True) -> ParameterContext:
    return ParameterContext("robot1", tuple(tasks), all_tasks, "yard", "a.xml", "app.xml")


def resolve(
    params: str = SENSORS, *layers: Layer, tasks: Sequence[str] = ("dig", "fill"), all_tasks: bool = True
) -> ResolvedParameters:
    return resolve_parameters(template_of(params), layers, context(tasks, all_tasks))


def complaints(params: str, *layers: Layer, **rest: Any) -> List[str]:
    with pytest.raises(ConfigError) as caught:
        resolve(params, *layers, **rest)
    return [str(problem) for problem in caught.value.problems]


def test_parameters_without_any_layer_are_the_templates_defaults_in_its_order() -> None:
    values = resolve().values

    assert values == {
        "name": "robot1",
        "rate": 2.0,
        "sensors": {"size": 0},
        "sets": {
            "set0": {"task_id": "dig", "impatience": {"fast_rate": 1.0, "slow": 0}},
            "set1": {"task_id": "fill", "impatience": {"fast_rate": 1.0, "slow": 0}},
            "size": 2,
        },
    }
    assert isinstance(values["rate"], float)
    assert list(values) == ["name", "rate", "sensors", "sets"]
    assert list(values["sets"]) == ["set0", "set1", "size"]


def test_parameters_of_later_layers_cover_earlier_ones() -> None:
    xml = xml_layer(template_of("<param_0><name>rate</name><type>double</type><value>3</value></param_0>").items, "x")
    first, second = yaml_layer("rate: 4", "first.yaml"), yaml_layer("{rate: 5.5}", "second.yaml")

    assert resolve(SENSORS, xml).values["rate"] == 3.0
    assert resolve(SENSORS, xml, first).values["rate"] == 4.0
    assert resolve(SENSORS, xml, second, first).values["rate"] == 4.0
    found = resolve(SENSORS, xml, first, second, split_overrides(["robot1/rate=6"], ["robot1"])[0]["robot1"])
    assert found.values["rate"] == 6.0
    assert found.sources["rate"] == ("--set", 0)
    assert resolve(SENSORS, first).sources["rate"] == ("first.yaml", 1)
    assert resolve(SENSORS).sources["rate"] == ("a.xml", 3)


def test_parameters_for_all_elements_cover_earlier_ones_for_one_of_them() -> None:
    """A value from the command line for all elements once lost to a file's value for one of them."""
    file = yaml_layer("sets: {set0: {impatience: {fast_rate: 9}}}", "p.yaml")
    layers, problems = split_overrides(["robot1/sets/set@index@/impatience/fast_rate=2.5"], ["robot1"])
    assert problems == ()

    for layers_in_order, rates in (((file, layers["robot1"]), [2.5, 2.5]), ((layers["robot1"], file), [9.0, 2.5])):
        sets = resolve(SENSORS, *layers_in_order).values["sets"]
        assert [sets[f"set{index}"]["impatience"]["fast_rate"] for index in range(2)] == rates


def test_parameters_of_an_array_that_names_no_task_come_in_the_number_that_the_application_gives() -> None:
    values = resolve(SENSORS, yaml_layer("sensors: {sensor1: {topic: sonar}}", "p.yaml")).values

    assert values["sensors"] == {
        "size": 2,
        "sensor0": {"topic": "scan0", "up": True},
        "sensor1": {"topic": "sonar", "up": True},
    }


def test_parameters_of_an_array_take_the_size_given_before_the_elements_given() -> None:
    values = resolve(SENSORS, yaml_layer("sensors: {size: 1}", "p.yaml")).values

    assert values["sensors"] == {"size": 1, "sensor0": {"topic": "scan0", "up": True}}


@pytest.mark.parametrize(("default", "size"), [("", 0), ("<default>2</default>", 2)])
def test_parameters_of_an_array_without_elements_take_the_size_of_the_default(default: str, size: int) -> None:
    params = (
        "<params_0><name>s</name><param_0><name>size</name><type>int</type><value>@array_size@</value>"
        f"{default}</param_0><array_1><name>e@index@</name><param_0><name>i</name><type>int</type>"
        "<default>@index@</default></param_0></array_1></params_0>"
    )

    assert resolve(params).values["s"] == {"size": size, **{f"e{index}": {"i": index} for index in range(size)}}


def test_parameters_give_every_task_an_element_around_those_that_name_their_own() -> None:
    layer = yaml_layer("sets: {set1: {task_id: dig, impatience: {fast_rate: 9}}}", "p.yaml")

    sets = resolve(SENSORS, layer, tasks=("dig", "fill", "rest")).values["sets"]

    assert [sets[f"set{index}"]["task_id"] for index in range(sets["size"])] == ["fill", "dig", "rest"]
    assert [sets[f"set{index}"]["impatience"]["fast_rate"] for index in range(3)] == [1.0, 9.0, 1.0]


def test_parameters_may_leave_tasks_out_where_the_application_names_none() -> None:
    """A file of the original for two of three tasks, under an application that gives no robot tasks of its own."""
    layer = yaml_layer("sets: {size: 1, set0: {task_id: fill}}", "p.yaml")

    assert list(resolve(SENSORS, layer, all_tasks=False).values["sets"]) == ["set0", "size"]
    assert complaints(SENSORS, layer) == ["p.yaml:1: robot1/sets/size: is 1, which leaves no element for dig; give 2"]


def test_parameters_of_an_element_beyond_the_size_claim_no_task() -> None:
    assert complaints(SENSORS, yaml_layer("sets: {size: 2, set5: {task_id: dig}}", "p.yaml")) == [
        "p.yaml:1: robot1/sets/set5/task_id: is of element 5, but size is 2; elements count from 0"
    ]


def test_parameters_name_the_element_for_which_no_task_is_left() -> None:
    assert complaints(SENSORS, yaml_layer("sets: {size: 3}", "p.yaml")) == [
        "a.xml:13: robot1/sets/set2/task_id: stands for a task (@task_id@), but no task is left for it; "
        "the robot's tasks: dig, fill"
    ]


def test_parameters_of_an_array_in_an_application_hold_for_all_elements_and_one_for_itself() -> None:
    text = """<rqt_mrta><application><name>B</name></application><configs><config_0><id>p</id>
    <params_0><name>sets</name><array_0><name>set@index@</name>
    <param_0><name>impatience/fast_rate</name><type>double</type><value>4</value></param_0></array_0>
    <params_1><name>set1</name><param_0><name>impatience/fast_rate</name><type>double</type><value>5</value></param_0>
    </params_1><param_2><name>size</name><type>int</type><value>@array_size@</value></param_2></params_0>
    </config_0></configs></rqt_mrta>"""
    layer = xml_layer(read_application(text, "b.xml", "b").configs[0].items, "b.xml")

    sets = resolve(SENSORS, layer).values["sets"]

    assert [sets[f"set{index}"]["impatience"]["fast_rate"] for index in range(2)] == [4.0, 5.0]


def test_parameters_complain_of_everything_with_file_and_line() -> None:
    layer = yaml_layer(
        "rat: 3\nrate: fast\nname: 7\nsensors:\n  size: 1\n  sensor0: {up: 1}\n  sensor4: {up: true}\nsets: 5\n"
        "extra: {a: {b: 1}}\nsets/set0: {impatiense: {slow: 1}}\nname/first: x\n",
        "p.yaml",
    )

    assert complaints(SENSORS, layer) == [
        "p.yaml:1: robot1/rat: is not known; nearest is 'rate'",
        "p.yaml:2: robot1/rate: must be a finite number (got 'fast')",
        "p.yaml:3: robot1/name: must be a text (got 7); put it in quotes",
        "p.yaml:6: robot1/sensors/sensor0/up: must be true or false (got 1)",
        "p.yaml:7: robot1/sensors/sensor4/up: is of element 4, but size is 1; elements count from 0",
        "p.yaml:8: robot1/sets: is a group of parameters, not a value; give the parameters in it",
        "p.yaml:9: robot1/extra/a/b: is not known; accepted: name, rate, sensors, sets",
        "p.yaml:10: robot1/sets/set0/impatiense/slow: is not known; nearest is 'impatience'",
        "p.yaml:11: robot1/name/first: is not known; name is a value, not a group",
    ]


@pytest.mark.parametrize(
    ("size", "said"),
    [
        ("-1", "must be a whole number from 0 to 1000 (got -1)"),
        ("1001", "must be a whole number from 0 to 1000 (got 1001)"),
        ("2.0", "must be a whole number (got 2.0)"),
        ("many", "must be a whole number (got 'many')"),
    ],
)
def test_parameters_refuse_a_size_that_is_none(size: str, said: str) -> None:
    assert complaints(SENSORS, yaml_layer(f"sensors: {{size: {size}}}", "p.yaml")) == [
        f"p.yaml:1: robot1/sensors/size: {said}"
    ]


def test_parameters_that_are_mandatory_must_be_given_somewhere() -> None:
    params = "<param_0><name>rate</name><type>double</type></param_0>"

    assert complaints(params) == ["app.xml: robot1/rate: is mandatory and has no value; give a finite number"]
    assert resolve(params, yaml_layer("rate: 1", "p.yaml")).values == {"rate": 1.0}
    assert complaints(params, yaml_layer("rate:", "p.yaml")) == complaints(params)


def test_parameters_of_appendix_a_fill_in_to_the_form_that_alliance_nodes_read(data: Path) -> None:
    spec = read_architecture((data / "appendix_a_architecture.xml").read_bytes(), "a.xml", "alliance")
    text = """
spin_rate: 5.0
broadcast_rate: 2.0
timeout_duration: 2.0
buffer_horizon: 10.0
sensors: {size: 1, sensor0: {plugin_name: my_pkg/bool_sensor, topic_name: ok}}
behaviour_sets:
  behaviour_set0:
    task_expected_duration: 60.0
    motivational_behaviour:
      threshold: 30.0
      acquiescence: {yielding_delay: 20.0, giving_up_delay: 40.0}
      impatience: {fast_rate: 1.5}
      sensory_feedback: {plugin_name: my_pkg/evaluator, sensors: {size: 1, sensor0: {topic_name: ok}}}
"""

    found = resolve_parameters(spec.configs[0], [yaml_layer(text, "p.yaml")], context(["patrol"]))

    expected: Dict[str, Any] = {
        "name": "robot1",
        "spin_rate": 5.0,
        "broadcast_rate": 2.0,
        "timeout_duration": 2.0,
        "buffer_horizon": 10.0,
        "sensors": {
            "size": 1,
            "sensor0": {
                "plugin_name": "my_pkg/bool_sensor",
                "topic_name": "ok",
                "timeout_duration": 5.0,
                "buffer_horizon": 5.0,
            },
        },
        "behaviour_sets": {
            "size": 1,
            "behaviour_set0": {
                "task_id": "patrol",
                "task_expected_duration": 60.0,
                "motivational_behaviour": {
                    "threshold": 30.0,
                    "acquiescence": {"yielding_delay": 20.0, "giving_up_delay": 40.0},
                    "impatience": {"fast_rate": 1.5},
                    "sensory_feedback": {
                        "plugin_name": "my_pkg/evaluator",
                        "sensors": {"size": 1, "sensor0": {"topic_name": "ok"}},
                    },
                },
            },
        },
    }
    assert found.values == expected
    assert yaml.safe_load(dump_parameters(found.values)) == expected


def test_parameters_of_nested_arrays_count_each_for_itself(data: Path) -> None:
    spec = read_architecture((data / "final_architecture.xml").read_bytes(), "a.xml", "alliance")
    text = """
tasks:
  task0: {id: a, name: A, layers: {layer0: {plugin_name: x}, layer1: {plugin_name: y}}}
  task1: {id: b, name: B}
"""

    tasks = resolve_parameters(spec.configs[0], [yaml_layer(text, "p.yaml")], context()).values["tasks"]

    assert tasks["size"] == 2
    assert tasks["task0"]["layers"] == {"size": 2, "layer0": {"plugin_name": "x"}, "layer1": {"plugin_name": "y"}}
    assert tasks["task1"]["layers"] == {"size": 0}


def nested(levels: int, inside: str) -> str:
    for level in range(levels):
        inside = (
            f"<params_0><name>g{level}</name><param_0><name>size</name><type>int</type><default>1000</default></param_0>"
            f"<array_1><name>e@index@</name>{inside}</array_1></params_0>"
        )
    return inside


def test_parameters_of_arrays_in_arrays_stop_before_they_fill_the_memory() -> None:
    said = complaints(nested(4, "<param_0><name>i</name><default>x</default></param_0>"))

    assert "app.xml: robot1/g3: make more than 10000 parameters; give smaller sizes" in said


def test_parameters_named_by_the_index_of_their_element_are_told_apart() -> None:
    params = (
        "<params_0><name>s</name><param_0><name>size</name><type>int</type><default>2</default></param_0>"
        "<array_1><name>e@index@</name><param_0><name>p@index@</name><default>@index@</default></param_0></array_1>"
        "</params_0>"
    )

    assert resolve(params).values["s"] == {"size": 2, "e0": {"p0": "0"}, "e1": {"p1": "1"}}


def test_parameters_mention_the_task_of_the_outer_element_in_inner_arrays() -> None:
    params = """<params_0><name>t</name><param_0><name>size</name><type>int</type><value>@array_size@</value></param_0>
    <array_1><name>t@index@</name><param_0><name>id</name><value>@task_id@</value></param_0>
    <params_1><name>s</name><param_0><name>size</name><type>int</type><value>@array_size@</value><default>1</default></param_0>
    <array_1><name>s@index@</name><param_0><name>of</name><value>@task_id@@index@</value></param_0></array_1></params_1>
    </array_1></params_0>"""

    assert resolve(params).values["t"] == {
        "size": 2,
        "t0": {"id": "dig", "s": {"size": 1, "s0": {"of": "dig0"}}},
        "t1": {"id": "fill", "s": {"size": 1, "s0": {"of": "fill0"}}},
    }


def test_parameters_of_an_array_need_a_size_that_somebody_says() -> None:
    array = "<array_1><name>e@index@</name><param_0><name>i</name><default>x</default></param_0></array_1>"
    params = f"<params_0><name>s</name><param_0><name>size</name><type>int</type></param_0>{array}</params_0>"

    assert complaints(params) == ["app.xml: robot1/s/size: is mandatory and has no value; give a whole number"]
    assert resolve(params, yaml_layer("s: {size: 1}", "p.yaml")).values == {"s": {"size": 1, "e0": {"i": "x"}}}


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("True", ParameterType.BOOL, True),
        ("false", ParameterType.BOOL, False),
        ("-3", ParameterType.INT, -3),
        ("0", ParameterType.DOUBLE, 0.0),
        ("1e-3", ParameterType.DOUBLE, 0.001),
        ("1e-3", ParameterType.STRING, "1e-3"),
    ],
)
def test_text_of_a_value_is_read_in_the_type_of_its_template(text: str, kind: ParameterType, value: object) -> None:
    found = parse_text(text, kind)

    assert (found, type(found)) == (value, type(value))


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("1", ParameterType.BOOL),
        ("3.0", ParameterType.INT),
        ("1_0", ParameterType.INT),
        ("9" * 5000, ParameterType.INT),
        ("fast", ParameterType.DOUBLE),
        ("inf", ParameterType.DOUBLE),
        ("1_0", ParameterType.DOUBLE),
    ],
)
def test_text_that_is_no_value_of_its_type_is_refused(text: str, kind: ParameterType) -> None:
    with pytest.raises(ValueError, match=r"must be .* \(got "):
        parse_text(text, kind)


@pytest.mark.parametrize(
    ("value", "kind"),
    [(1, ParameterType.BOOL), (True, ParameterType.INT), (True, ParameterType.DOUBLE), (10**400, ParameterType.DOUBLE)],
)
def test_value_of_yaml_is_not_converted_to_another_type(value: object, kind: ParameterType) -> None:
    with pytest.raises(ValueError, match=r"must be .* \(got "):
        check_value(value, kind)


def test_parameter_file_must_be_a_mapping_or_empty() -> None:
    assert yaml_layer("# nothing yet\n", "p.yaml") == {}
    with pytest.raises(ConfigError, match=r"p\.yaml:1: must be a mapping \(got \[1\]\)"):
        yaml_layer("[1]", "p.yaml")


def test_located_problems_name_file_and_line_of_the_parameter_or_its_group() -> None:
    resolved = resolve(SENSORS, yaml_layer("\nrate: 4", "p.yaml"))

    found = locate_problems(resolved, [("sets", "s"), ("rate", "too fast"), ("gone", "g")], otherwise="app.xml")

    assert found == (
        Problem("a.xml", 13, "robot1/sets", "s"),
        Problem("app.xml", 0, "robot1/gone", "g"),
        Problem("p.yaml", 2, "robot1/rate", "too fast"),
    )


@pytest.mark.parametrize("override", ["rate=1", "robot1/rate", "robot1//rate=1", "=", ""])
def test_overrides_of_another_form_are_problems(override: str) -> None:
    layers, problems = split_overrides([override], ["robot1"])

    message = "must have the form <robot>/<parameter>=<value>, such as robot1/spin_rate=2.0"
    assert (layers, problems) == ({}, (Problem("--set", 0, override, message),))


def test_overrides_of_an_unknown_robot_are_problems() -> None:
    _, problems = split_overrides(["robot7/rate=1"], ["robot1"])

    assert [str(problem) for problem in problems] == ["--set: robot7/rate: 'robot7' is no robot; nearest is 'robot1'"]


def test_overrides_may_hold_equals_signs_and_the_last_counts() -> None:
    layers, problems = split_overrides(["/robot1/a/b=x=y", "robot1/c=1", "robot1/c= 2 "], ["robot1"])

    assert problems == ()
    assert {path: given.value for path, given in layers["robot1"].items()} == {("a", "b"): "x=y", ("c",): "2"}


texts = st.text(st.characters(codec="utf-8"))
plain = st.one_of(st.booleans(), st.integers(), st.floats(allow_nan=False, allow_infinity=False), texts)
parameters = st.dictionaries(
    texts, st.recursive(plain, lambda inner: st.dictionaries(texts, inner, max_size=4), max_leaves=12), max_size=4
)


@settings(deadline=None, max_examples=50)
@given(parameters)
def test_dumped_parameters_load_equal_by_us_and_by_pyyaml(values: Dict[str, Any]) -> None:
    text = dump_parameters(values)

    assert yaml.safe_load(text) == values
    assert parse_parameters(text, "p.yaml") == values
    assert dump_parameters(parse_parameters(text, "p.yaml")) == text


def test_dumped_parameters_keep_their_order_and_the_types_that_yaml_reads() -> None:
    assert dump_parameters({"b": 2.0, "a": {"small": 1e-7, "text": "1.0", "up": True, "n": 3}}) == (
        "b: 2.0\na:\n  small: 1.0e-07\n  text: '1.0'\n  up: true\n  n: 3\n"
    )


@settings(deadline=None)
@given(
    st.lists(st.sampled_from(["dig", "fill", "rest"]), unique=True),
    st.dictionaries(st.integers(0, 4), st.sampled_from(["dig", "fill", "other"]), max_size=4),
)
def test_parameters_never_leave_a_task_without_an_element(tasks: List[str], claims: Dict[int, str]) -> None:
    text = dump_parameters({"sets": {f"set{index}": {"task_id": task} for index, task in claims.items()}})
    found: Optional[ResolvedParameters] = None
    try:
        found = resolve(SENSORS, yaml_layer(text, "p.yaml"), tasks=tasks)
    except ConfigError as error:
        said = str(error)
    else:
        said = ""
    if found is None:
        assert "no task is left" in said
        return
    sets = found.values["sets"]
    held = [sets[f"set{index}"]["task_id"] for index in range(sets["size"])]
    assert set(tasks) <= set(held)
    assert all(held[index] == task for index, task in claims.items())
