"""Which topics a supervisor hears."""

from __future__ import annotations

import pytest

from rqt_mrta_py.app.live.interest import Interest, TopicChoice
from rqt_mrta_py.hooks import EVERYTHING, Subscription

WISHES = (Subscription("/@robot_id@/busy", "std_msgs/String"), Subscription("/news"), Subscription(EVERYTHING))
ROBOTS = ("robot1", "fleet/robot2")


@pytest.mark.parametrize(
    ("topic", "type_name", "wanted"),
    [
        ("/robot1/odom", "nav_msgs/Odometry", True),
        ("/robot1/arm/joints", "", True),
        ("/fleet/robot2/odom", "nav_msgs/Odometry", True),
        ("/robot9/odom", "nav_msgs/Odometry", False),
        ("/robot9/busy", "std_msgs/String", True),
        ("/news", "std_msgs/String", True),
        ("/robot1/camera/image", "sensor_msgs/Image", False),
        ("/robot1/cloud", "sensor_msgs/PointCloud2", False),
        ("/mrta/incident", "rqt_mrta_py/Incident", False),
        ("/rosout", "rosgraph_msgs/Log", False),
        ("/elsewhere", "std_msgs/String", False),
    ],
)
def test_interest_is_what_is_subscribed_to_and_the_robots_namespaces(topic: str, type_name: str, wanted: bool) -> None:
    assert Interest(WISHES, TopicChoice()).wants(topic, type_name, ROBOTS) is wanted


def test_patterns_name_topics_and_leave_some_out() -> None:
    choice = TopicChoice.of(("robot1/camera/*", "/rosout", "!/robot?/odom"))
    interest = Interest(WISHES, choice)
    assert interest.wants("/robot1/camera/image", "sensor_msgs/Image", ROBOTS)
    assert interest.wants("/rosout", "rosgraph_msgs/Log", ROBOTS)
    assert not interest.wants("/robot1/odom", "nav_msgs/Odometry", ROBOTS)
    assert interest.wants("/robot1/scan", "sensor_msgs/LaserScan", ROBOTS)
