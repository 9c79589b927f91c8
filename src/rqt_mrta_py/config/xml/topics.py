"""The ``topic`` element of the rqt_mrta grammar, with our optional additions."""

from __future__ import annotations

import re
from typing import List, Optional, Tuple

from rqt_mrta_py.config.xml.element import Element
from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN, MonitoredTopic, is_legal_name
from rqt_mrta_py.wording import shown

__all__ = ["read_topics"]

_TOKENS = (ROBOT_TOKEN, TASK_TOKEN)
_TELLING = ("name", "type", "field", "robot_field", "task_field")
_TYPE = re.compile(r"[A-Za-z]\w*/[A-Za-z]\w*\Z", re.ASCII)
_FIELD = re.compile(r"[A-Za-z]\w*(/[A-Za-z]\w*)*\Z", re.ASCII)


def read_topics(parent: Optional[Element], name: str) -> Tuple[MonitoredTopic, ...]:
    """Read the topics of one kind, such as ``busy_robots``.

    Args:
        parent: ``robots``, ``tasks`` or ``allocations``; None if that is absent.
        name: of the element that holds the topics.

    Returns:
        One topic for each ``topic`` or ``topic_<i>``; none where the element is absent or empty.
    """
    holder = parent.child(name) if parent is not None else None
    if holder is None:
        return ()
    elements: List[Element] = [*holder.repeated("topic"), *(entry.element for entry in holder.numbered(["topic"]))]
    holder.finish()
    return tuple(topic for topic in map(_read_topic, elements) if topic is not None)


def _read_topic(element: Element) -> Optional[MonitoredTopic]:
    if not any(element.has(name) for name in _TELLING):
        # The original writes a topic that was never filled in with its numbers only.
        element.skip()
        return None
    topic = MonitoredTopic(
        name=element.required("name"),
        type=element.required("type"),
        field=element.string("field"),
        robot_field=element.string("robot_field"),
        task_field=element.string("task_field"),
        queue_size=element.whole("queue_size", 0),
        timeout=element.seconds("timeout", 2.0),
        horizon=element.seconds("horizon", 5.0),
    )
    element.finish()
    _check(topic, element)
    return topic


def _check(topic: MonitoredTopic, element: Element) -> None:
    tokens = [token for token in _TOKENS if token in topic.name]
    plain = topic.name
    for token in tokens:
        plain = plain.replace(token, "x")
    if topic.name and not (plain.startswith("/") and is_legal_name(plain)):
        element.problem(
            "name",
            f"must be an absolute topic (got {shown(topic.name)}); begin with /, then letters, digits, _ and /, "
            f"or {' and '.join(_TOKENS)} for the name of a robot or task",
        )
    if topic.type and not _TYPE.match(topic.type):
        element.problem("type", f"must be a message type (got {shown(topic.type)}), such as std_msgs/String")
    for name, field in (("field", topic.field), ("robot_field", topic.robot_field), ("task_field", topic.task_field)):
        if field and not _FIELD.match(field):
            element.problem(name, f"must be a path of fields joined by / (got {shown(field)}), such as header/frame_id")
    if not (topic.field or tokens):
        element.problem("field", f"is missing; give the field with the id, or {' or '.join(_TOKENS)} in the name")
