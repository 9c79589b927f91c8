"""Architectures: the dissertation's file, the final repository's form, our additions to the grammar."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import (
    AllocationType,
    ArrayTemplate,
    ConfigTemplate,
    IncludeSpec,
    LaunchArgument,
    LaunchTemplate,
    MapTemplate,
    MonitoredTopic,
    ParameterTemplate,
    ParameterType,
    RobotType,
    TaskType,
    TopicCondition,
    TopicJoin,
)

MINIMAL = "<rqt_mrta><architecture><name>A</name>{}</architecture>{}</rqt_mrta>"


def with_params(params: str) -> ConfigTemplate:
    text = MINIMAL.format("", f"<configs><config_0><id>p</id>{params}</config_0></configs>")
    return read_architecture(text, "a.xml", "a").configs[0]


def with_topic(kind: str, group: str, topic: str) -> str:
    return MINIMAL.format(f"<{group}><{kind}><topic>{topic}</topic></{kind}></{group}>", "")


def test_architecture_of_appendix_a_loads_unchanged(data: Path) -> None:
    path = data / "appendix_a_architecture.xml"

    spec = read_architecture(path.read_bytes(), str(path), "alliance")

    topic = "/alliance/inter_robot_communication"
    kind = "alliance_msgs/InterRobotCommunication"
    assert (spec.package, spec.name, str(spec.taxonomy)) == ("alliance", "ALLIANCE", "ST-SR-IA")
    assert spec.busy_robots == (MonitoredTopic(topic, kind, "header/frame_id", "", "", 10, 2.0, 10.0),)
    assert spec.allocated_tasks == (MonitoredTopic(topic, kind, "task_id", "", "", 10, 0.5, 10.0),)
    assert spec.idle_robots == spec.incoming_tasks == spec.completed_tasks == spec.failed_tasks == ()
    assert spec.widgets == ("rqt_alliance/alliance_plugin",)
    assert [item.name for item in spec.configs[0].items] == [
        "name",
        "spin_rate",
        "broadcast_rate",
        "timeout_duration",
        "buffer_horizon",
        "sensors",
        "behaviour_sets",
    ]


def test_architecture_without_config_id_gives_its_only_config_to_every_robot(data: Path) -> None:
    spec = read_architecture((data / "appendix_a_architecture.xml").read_text("utf-8"), "a.xml", "alliance")

    assert spec.robot_config_id == "alliance_params"
    assert spec.robot_launch_id is None


def test_architecture_in_the_form_of_the_final_repository_loads(data: Path) -> None:
    spec = read_architecture((data / "final_architecture.xml").read_bytes(), "a.xml", "alliance")

    assert str(spec.taxonomy) == "ST-SR-IA"
    assert (spec.robot_config_id, spec.robot_launch_id) == ("alliance_params", "alliance")
    assert spec.busy_robots[0].horizon == 5.0
    assert spec.idle_robots == ()
    tasks, layers, robot = spec.configs
    assert (tasks.id, layers.id, robot.id) == ("tasks_alliance_params", "layers_alliance_params", "alliance_params")
    assert layers.items == ()
    group = tasks.items[0]
    assert isinstance(group, MapTemplate)
    size, array = group.items
    assert isinstance(size, ParameterTemplate)
    assert (size.name, size.type, size.value) == ("size", ParameterType.INT, "@array_size@")
    assert isinstance(array, ArrayTemplate)
    assert array.name == "task@index@"
    assert spec.launches == (
        LaunchTemplate(
            "alliance",
            (
                IncludeSpec(
                    "$(find alliance)/launch/alliance.launch",
                    (
                        LaunchArgument("robot_id", "@robot_id@"),
                        LaunchArgument("robot_params", "$(find @package@)/config/@robot_id@_alliance_params.yaml"),
                        LaunchArgument("tasks_params", "$(find @package@)/config/tasks_alliance_params.yaml"),
                    ),
                ),
            ),
        ),
    )


def test_architecture_keeps_zero_and_false_as_defaults_and_reads_qt_types(data: Path) -> None:
    spec = read_architecture((data / "final_architecture.xml").read_bytes(), "a.xml", "alliance")

    name, spin_rate, impatience = spec.configs[2].items
    assert isinstance(name, ParameterTemplate)
    assert isinstance(spin_rate, ParameterTemplate)
    assert isinstance(impatience, MapTemplate)
    fast_rate = impatience.items[0]
    assert isinstance(fast_rate, ParameterTemplate)
    assert (name.default, name.tool_tip) == (None, "Enter the robot name.")
    assert (spin_rate.type, spin_rate.default) == (ParameterType.DOUBLE, "0")
    assert (fast_rate.type, fast_rate.default) == (ParameterType.BOOL, "false")


def test_architecture_sorts_numbered_elements_by_number_across_kinds_past_nine() -> None:
    numbers = [10, 2, 0, 11, 1, 12]
    kinds = {0: "param", 1: "params", 2: "param", 10: "params", 11: "param", 12: "params"}
    params = "".join(f"<{kinds[n]}_{n}><name>n{n}</name></{kinds[n]}_{n}>" for n in numbers)

    assert [item.name for item in with_params(params).items] == ["n0", "n1", "n2", "n10", "n11", "n12"]


def test_architecture_takes_any_other_type_for_text() -> None:
    item = with_params("<param_0><name>a</name><type>QVariant</type><value>1</value></param_0>").items[0]

    assert isinstance(item, ParameterTemplate)
    assert item.type is ParameterType.STRING


def test_architecture_does_not_judge_the_type_of_a_text_with_a_token() -> None:
    item = with_params("<param_0><name>a</name><type>int</type><value>@array_size@</value></param_0>").items[0]

    assert isinstance(item, ParameterTemplate)
    assert item.value == "@array_size@"


def test_architecture_reads_our_additions_to_the_grammar() -> None:
    topic = (
        "<name>/@robot_id@/job/@task_id@</name><type>p/M</type><robot_field>robot</robot_field>"
        "<task_field>task/id</task_field>"
    )
    for kind in ("completed_tasks", "failed_tasks", "incoming_tasks"):
        spec = read_architecture(with_topic(kind, "tasks", topic), "a.xml", "a")

        assert getattr(spec, kind) == (
            MonitoredTopic("/@robot_id@/job/@task_id@", "p/M", "", robot_field="robot", task_field="task/id"),
        )


def test_architecture_reads_what_stands_for_a_task_and_which_messages_count() -> None:
    join = "<name>/news</name><type>p/Offer</type><field>id</field><task_field>task/id</task_field>"
    topic = (
        "<name>/closed</name><type>p/M</type><field>auction</field>"
        f"<join>{join}</join><when><field>status</field><value> 1 </value></when>"
    )

    (found,) = read_architecture(with_topic("allocated_tasks", "allocations", topic), "a.xml", "a").allocated_tasks

    assert found.join == TopicJoin("/news", "p/Offer", "id", "task/id")
    assert found.condition == TopicCondition("status", "1")


@pytest.mark.parametrize(
    ("inner", "problem"),
    [
        ("<join><name>/n</name><type>p/M</type><field>id</field></join>", "join/task_field: is missing or empty"),
        ("<join><type>p/M</type><field>id</field><task_field>t</task_field></join>", "join/name: is missing or empty"),
        (
            "<join><name>n</name><type>p/M</type><field>id</field><task_field>t</task_field></join>",
            "join/name: must be an absolute topic (got 'n')",
        ),
        (
            "<join><name>/n</name><type>M</type><field>id</field><task_field>t</task_field></join>",
            "join/type: must be a message type (got 'M')",
        ),
        (
            "<join><name>/n</name><type>p/M</type><field>i.d</field><task_field>t</task_field></join>",
            "join/field: must be a path of fields joined by / (got 'i.d')",
        ),
        ("<when><field>status</field></when>", "when/value: is missing or empty"),
        ("<when><value>1</value></when>", "when/field: is missing or empty"),
        ("<when><field>a b</field><value>1</value></when>", "when/field: must be a path of fields"),
        ("<when><field>a</field><value>1</value></when><when><field>b</field></when>", "when: stands twice"),
    ],
)
def test_architecture_says_what_is_wrong_with_a_join_or_a_condition(inner: str, problem: str) -> None:
    topic = f"<name>/closed</name><type>p/M</type><field>auction</field>{inner}"

    with pytest.raises(ConfigError, match=re.escape(f"architecture/allocations/allocated_tasks/topic/{problem}")):
        read_architecture(with_topic("allocated_tasks", "allocations", topic), "a.xml", "a")


def test_architecture_reads_bids() -> None:
    topic = "<name>/bids</name><type>p/Bid</type><field>task</field><robot_field>who</robot_field>"
    text = with_topic("bids", "allocations", f"{topic}<bid_field>amount</bid_field>")

    spec = read_architecture(text, "a.xml", "a")

    assert spec.bids == (MonitoredTopic("/bids", "p/Bid", "task", robot_field="who", bid_field="amount"),)
    assert spec.monitored_topics == ()


@pytest.mark.parametrize(
    ("kind", "inner", "problem"),
    [
        ("bids", "", "bids/topic/bid_field: is missing or empty"),
        ("bids", "<bid_field>a b</bid_field>", "bids/topic/bid_field: must be a path of fields"),
        ("allocated_tasks", "<bid_field>amount</bid_field>", "allocated_tasks/topic/bid_field: is not expected here"),
    ],
)
def test_architecture_says_what_is_wrong_with_bids(kind: str, inner: str, problem: str) -> None:
    topic = f"<name>/bids</name><type>p/Bid</type><field>task</field>{inner}"

    with pytest.raises(ConfigError, match=re.escape(problem)):
        read_architecture(with_topic(kind, "allocations", topic), "a.xml", "a")


def test_architecture_takes_several_topics_of_one_kind() -> None:
    topic = "<name>/{}</name><type>p/M</type><field>id</field>"
    text = MINIMAL.format(
        f"<robots><busy_robots><topic_10>{topic.format('c')}</topic_10><topic_2>{topic.format('b')}</topic_2>"
        f"<topic>{topic.format('a')}</topic></busy_robots></robots>",
        "",
    )

    assert [found.name for found in read_architecture(text, "a.xml", "a").busy_robots] == ["/a", "/b", "/c"]


def test_architecture_takes_a_topic_of_numbers_only_for_an_absent_one() -> None:
    """A new architecture of the original holds such topics for all that its author left out."""
    numbers = "<name/><type></type><field> </field><queue_size>10</queue_size><timeout>2</timeout><horizon>5</horizon>"

    assert read_architecture(with_topic("idle_robots", "robots", numbers), "a.xml", "a").idle_robots == ()


def test_architecture_defaults_of_a_topic_are_those_of_the_original() -> None:
    text = with_topic("busy_robots", "robots", "<name>/a</name><type>p/M</type><field>id</field>")

    topic = read_architecture(text, "a.xml", "a").busy_robots[0]

    assert (topic.queue_size, topic.timeout, topic.horizon) == (0, 2.0, 5.0)


def test_architecture_of_unknown_type_is_unknown_on_that_axis() -> None:
    text = MINIMAL.format(
        "<robots><type>Multi Task (MT)</type></robots><allocations><type>Time Extended Assignment</type></allocations>",
        "",
    )

    taxonomy = read_architecture(text, "a.xml", "a").taxonomy

    assert taxonomy.robots is RobotType.MULTI_TASK
    assert taxonomy.tasks is TaskType.UNKNOWN
    assert taxonomy.allocations is AllocationType.UNKNOWN
    assert str(taxonomy) == "MT--"


def test_architecture_skips_comments_and_joins_wrapped_text() -> None:
    text = "<rqt_mrta><!-- a --><architecture><name>\n  The\n   best <!-- b -->one </name></architecture></rqt_mrta>"

    assert read_architecture(text, "a.xml", "a").name == "The best one"
