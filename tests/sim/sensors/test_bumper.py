from __future__ import annotations

from dataclasses import replace

import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Contact, SensorMoment
from rqt_mrta_py.model import LooseBody
from rqt_mrta_py.sim.sensors import Bumper
from tests.sim.doubles import StillWorld
from tests.sim.sensors.support import START, context


class Tight(StillWorld):
    """Where robots touch as they were told."""

    def __init__(self, *contacts: Contact, lacks=()) -> None:
        super().__init__(lacks=lacks)
        self._contacts = contacts

    def contacts(self):
        return self._contacts


@pytest.mark.parametrize(
    ("contacts", "touches"),
    [
        ([], False),
        ([Contact("robot1", "wall")], True),
        ([Contact("block", "robot1")], True),
        ([Contact("robot2", "wall"), Contact("robot10", "robot2")], False),
    ],
)
def test_bumper_tells_whether_its_own_robot_touches_something(contacts, touches):
    bumper = Bumper(context("bumper", "bump"))
    (outgoing,) = bumper.sense(SensorMoment(1.0, START, None, Tight(*contacts)))
    assert (outgoing.topic, outgoing.type, outgoing.fields) == ("bump", "std_msgs/Bool", {"data": touches})


@pytest.mark.parametrize(("other", "touches"), [("block", False), ("robot2", True), ("wall", True)])
def test_bumper_that_does_not_mind_bodies_feels_everything_else(other, touches):
    bodies = (LooseBody("block", START, size=(0.1, 0.1, 0.1)),)
    bumper = Bumper(replace(context("bumper", "bump", bodies=False), bodies=bodies))
    (outgoing,) = bumper.sense(SensorMoment(1.0, START, None, Tight(Contact(*sorted(("robot1", other))))))
    assert outgoing.fields == {"data": touches}


def test_bumper_has_no_other_parameters():
    with pytest.raises(SimError, match="robot robot1: sensor bumper on bump: parameter force: unknown"):
        Bumper(context("bumper", "bump", force=3.0))


def test_bumper_in_a_world_without_contacts_says_so():
    with pytest.raises(SimError, match="robot robot1: sensor bumper on bump: its world lacks contacts"):
        Bumper(context("bumper", "bump")).sense(SensorMoment(1.0, START, None, Tight(lacks=["contacts"])))
