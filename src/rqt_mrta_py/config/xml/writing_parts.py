"""Elements that both flavours of rqt_mrta.xml write: topics, templates of parameters, launches, widgets."""

from __future__ import annotations

from typing import Sequence, Tuple

from rqt_mrta_py.config.xml.ids import written_id
from rqt_mrta_py.config.xml.tree import Branch
from rqt_mrta_py.model import (
    ArrayTemplate,
    ConfigTemplate,
    IncludeSpec,
    LaunchArgument,
    LaunchTemplate,
    MapTemplate,
    MonitoredTopic,
    ParameterTemplate,
    TemplateItem,
)

__all__ = ["write_configs", "write_launches", "write_topics", "write_widgets"]

_DEEPEST = 250


def write_topics(parent: Branch, name: str, topics: Sequence[MonitoredTopic]) -> None:
    """Write the topics of one kind, such as ``busy_robots``; one alone bears no number, as in the original."""
    if len(topics) == 1:
        _write_topic(parent.inner(name).inner("topic"), topics[0])
    elif topics:
        parent.inner(name).numbered("topic", topics, _write_topic)


def write_configs(root: Branch, configs: Sequence[ConfigTemplate]) -> None:
    """Write templates of parameters, empty or filled in."""
    if configs:
        root.inner("configs").numbered("config", configs, _write_config)


def write_launches(root: Branch, launches: Sequence[LaunchTemplate]) -> None:
    """Write templates of launch files."""
    if launches:
        root.inner("launches").numbered("launch", launches, _write_launch)


def write_widgets(root: Branch, widgets: Sequence[str]) -> None:
    """Write the names of monitor panels."""
    if widgets:
        root.inner("widgets").numbered("widget", widgets, lambda branch, name: branch.leaf("plugin_name", name))


def _write_topic(branch: Branch, topic: MonitoredTopic) -> None:
    for name in ("name", "type", "field", "robot_field", "task_field", "bid_field"):
        branch.leaf(name, getattr(topic, name))
    branch.leaf("queue_size", str(topic.queue_size))
    branch.leaf("timeout", repr(float(topic.timeout)))
    branch.leaf("horizon", repr(float(topic.horizon)))
    if topic.join is not None:
        inner = branch.inner("join")
        for name in ("name", "type", "field", "task_field"):
            inner.leaf(name, getattr(topic.join, name))
    if topic.condition is not None:
        inner = branch.inner("when")
        inner.leaf("field", topic.condition.field)
        inner.leaf("value", topic.condition.value)


def _write_config(branch: Branch, config: ConfigTemplate) -> None:
    branch.leaf("id", written_id(config.id))
    _write_items(branch, config.items, 0)


def _write_items(branch: Branch, items: Tuple[TemplateItem, ...], depth: int) -> None:
    if depth > _DEEPEST:
        branch.refuse(f"is nested deeper than {_DEEPEST} groups; make it flatter")
        return
    for number, item in enumerate(items):
        if isinstance(item, ParameterTemplate):
            _write_parameter(branch.inner(f"param_{number}"), item)
        else:
            inner = branch.inner(f"{_KINDS[type(item)]}_{number}")
            inner.leaf("name", item.name)
            _write_items(inner, item.items, depth + 1)


_KINDS = {MapTemplate: "params", ArrayTemplate: "array"}


def _write_parameter(branch: Branch, item: ParameterTemplate) -> None:
    branch.leaf("name", item.name)
    branch.leaf("type", item.type.value)
    branch.leaf("value", item.value)
    branch.leaf("default", item.default)
    branch.leaf("tool_tip", item.tool_tip)


def _write_launch(branch: Branch, launch: LaunchTemplate) -> None:
    branch.leaf("id", written_id(launch.id))
    if launch.includes:
        branch.inner("includes").numbered("include", launch.includes, _write_include)


def _write_include(branch: Branch, include: IncludeSpec) -> None:
    branch.leaf("file", include.file)
    if include.arguments:
        branch.inner("args").numbered("arg", include.arguments, _write_argument)


def _write_argument(branch: Branch, argument: LaunchArgument) -> None:
    branch.leaf("name", argument.name)
    branch.leaf("value", argument.value)
    branch.leaf("default", argument.default)
