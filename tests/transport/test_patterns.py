from __future__ import annotations

from typing import Optional, Tuple

import pytest

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import EVERYTHING
from rqt_mrta_py.transport.patterns import TopicPattern, resolve_topic


@pytest.mark.parametrize(
    ("pattern", "topic", "found"),
    [
        ("/clock", "/clock", ("", "")),
        ("/clock", "/clock2", None),
        (EVERYTHING, "/anything/at/all", ("", "")),
        ("/@robot_id@/odom", "/robot1/odom", ("robot1", "")),
        ("/@robot_id@/odom", "/ns/robot1/odom", None),
        ("/@robot_id@/odom", "//odom", None),
        ("/@robot_id@/alliance/motivation/@task_id@", "/robot1/alliance/motivation/wander", ("robot1", "wander")),
        ("/@robot_id@/alliance/motivation/@task_id@", "/robot1/alliance/motivation/a/b", None),
        ("/fleet/robot_@robot_id@/state", "/fleet/robot_7/state", ("7", "")),
        ("/@task_id@/of/@robot_id@", "/report/of/robot2", ("robot2", "report")),
        ("/@robot_id@/@robot_id@/x", "/a/a/x", ("a", "")),
        ("/@robot_id@/@robot_id@/x", "/a/b/x", None),
        ("/a.c/@robot_id@", "/abc/robot1", None),
    ],
)
def test_topic_pattern_lets_each_token_stand_for_one_name(
    pattern: str, topic: str, found: Optional[Tuple[str, str]]
) -> None:
    assert TopicPattern(pattern).match(topic) == found


@pytest.mark.parametrize(
    ("topic", "resolved"),
    [
        ("/@robot_id@/odom", "/@robot_id@/odom"),
        ("motivation/@task_id@", "/robot1/motivation/@task_id@"),
        ("~@task_id@/of_@robot_id@", "/robot1/agent/@task_id@/of_@robot_id@"),
        ("odom", "/robot1/odom"),
        (EVERYTHING, EVERYTHING),
    ],
)
def test_resolve_topic_leaves_tokens_alone(topic: str, resolved: str) -> None:
    assert resolve_topic(topic, "/robot1/agent") == resolved


def test_resolve_topic_remaps_names_without_tokens() -> None:
    assert resolve_topic("odom", "/robot1/agent", {"odom": "/odom2"}) == "/odom2"


@pytest.mark.parametrize("topic", ["", "a b", "/@robot@/x", "//x"])
def test_resolve_topic_refuses_what_ros_refuses(topic: str) -> None:
    with pytest.raises(TransportError, match="not a name that ROS accepts"):
        resolve_topic(topic, "/robot1/agent")
