"""On which topics robots will speak, known before they do."""

from __future__ import annotations

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.live.foreseen import spoken_topics
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.hooks import Subscription


def test_a_robot_speaks_where_fellows_do_and_where_its_architecture_says_and_to_its_drivers() -> None:
    mission = load_mission(compose().registry, "border_patrol", "mrta_alliance")
    heard = (
        Subscription("/team/bids", "std_msgs/String", ("data",)),
        Subscription("/robot2/scan", "sensor_msgs/LaserScan"),
        Subscription("/@robot_id@/pose", "geometry_msgs/PoseStamped"),
        Subscription("/mrta/team_state", "rqt_mrta_py/TeamState"),
        Subscription("/team/anything"),
    )
    spoken = dict(spoken_topics(mission, "robot2", heard))
    assert spoken["/team/bids"] == "std_msgs/String"
    assert spoken["/robot2/cmd_vel"] == "geometry_msgs/Twist"
    assert spoken["/alliance/inter_robot_communication"] == "alliance_msgs/InterRobotCommunication"
    assert "/rosout" in spoken
    assert not {"/robot2/scan", "/mrta/team_state", "/team/anything"}.intersection(spoken)
    assert not [topic for topic in spoken if "@" in topic]
