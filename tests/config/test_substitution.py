"""Tokens such as ``@robot_id@``: what they stand for, and where."""

from __future__ import annotations

from typing import Any, Dict, Sequence

import pytest

from rqt_mrta_py.config.parameters.context import ParameterContext
from rqt_mrta_py.config.parameters.layers import Layer, xml_layer, yaml_layer
from rqt_mrta_py.config.parameters.resolving import resolve_parameters
from rqt_mrta_py.config.substitution import has_token, substitute
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import ConfigTemplate

SIZE = "<param_0><name>size</name><type>int</type><value>@array_size@</value><default>2</default></param_0>"


def template_of(params: str) -> ConfigTemplate:
    text = (
        f"<rqt_mrta><architecture><name>A</name></architecture><configs><config_0><id>p</id>{params}"
        "</config_0></configs></rqt_mrta>"
    )
    return read_architecture(text, "a.xml", "a").configs[0]


def values_of(params: str, *layers: Layer, robot: str = "robot1", tasks: Sequence[str] = ()) -> Dict[str, Any]:
    context = ParameterContext(robot, tuple(tasks), bool(tasks), "yard", "a.xml", "app.xml")
    return dict(resolve_parameters(template_of(params), layers, context).values)


def test_substitution_replaces_what_is_known_and_leaves_the_rest() -> None:
    values = {"@robot_id@": "r2", "@package@": "yard"}

    assert substitute("$(find @package@)/config/@robot_id@_p.yaml", values) == "$(find yard)/config/r2_p.yaml"
    assert substitute("@task_id@ @colour@ @@ a@b @index@", values) == "@task_id@ @colour@ @@ a@b @index@"
    assert substitute("@@robot_id@@", values) == "@r2@"


def test_substitution_does_not_look_into_what_it_put_in() -> None:
    assert substitute("@robot_id@", {"@robot_id@": "@package@", "@package@": "yard"}) == "@package@"


@pytest.mark.parametrize(("text", "holds"), [("@index@", True), ("a@task_id@b", True), ("@indx@", False), ("@", False)])
def test_token_is_known_by_its_name(text: str, holds: bool) -> None:
    assert has_token(text) is holds


def test_values_and_defaults_know_robot_package_index_and_size() -> None:
    said = "@robot_id@ of @package@: @index@ of @array_size@"
    params = (
        f"<params_0><name>s</name>{SIZE}<array_1><name>e@index@</name>"
        f"<param_0><name>value</name><value>{said}</value></param_0>"
        f"<param_1><name>default</name><default>{said}</default></param_1></array_1>"
        "<param_2><name>beside</name><default>@array_size@ @index@</default></param_2></params_0>"
    )

    assert values_of(params) == {
        "s": {
            "size": 2,
            "e0": {"value": "robot1 of yard: 0 of 2", "default": "robot1 of yard: 0 of 2"},
            "e1": {"value": "robot1 of yard: 1 of 2", "default": "robot1 of yard: 1 of 2"},
            "beside": "2 @index@",
        }
    }


def test_tokens_of_the_innermost_array_count() -> None:
    inner = (
        "<params_0><name>i</name>"
        "<param_0><name>size</name><type>int</type><default>1</default></param_0>"
        "<array_1><name>f@index@</name><param_0><name>p</name><default>@index@/@array_size@</default></param_0>"
        "</array_1></params_0><param_1><name>p</name><default>@index@/@array_size@</default></param_1>"
    )
    params = f"<params_0><name>s</name>{SIZE}<array_1><name>e@index@</name>{inner}</array_1></params_0>"

    assert values_of(params)["s"]["e1"] == {"i": {"size": 1, "f0": {"p": "0/1"}}, "p": "1/2"}


def test_names_know_robot_and_package_whoever_gives_the_value() -> None:
    params = (
        "<param_0><name>@robot_id@_speed</name><type>double</type><default>1</default></param_0>"
        f"<params_1><name>@package@</name>{SIZE}<array_1><name>@robot_id@_@index@</name>"
        "<param_0><name>p</name><default>x</default></param_0></array_1></params_1>"
    )

    assert values_of(params) == {
        "robot1_speed": 1.0,
        "yard": {"size": 2, "robot1_0": {"p": "x"}, "robot1_1": {"p": "x"}},
    }
    xml = xml_layer(template_of("<param_0><name>@robot_id@_speed</name><value>3</value></param_0>").items, "x")
    file = yaml_layer("{robot1_speed: 4, yard: {robot1_2: {p: y}}}", "p.yaml")
    assert values_of(params, xml)["robot1_speed"] == 3.0
    found = values_of(params, xml, file)
    assert found["robot1_speed"] == 4.0
    assert found["yard"]["size"] == 3
    assert found["yard"]["robot1_2"] == {"p": "y"}


def test_elements_may_bear_the_names_of_tasks() -> None:
    params = (
        f"<params_0><name>sets</name>{SIZE}<array_1><name>set_@task_id@</name>"
        "<param_0><name>rate</name><type>double</type><default>1</default></param_0></array_1></params_0>"
    )

    given = yaml_layer("sets: {set_fill: {rate: 2}}", "p.yaml")
    assert values_of(params, given, tasks=("dig", "fill")) == {
        "sets": {"size": 2, "set_dig": {"rate": 1.0}, "set_fill": {"rate": 2.0}}
    }
    with pytest.raises(ConfigError) as caught:
        values_of(params, yaml_layer("sets: {size: 3}", "p.yaml"), tasks=("dig", "fill"))
    assert str(caught.value) == (
        "a.xml:1: robot1/sets/set_@task_id@: stands for a task (set_@task_id@), but no task is left for it; "
        "the robot's tasks: dig, fill"
    )


def test_tokens_that_nobody_knows_stay_as_they_are() -> None:
    params = "<param_0><name>topic</name><default>/@robot_id@/job/@task_id@/@index@/@colour@</default></param_0>"

    assert values_of(params) == {"topic": "/robot1/job/@task_id@/@index@/@colour@"}
    assert values_of(params, robot="") == {"topic": "/@robot_id@/job/@task_id@/@index@/@colour@"}
