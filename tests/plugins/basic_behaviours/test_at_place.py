from __future__ import annotations

import pytest
from basic_behaviours.go_to_place import GoToPlace
from basic_behaviours.report import Report

from rqt_mrta_py.hooks import BehaviourFactory
from rqt_mrta_py.model import Pose, Progress, Task
from tests.plugins.basic_behaviours.hall import CARRIER, Hall, Thing


@pytest.mark.parametrize("make", [GoToPlace, Report])
def test_with_a_detector_the_way_leads_around_lying_things(make: BehaviourFactory) -> None:
    things = {"can1": Thing("can", 5.0, 4.0), "can2": Thing("can", 7.0, 4.1)}
    hall = Hall(dict(things), Pose(2.0, 4.0), task=Task("go", "go", place=Pose(9.0, 4.0)), make=make)
    hall.start()
    assert hall.run(60.0).progress is Progress.DONE
    nearest = min(pose.distance(Pose(thing.x, thing.y)) for pose in hall.track for thing in things.values())
    # Things count as discs of 0.2 m; a margin of 0.1 m is wished for, of which driving may use some.
    assert nearest > CARRIER.radius + 0.2
