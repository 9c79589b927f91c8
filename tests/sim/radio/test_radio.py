from __future__ import annotations

from itertools import product

import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.sim.radio import Radio

ROBOTS = ("r1", "r2", "r3", "r4")


class Deaf:
    """Loses everything."""

    def deliveries(self, sender, receiver, now):
        return ()


class Slow:
    """Takes a second for everything, twice."""

    def deliveries(self, sender, receiver, now):
        return (1.0, 1.0)


def reached(radio, names=ROBOTS):
    return {(a, b) for a, b in product(names, names) if a != b and radio.deliveries(a, b, 0.0)}


def test_radio_asks_its_link_between_robots_only():
    radio = Radio(Slow())
    assert radio.deliveries("r1", "r2", 0.0) == (1.0, 1.0)
    assert [radio.deliveries(*pair, 0.0) for pair in (("r1", "r1"), ("", "r1"), ("r1", ""), ("", ""))] == [(0.0,)] * 4


def test_radio_takes_another_link():
    radio = Radio(Slow())
    radio.link = Deaf()
    assert reached(radio) == set()
    assert reached(radio, ("r1", "")) == {("r1", ""), ("", "r1")}


def test_robot_whose_radio_failed_reaches_only_itself():
    radio = Radio(Slow())
    radio.set_failed("r2", failed=True)
    assert reached(radio, ("r1", "r2", "")) == {("r1", ""), ("", "r1")}
    assert radio.deliveries("r2", "r2", 0.0) == (0.0,)
    radio.set_failed("r2", failed=False)
    assert reached(radio) == {(a, b) for a, b in product(ROBOTS, ROBOTS) if a != b}


def test_robots_reach_those_of_their_group():
    radio = Radio(Slow())
    radio.partition([["r1", "r2"], ["r3"]])
    assert reached(radio) == {("r1", "r2"), ("r2", "r1")}
    assert reached(radio, ("r4", "")) == {("r4", ""), ("", "r4")}
    radio.heal()
    assert len(reached(radio)) == 12


def test_robot_of_two_groups_reaches_both():
    radio = Radio(Slow())
    radio.partition([["r1", "r2"], ["r2", "r3"]])
    assert reached(radio) == {("r1", "r2"), ("r2", "r1"), ("r2", "r3"), ("r3", "r2")}


def test_partition_replaces_the_one_before():
    radio = Radio(Slow())
    radio.partition([["r1", "r2"], ["r3", "r4"]])
    radio.partition([["r1", "r3"]])
    assert reached(radio) == {("r1", "r3"), ("r3", "r1")}


def test_partition_without_groups_silences_all():
    radio = Radio(Slow())
    radio.partition([])
    assert reached(radio) == set()


def test_partition_does_not_bring_back_a_failed_radio():
    radio = Radio(Slow())
    radio.partition([["r1", "r2"]])
    radio.set_failed("r1", failed=True)
    radio.heal()
    assert reached(radio, ("r1", "r2", "r3")) == {("r2", "r3"), ("r3", "r2")}


@pytest.mark.parametrize("answer", [None, 0.0, ["soon"], [-0.1], [float("nan")], iter([0.0])])
def test_link_that_answers_no_delays_is_named(answer):
    class Careless:
        def deliveries(self, sender, receiver, now):
            return answer

    with pytest.raises(SimError) as caught:
        Radio(Careless()).deliveries("robot1", "robot2", 1.0)
    assert str(caught.value) == (
        f"link Careless: answered {answer!r} for a message from 'robot1' to 'robot2'; "
        "delays of at least 0 s are accepted"
    )
