from __future__ import annotations

from typing import Dict

import pytest

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.supervisor.presence import Presence
from rqt_mrta_py.supervisor.robots import RobotWatch


def team(*ids: str) -> Dict[str, RobotWatch]:
    return {robot_id: RobotWatch(robot_id, order, 0.0) for order, robot_id in enumerate(ids)}


@pytest.mark.parametrize(
    ("topic", "caller", "owner"),
    [
        ("/robot1/odom", "/robot1/driver", "robot1"),
        ("/robot1/cmd_vel", "/robot2/agent", "robot2"),
        ("/robot1/odom", "/simulation", "robot1"),
        ("/tf", "/robot2/driver", "robot2"),
        ("/tf", "/simulation", ""),
        ("/robot10/odom", "", ""),
        ("/robot1", "/robot1", ""),
        ("/fleet/robot1/odom", "", "fleet/robot1"),
        ("/fleet/odom", "", "fleet"),
        ("/says/who", "/robot1/agent", ""),
    ],
)
def test_a_message_is_of_the_robot_in_whose_namespace_its_caller_or_else_its_topic_is(
    topic: str, caller: str, owner: str
) -> None:
    presence = Presence(team("robot1", "robot2", "fleet", "fleet/robot1"), naming=("/says/who",))
    found = presence.owner(Connection(topic, "std_msgs/Empty", "", "", caller))
    assert (found.id if found else "") == owner


def test_a_robot_that_joins_is_found() -> None:
    robots = team("robot1")
    presence = Presence(robots)
    connection = Connection("/robot2/odom", "std_msgs/Empty", "", "")
    assert presence.owner(connection) is None
    robots.update(team("robot2"))
    assert presence.owner(connection) is robots["robot2"]
