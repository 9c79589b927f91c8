from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import LinkSetup
from rqt_mrta_py.model import Pose
from rqt_mrta_py.sim.radio import LossyLink
from tests.sim.radio.support import Chance, Scripted, link_setup


def lossy(random=None, places=None, **parameters) -> LossyLink:
    return LossyLink(link_setup(parameters, random, **(places or {})))


def test_link_without_parameters_delivers_once_and_at_once_without_chance():
    chance = Chance()
    assert list(lossy(chance).deliveries("r1", "r2", 5.0)) == [0.0]
    assert chance.asked == []


def test_link_delays_every_message():
    assert list(lossy(delay=0.25).deliveries("r1", "r2", 5.0)) == [0.25]


def test_jitter_is_exponential_with_its_mean():
    # 1 - exp(-t / mean) = 0.5 at t = mean ln 2.
    link = lossy(lambda *_: Scripted((0.0, 0.5, 0.0, 0.0)), delay=0.1, jitter=0.2)
    assert list(link.deliveries("r1", "r2", 0.0)) == [pytest.approx(0.1 + 0.2 * math.log(2.0))]


def test_mean_jitter_of_many_messages_is_the_parameter():
    link = lossy(jitter=0.1, reordering=True)
    delays = [link.deliveries("r1", "r2", 0.0)[0] for _ in range(4000)]
    # The mean of n exponential draws has the standard deviation mean / sqrt(n); five of them.
    assert np.mean(delays) == pytest.approx(0.1, abs=5 * 0.1 / math.sqrt(4000))
    assert np.std(delays) == pytest.approx(0.1, rel=0.15)


@pytest.mark.parametrize("loss", [0.05, 0.3, 0.9])
def test_share_of_lost_messages_lies_within_binomial_bounds(loss):
    link = lossy(loss=loss)
    sent = 4000
    lost = sum(1 for _ in range(sent) if not link.deliveries("r1", "r2", 0.0))
    assert abs(lost - sent * loss) < 5 * math.sqrt(sent * loss * (1 - loss))


@pytest.mark.parametrize(("loss", "arrive"), [(0.0, 200), (1.0, 0)])
def test_loss_of_nothing_or_everything_is_certain(loss, arrive):
    link = lossy(loss=loss, jitter=0.1)
    assert sum(len(link.deliveries("r1", "r2", 0.0)) for _ in range(200)) == arrive


def test_losses_of_two_messages_in_a_row_are_independent():
    link = lossy(loss=0.5)
    lost = [not link.deliveries("r1", "r2", 0.0) for _ in range(4000)]
    both = sum(1 for first, second in zip(lost[::2], lost[1::2]) if first and second)
    assert abs(both - 500) < 5 * math.sqrt(2000 * 0.25 * 0.75)


def test_link_with_more_loss_loses_what_one_with_less_loses():
    few, many = lossy(loss=0.2, delay=0.1), lossy(loss=0.4, jitter=0.1, duplicates=0.5)
    for _ in range(300):
        if not few.deliveries("r1", "r2", 0.0):
            assert not many.deliveries("r1", "r2", 0.0)
        else:
            many.deliveries("r1", "r2", 0.0)


def test_chance_of_a_pair_does_not_depend_on_other_pairs():
    alone, among = lossy(loss=0.5, jitter=0.1), lossy(loss=0.5, jitter=0.1)
    for step in range(200):
        for pair in (("r2", "r1"), ("r1", "r3"), ("r3", "r2")):
            among.deliveries(*pair, float(step))
        assert alone.deliveries("r1", "r2", float(step)) == among.deliveries("r1", "r2", float(step))


def test_generators_are_asked_for_when_a_pair_first_talks():
    chance = Chance()
    link = lossy(chance, loss=0.5)
    link.deliveries("r3", "r1", 0.0)
    link.deliveries("r3", "r1", 1.0)
    link.deliveries("r1", "r3", 1.0)
    assert chance.asked == [("r3", "r1"), ("r1", "r3")]


def test_duplicate_arrives_after_its_own_jitter():
    link = lossy(
        lambda *_: Scripted((0.0, 0.5, 0.1, 0.75), (0.0, 0.5, 0.3, 0.75)), delay=1.0, jitter=1.0, duplicates=0.2
    )
    assert list(link.deliveries("r1", "r2", 0.0)) == pytest.approx([1.0 + math.log(2.0), 1.0 + math.log(4.0)])
    assert len(link.deliveries("r1", "r2", 9.0)) == 1


def test_message_waits_for_those_sent_before_it():
    # The first takes 0.1 + ln 2 s, the second would take 0.1 s: it arrives with the first.
    draws = (0.0, 0.5, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)
    ordered = lossy(lambda *_: Scripted(*draws), delay=0.1, jitter=1.0)
    first, second = (ordered.deliveries("r1", "r2", now)[0] + now for now in (0.0, 0.2))
    assert first == second == pytest.approx(0.1 + math.log(2.0))
    free = lossy(lambda *_: Scripted(*draws), delay=0.1, jitter=1.0, reordering=True)
    assert free.deliveries("r1", "r2", 0.0)[0] == pytest.approx(0.1 + math.log(2.0))
    assert list(free.deliveries("r1", "r2", 0.2)) == [0.1]


@settings(max_examples=60, deadline=None)
@given(
    st.integers(0, 10**6),
    st.lists(st.floats(0.0, 5.0), min_size=1, max_size=30),
    st.floats(0.0, 100.0),
    st.sampled_from([0.0, 1e-9, 0.05, 30.0, 3600.0]),
)
def test_messages_of_a_pair_arrive_in_the_order_of_sending(seed, pauses, start, jitter):
    link = lossy(Chance(seed), loss=0.2, delay=0.05, jitter=jitter, duplicates=0.3)
    now, newest = start, -math.inf
    for pause in pauses:
        now += pause
        arrivals = [now + delay for delay in link.deliveries("r1", "r2", now)]
        assert arrivals == sorted(arrivals)
        assert all(arrival >= newest and arrival >= now for arrival in arrivals)
        newest = max([newest, *arrivals])


def test_messages_overtake_one_another_where_that_is_allowed():
    link = lossy(jitter=1.0, reordering=True)
    arrivals = [0.01 * step + link.deliveries("r1", "r2", 0.01 * step)[0] for step in range(50)]
    assert arrivals != sorted(arrivals)


def test_link_reaches_as_far_as_its_range():
    places = {"r1": (0.0, 0.0), "r2": (3.0, 4.0), "r3": (3.0, 4.001)}
    link = lossy(places=places, range=5.0)
    assert list(link.deliveries("r1", "r2", 0.0)) == [0.0]
    assert list(link.deliveries("r2", "r1", 0.0)) == [0.0]
    assert list(link.deliveries("r1", "r3", 0.0)) == []


def test_message_out_of_range_takes_its_numbers_all_the_same():
    """So a robot that comes near again has the chance that it would have had without the detour."""
    places = {"r1": Pose(0.0, 0.0), "r2": Pose(9.0, 0.0)}
    parameters = {"jitter": 0.1, "range": 2.0, "reordering": True}
    link = LossyLink(LinkSetup(("r1", "r2"), parameters, places.get, Chance()))
    everywhere = lossy(jitter=0.1, reordering=True)
    assert link.deliveries("r1", "r2", 0.0) == ()
    assert everywhere.deliveries("r1", "r2", 0.0) != ()
    places["r2"] = Pose(1.0, 0.0)
    assert link.deliveries("r1", "r2", 1.0) == everywhere.deliveries("r1", "r2", 1.0)


@pytest.mark.parametrize(
    ("parameters", "lines"),
    [
        ({"loss": 1.5}, ["loss: must be a number from 0 to 1 (got 1.5)"]),
        ({"loss": math.nan}, ["loss: must be a number from 0 to 1 (got nan)"]),
        ({"loss": True}, ["loss: must be a number from 0 to 1 (got True)"]),
        ({"delay": -0.1}, ["delay: must be a number from 0 to 3600 s (got -0.1)"]),
        ({"delay": 1e300}, ["delay: must be a number from 0 to 3600 s (got 1e+300)"]),
        ({"jitter": math.inf}, ["jitter: must be a number from 0 to 3600 s (got inf)"]),
        (
            {"jitter": 10**400},
            ["jitter: must be a number from 0 to 3600 s (got 1000000000000000000000000000000000000000"],
        ),
        ({"range": 0}, ["range: must be a number above 0 m (got 0)"]),
        ({"range": math.inf}, ["range: must be a number above 0 m (got inf)"]),
        ({"range": [1]}, ["range: must be a number above 0 m (got [1])"]),
        ({"reordering": 1}, ["reordering: must be true or false (got 1)"]),
        ({"los": 0.1}, ["los: is not known; nearest is 'loss'"]),
        ({3: 0.1}, ["3: is not known; accepted: loss, delay, jitter, reordering, duplicates, range"]),
        (
            {"loss": -1, "duplicates": "often", "lag": 1},
            [
                "duplicates: must be a number from 0 to 1 (got 'often'); YAML takes this for a text: no quotes, "
                "and a dot before an exponent, such as 1.0e-3",
                "lag: is not known; accepted: loss, delay, jitter, reordering, duplicates, range",
                "loss: must be a number from 0 to 1 (got -1)",
            ],
        ),
    ],
)
def test_link_refuses_parameters_that_it_cannot_work_with_all_at_once(parameters, lines):
    with pytest.raises(SimError) as caught:
        LossyLink(link_setup(parameters))
    told = str(caught.value).splitlines()
    assert len(told) == len(lines)
    assert all(one.startswith(line) for one, line in zip(told, lines))
