"""Numbers drawn ahead, against the same generators asked for all of their numbers at once."""

from __future__ import annotations

import numpy as np
import pytest

from rqt_mrta_py.sim.sensors.ahead import Ahead


@pytest.mark.parametrize("width", [1, 36, 200, 300])
def test_robot_gets_the_numbers_of_its_own_generator_in_order_however_often_others_measure(width):
    ahead = Ahead([np.random.default_rng(seed).standard_normal for seed in range(4)], width)
    expected = [np.random.default_rng(seed).standard_normal((40, width)) for seed in range(4)]
    measured = [0] * 4
    for turn in range(40):
        members = np.array([robot for robot in range(4) if turn % (robot + 1) == 0])
        for robot, numbers in zip(members.tolist(), ahead.take(members)):
            assert numbers.tolist() == expected[robot][measured[robot]].tolist()
            measured[robot] += 1
    assert measured == [40, 20, 14, 10]


@pytest.mark.parametrize(("width", "drawn"), [(1, 256), (36, 252), (200, 200), (300, 300)])
def test_about_256_numbers_are_drawn_at_once_and_whole_measurements(width, drawn):
    """The draws of several sensors of one robot alternate by these: changing them changes what a seed gives."""
    random, alike = np.random.default_rng(1), np.random.default_rng(1)
    Ahead([random.random], width).take(np.array([0]))
    alike.random(drawn)
    assert random.bit_generator.state == alike.bit_generator.state


def test_numbers_given_are_the_callers_own():
    ahead = Ahead([np.random.default_rng(2).random], 2)
    first = ahead.take(np.array([0]))
    first[:] = -1.0
    rest = [ahead.take(np.array([0])) for _ in range(5)]
    assert min(numbers.min() for numbers in rest) >= 0.0


def test_nobody_who_measures_draws_nothing():
    random, untouched = np.random.default_rng(1), np.random.default_rng(1)
    assert Ahead([random.random], 3).take(np.array([], dtype=np.intp)).shape == (0, 3)
    assert random.bit_generator.state == untouched.bit_generator.state
