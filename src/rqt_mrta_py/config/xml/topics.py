"""The ``topic`` element of the rqt_mrta grammar, with our optional additions."""

from __future__ import annotations

import re
from typing import List, Optional, Tuple

from rqt_mrta_py.config.xml.element import Element
from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN, MonitoredTopic, TopicCondition, TopicJoin, is_legal_name
from rqt_mrta_py.wording import shown

__all__ = ["BIDS", "read_topics"]

BIDS = "bids"
"""The element whose topics have a field with a bid."""

_TOKENS = (ROBOT_TOKEN, TASK_TOKEN)
_TELLING = ("name", "type", "field", "robot_field", "task_field", "join", "when", "bid_field")
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
    of_bids = name == BIDS
    return tuple(topic for topic in (_read_topic(each, of_bids) for each in elements) if topic is not None)


def _read_topic(element: Element, of_bids: bool) -> Optional[MonitoredTopic]:
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
        join=_read_join(element),
        condition=_read_condition(element),
        bid_field=element.required("bid_field") if of_bids else "",
    )
    element.finish()
    _check(topic, element)
    return topic


def _read_join(parent: Element) -> Optional[TopicJoin]:
    element = parent.child("join")
    if element is None:
        return None
    join = TopicJoin(*(element.required(name) for name in ("name", "type", "field", "task_field")))
    element.finish()
    _check_name(join.name, element)
    _check_type(join.type, element)
    _check_fields(element, field=join.field, task_field=join.task_field)
    return join


def _read_condition(parent: Element) -> Optional[TopicCondition]:
    element = parent.child("when")
    if element is None:
        return None
    condition = TopicCondition(element.required("field"), element.required("value"))
    element.finish()
    _check_fields(element, field=condition.field)
    return condition


def _check(topic: MonitoredTopic, element: Element) -> None:
    _check_name(topic.name, element)
    _check_type(topic.type, element)
    _check_fields(element, field=topic.field, robot_field=topic.robot_field, task_field=topic.task_field)
    _check_fields(element, bid_field=topic.bid_field)
    if not (topic.field or any(token in topic.name for token in _TOKENS)):
        element.problem("field", f"is missing; give the field with the id, or {' or '.join(_TOKENS)} in the name")


def _check_name(name: str, element: Element) -> None:
    plain = name
    for token in _TOKENS:
        plain = plain.replace(token, "x")
    if name and not (plain.startswith("/") and is_legal_name(plain)):
        element.problem(
            "name",
            f"must be an absolute topic (got {shown(name)}); begin with /, then letters, digits, _ and /, "
            f"or {' and '.join(_TOKENS)} for the name of a robot or task",
        )


def _check_type(type_name: str, element: Element) -> None:
    if type_name and not _TYPE.match(type_name):
        element.problem("type", f"must be a message type (got {shown(type_name)}), such as std_msgs/String")


def _check_fields(element: Element, **paths: str) -> None:
    for name, path in paths.items():
        if path and not _FIELD.match(path):
            element.problem(name, f"must be a path of fields joined by / (got {shown(path)}), such as header/frame_id")
