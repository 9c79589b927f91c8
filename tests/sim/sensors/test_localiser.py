from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import SensorMoment
from rqt_mrta_py.model import Pose
from rqt_mrta_py.sim.messages import pose_of
from rqt_mrta_py.sim.sensors import Localiser
from tests.sim.doubles import ScriptedRandom, StillWorld
from tests.sim.sensors.support import context

TRUTH = Pose(1.0, -2.0, 3.0)


def locate(sensor):
    (outgoing,) = sensor.sense(SensorMoment(4.0, TRUTH, None, StillWorld()))
    return outgoing


def test_localiser_publishes_a_pose_in_the_map():
    outgoing = locate(Localiser(context("localiser", "pose", position_noise=0.0, heading_noise=0.0)))
    assert (outgoing.topic, outgoing.type) == ("pose", "geometry_msgs/PoseStamped")
    assert outgoing.fields["header"] == {"stamp": 4.0, "frame_id": "map"}
    assert outgoing.fields["pose"]["position"] == {"x": 1.0, "y": -2.0}
    assert outgoing.fields["pose"]["orientation"]["z"] == pytest.approx(math.sin(1.5))
    assert outgoing.fields["pose"]["orientation"]["w"] == pytest.approx(math.cos(1.5))


def test_localiser_adds_noise_to_each_part():
    random = ScriptedRandom([1.0, -2.0, 3.0])
    pose = pose_of(locate(Localiser(context("localiser", "pose", random=random))).fields["pose"])
    assert (pose.x, pose.y, pose.yaw) == (pytest.approx(1.01), pytest.approx(-2.02), pytest.approx(3.03))


def test_localiser_noise_has_the_deviations_asked_for_and_no_memory():
    sensor = Localiser(context("localiser", "pose", position_noise=0.05, heading_noise=0.02))
    poses = [pose_of(locate(sensor).fields["pose"]) for _ in range(4000)]
    x = np.array([pose.x for pose in poses])
    assert np.mean(x) == pytest.approx(1.0, abs=0.004)
    assert np.std(x) == pytest.approx(0.05, rel=0.05)
    assert np.corrcoef(x[1:], x[:-1])[0, 1] == pytest.approx(0.0, abs=0.06)
    heading = [math.remainder(pose.yaw - 3.0, 2 * math.pi) for pose in poses]
    assert np.std(heading) == pytest.approx(0.02, rel=0.05)


def test_localiser_names_a_parameter_that_is_no_number():
    with pytest.raises(SimError) as caught:
        Localiser(context("localiser", "pose", position_noise=math.nan, heading_noise=True))
    where = "robot robot1: sensor localiser on pose: parameter"
    assert str(caught.value).splitlines() == [
        f"{where} position_noise: must be a number at least 0 (got nan)",
        f"{where} heading_noise: must be a number at least 0 (got True)",
    ]
