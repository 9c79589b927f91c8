"""What is written is read as what was meant, and writing it again changes nothing."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, List

import pytest
from hypothesis import HealthCheck, given, settings
from lxml import etree

from rqt_mrta_py.config.schema.shipped import grammars
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.writing import write_application, write_architecture
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    ConfigTemplate,
    IncludeSpec,
    LaunchTemplate,
    MapTemplate,
    MonitoredTopic,
    ParameterTemplate,
    ParameterType,
    RobotType,
    TaskType,
    Taxonomy,
)
from tests.config.spec_strategies import applications, architectures
from tests.conftest import ROOT

ARCHITECTURE = ArchitectureSpec("a", "A", Taxonomy())
APPLICATION = ApplicationSpec("a", "A")


@settings(deadline=None, max_examples=25)
@given(architectures())
def test_any_architecture_survives(spec: ArchitectureSpec) -> None:
    text = write_architecture(spec)

    assert read_architecture(text, "a.xml", "a") == spec
    assert read_architecture(text.encode("utf-8"), "a.xml", "a") == spec


@settings(deadline=None, max_examples=40)
@given(applications())
def test_any_application_survives(spec: ApplicationSpec) -> None:
    text = write_application(spec)

    assert read_application(text, "a.xml", "a") == spec
    assert read_application(text.encode("utf-8"), "a.xml", "a") == spec


@pytest.mark.long
@settings(deadline=None, max_examples=2000, suppress_health_check=list(HealthCheck))
@given(architectures(), applications())
def test_any_specification_survives_in_a_long_campaign(
    architecture: ArchitectureSpec, application: ApplicationSpec
) -> None:
    assert read_architecture(write_architecture(architecture), "a.xml", "a") == architecture
    assert read_application(write_application(application), "a.xml", "a") == application


@settings(deadline=None, max_examples=8)
@given(architectures(), applications())
def test_what_is_written_is_valid(architecture: ArchitectureSpec, application: ApplicationSpec) -> None:
    texts = grammars()
    for text, name in (
        (write_architecture(architecture), "architecture"),
        (write_application(application), "application"),
    ):
        grammar = etree.RelaxNG(etree.fromstring(texts[f"{name}.rng"].encode()))
        assert grammar.validate(etree.fromstring(text.encode())), grammar.error_log


@pytest.mark.parametrize(
    "path",
    [
        *sorted((ROOT / "tests" / "data" / "config").glob("*_a*.xml")),
        *sorted((ROOT / "plugins").glob("*s/*/rqt_mrta.xml")),
    ],
    ids=lambda path: "/".join(path.parts[-2:]),
)
def test_files_are_stable_after_one_round(path: Path) -> None:
    raw = path.read_bytes()
    if b"<application>" in raw:
        application = read_application(raw, str(path), "p")
        text = write_application(application)
        again = read_application(text, "again", "p")
        assert (again, write_application(again)) == (application, text)
    else:
        architecture = read_architecture(raw, str(path), "p")
        text = write_architecture(architecture)
        other = read_architecture(text, "again", "p")
        assert (other, write_architecture(other)) == (architecture, text)


def test_an_architecture_is_written_as_the_original_does() -> None:
    """Declaration, format, four spaces, one count for parameters and groups, nothing for what is not there."""
    speed = ParameterTemplate("speed", ParameterType.DOUBLE, default="0.5", tool_tip="Enter <v> & so on (in [m/s]).")
    name = ParameterTemplate("name", ParameterType.STRING, "@robot_id@")
    spec = ArchitectureSpec(
        package="a",
        name="A & B",
        taxonomy=Taxonomy(RobotType.SINGLE_TASK, TaskType.UNKNOWN),
        busy_robots=(MonitoredTopic("/busy", "p/M", "id", queue_size=10, timeout=2.5, horizon=10),),
        robot_config_id="p",
        configs=(ConfigTemplate("p", (name, MapTemplate("g", (speed,)))),),
        widgets=("rqt_alliance/alliance_plugin",),
    )

    assert write_architecture(spec) == (
        """<?xml version="1.0" encoding="UTF-8"?>
<rqt_mrta format="architecture">
    <architecture>
        <name>A &amp; B</name>
        <robots>
            <type>ST</type>
            <config_id>p</config_id>
            <busy_robots>
                <topic>
                    <name>/busy</name>
                    <type>p/M</type>
                    <field>id</field>
                    <queue_size>10</queue_size>
                    <timeout>2.5</timeout>
                    <horizon>10.0</horizon>
                </topic>
            </busy_robots>
        </robots>
        <tasks/>
        <allocations/>
    </architecture>
    <configs>
        <config_0>
            <id>p</id>
            <param_0>
                <name>name</name>
                <type>string</type>
                <value>@robot_id@</value>
            </param_0>
            <params_1>
                <name>g</name>
                <param_0>
                    <name>speed</name>
                    <type>double</type>
                    <default>0.5</default>
                    <tool_tip>Enter &lt;v&gt; &amp; so on (in [m/s]).</tool_tip>
                </param_0>
            </params_1>
        </config_0>
    </configs>
    <widgets>
        <widget_0>
            <plugin_name>rqt_alliance/alliance_plugin</plugin_name>
        </widget_0>
    </widgets>
</rqt_mrta>
"""
    )


def test_ids_keep_their_slashes() -> None:
    spec = replace(
        ARCHITECTURE,
        robot_config_id="/p",
        robot_launch_id="//l",
        configs=(ConfigTemplate("/p", ()), ConfigTemplate("p", ())),
        launches=(LaunchTemplate("//l", ()),),
    )
    team = replace(APPLICATION, robots=(ApplicationRobot("/r", ("/t", "t")), ApplicationRobot("r")))

    assert read_architecture(write_architecture(spec), "a", "a") == spec
    assert read_application(write_application(team), "a", "a") == team


def said_of(spec: object) -> List[str]:
    write: Any = write_architecture if isinstance(spec, ArchitectureSpec) else write_application
    with pytest.raises(ConfigError) as caught:
        write(spec)
    return [str(problem) for problem in caught.value.problems]


def config_of(*items: object) -> ArchitectureSpec:
    return replace(ARCHITECTURE, robot_config_id="c", configs=(ConfigTemplate("c", items),))  # type: ignore[arg-type]


def nested(depth: int) -> MapTemplate:
    inner = MapTemplate("x", ())
    for _ in range(depth):
        inner = MapTemplate("x", (inner,))
    return inner


@pytest.mark.parametrize(
    ("spec", "said"),
    [
        (replace(APPLICATION, name="a\0b"), "application/name: holds '\\x00', which XML cannot hold; leave it out"),
        (replace(APPLICATION, name="\ud800"), "application/name: holds '\\ud800', which XML cannot hold; leave it out"),
        (replace(APPLICATION, name="\uffff"), "application/name: holds '\\uffff', which XML cannot hold; leave it out"),
        (
            replace(APPLICATION, name="", robots=(ApplicationRobot("r"),)),
            "application/name: is missing or empty; give a text",
        ),
        (
            replace(APPLICATION, name="a\nb"),
            "application/name: must be one line without white space around it, as a reader gives it (got 'a\\nb')",
        ),
        (
            replace(APPLICATION, robots=(ApplicationRobot("a b"),)),
            "application/robots/robot_0/id: must not contain a space (got 'a b')",
        ),
        (
            config_of(ParameterTemplate("a", ParameterType.INT, "1.5")),
            "configs/config_0/param_0/value: must be a whole number (got '1.5')",
        ),
        (
            config_of(ParameterTemplate("a", ParameterType.STRING, "")),
            "configs/0/items/0/value: would be read as None (got ''); write it so",
        ),
        (
            config_of(ParameterTemplate("/a", ParameterType.STRING)),
            "configs/0/items/0/name: would be read as 'a' (got '/a'); write it so",
        ),
        (
            config_of(nested(2000)),
            f"configs/config_0/{'params_0/' * 251}".rstrip("/") + ": is nested deeper than 250 groups; make it flatter",
        ),
        (
            replace(ARCHITECTURE, configs=(ConfigTemplate("c", ()),)),
            "architecture/robots: must have a config_id: readers give a file's only config to every robot",
        ),
        (
            replace(ARCHITECTURE, busy_robots=(MonitoredTopic("/a", "p/M", "f", timeout=float("inf")),)),
            "architecture/robots/busy_robots/topic/timeout: must be above 0 s (got 'inf'); give a positive number",
        ),
        (
            replace(ARCHITECTURE, busy_robots=(MonitoredTopic("", "p/M", "f"),)),
            "architecture/robots/busy_robots/topic/name: is missing or empty; give a text",
        ),
        (
            replace(ARCHITECTURE, launches=(LaunchTemplate("l", (IncludeSpec(""),)),)),
            "launches/0/includes: would be read as () (got (IncludeSpec(file='', arguments=()),)); write it so",
        ),
    ],
)
def test_what_no_file_can_say_is_refused(spec: object, said: str) -> None:
    assert said_of(spec) == [f"rqt_mrta.xml: {said}"]


def test_everything_that_cannot_be_written_is_told_at_once() -> None:
    robots = (ApplicationRobot("a\0"), ApplicationRobot("b", ("t\1",)))

    assert len(said_of(replace(APPLICATION, name=" x", robots=robots))) == 3


def test_templates_are_equal_wherever_they_stand() -> None:
    assert ConfigTemplate("a", (), 3) == ConfigTemplate("a", (), 9)
    assert ParameterTemplate("a", ParameterType.INT, line=1) != ParameterTemplate("b", ParameterType.INT, line=1)
