"""One property for each module of ALLIANCE (section 3 of the dissertation): bounds, monotony, resets.

Sensory feedback has its own beside the readers of sensors.
"""

from __future__ import annotations

import math
from typing import Dict, List, Sequence, Tuple

from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mrta_alliance import equations
from mrta_alliance.equations import Announcements
from mrta_alliance.history import History
from mrta_alliance.timing import StandingInhibition

from tests.plugins.mrta_alliance.team import agent, announced, behaviour_set, motivations, nested, step, time_of

TAU, THETA, FAST = 2.0, 30.0, 1.5
now_or_before = st.floats(0.1, 500.0)
announcing = st.lists(
    st.builds(
        lambda times, patience: Announcements(tuple(sorted(times)), min(times), patience),
        st.lists(now_or_before, min_size=1, max_size=6),
        st.floats(1.0, 300.0),
    ),
    max_size=4,
)


@given(st.lists(st.tuples(st.sampled_from("abcd"), st.booleans()), max_size=30))
def test_suppression_strikes_exactly_while_another_set_is_active(story: List[Tuple[str, bool]]) -> None:
    inhibition, active = StandingInhibition(), dict.fromkeys("abcd", False)
    for task, is_active in story:
        inhibition.note(task, is_active)
        active[task] = is_active
        for each in active:
            assert inhibition.inhibits(each) is any(active[other] for other in active if other != each)


@given(
    st.lists(st.tuples(st.sampled_from(["two", "three"]), st.floats(0.0, 3.0)), min_size=1, max_size=40),
    st.floats(0.0, 10.0),
)
def test_communication_with_history_answers_as_if_it_kept_everything(
    story: List[Tuple[str, float]], span: float
) -> None:
    """For all windows that the equations ask for: the last tau, and from the beginning; horizon 5 s."""
    history, everything, now = History(5.0), {}, 0.0
    for robot, passed in story:
        now += passed
        history.remember(robot, announced(robot, "patrol", now), now)
        everything.setdefault(robot, []).append(now)
    now += span
    for other, times in zip(history.others(), everything.values()):
        assert other.received(now - TAU, now) is equations.received(times, now - TAU, now)
        assert other.received(0.0, now - span) is equations.received(times, 0.0, now - span)
        assert len(other.times) <= len(times)


@given(st.lists(st.lists(st.sampled_from(["two", "three", "four"]), max_size=4), max_size=40))
def test_each_other_robot_resets_a_set_once(story: List[List[str]]) -> None:
    """In the cycle in which it is heard for the first time, and never again."""
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    known: set = set()
    for cycle, robots in enumerate(story, start=1):
        now = time_of(cycle)
        said = motivations(step(one, now, [announced(robot, "patrol", now) for robot in robots]))["patrol"]
        assert said["resetted"] is bool(set(robots) - known)
        assert not said["resetted"] or said["motivation"] == 0.0
        known |= set(robots)


@given(announcing, st.floats(0.0, 400.0), st.floats(0.0, 50.0), st.floats(0.1, 100.0), st.floats(0.0, 20.0))
def test_acquiescence_needs_time_and_once_it_gives_up_it_stays(
    others: Sequence[Announcements], since: float, yielding: float, giving_up: float, more: float
) -> None:
    """Not before the shorter delay, always after lambda; without anybody heard only by lambda."""

    def answer(now: float, heard: Sequence[Announcements]) -> bool:
        return equations.acquiescent(heard, since, now, timeout=TAU, yielding_delay=yielding, giving_up_delay=giving_up)

    assert not answer(since + min(yielding, giving_up), others)
    assert answer(since + giving_up + 0.001 + more, others)
    assert answer(since + more, []) is equations.active_for(giving_up, since, since + more)
    assert answer(since + more, others) or not answer(since + more, [])


@given(announcing, now_or_before)
def test_impatience_is_bounded_by_fast_rate_and_the_slowest_robot(others: Sequence[Announcements], now: float) -> None:
    value = equations.impatience(others, now, TAU, THETA, FAST)
    slow = [THETA / other.patience for other in others]
    assert min([FAST, *slow]) <= value <= FAST
    if not any(other.received(now - TAU, now) for other in others):
        assert value == FAST
    # Whoever else is heard can only slow down, and only until phi is over.
    assert value <= equations.impatience(others[1:], now, TAU, THETA, FAST)
    longest = max((other.patience for other in others), default=0.0)
    assert equations.impatience(others, 500.1 + longest, TAU, THETA, FAST) == FAST


@given(st.lists(st.tuples(st.booleans(), st.booleans(), st.booleans(), st.booleans(), st.floats(0.01, 9.0))))
def test_motivation_grows_by_impatience_or_falls_to_zero(story: list) -> None:
    value = 0.0
    for applicable, inhibited, is_reset, acquiescent, growth in story:
        before = value
        value = equations.motivation(
            before,
            growth,
            is_applicable=applicable,
            is_inhibited=inhibited,
            is_reset=is_reset,
            is_acquiescent=acquiescent,
            threshold=THETA,
        )
        strikes = not applicable or inhibited or is_reset or acquiescent
        assert value == (0.0 if strikes else min(THETA, before + growth))


@given(st.floats(0.0, 30.0), st.floats(0.0, 30.0))
def test_threshold_is_met_by_it_and_by_nothing_below(lower: float, higher: float) -> None:
    """And whoever is active stays so with more motivation."""
    assume(lower <= higher)
    assert equations.active(THETA, THETA)
    assert equations.active(higher, THETA) or not equations.active(lower, THETA)
    assert equations.active(lower, THETA) is (lower == THETA)


moments = st.lists(
    st.tuples(st.sampled_from(["", "two", "three"]), st.booleans(), st.sampled_from([20.0, 60.0, 240.0])), max_size=120
)


@settings(max_examples=40, deadline=None)
@given(moments, st.sampled_from([0.5, 2.0, 64.0]))
def test_normalised_form_decides_alike(story: list, threshold: float) -> None:
    """Equations 3.11 and 3.12: with theta = 1 and rates divided by theta everything but the scale is the same.

    Thresholds are powers of two, so that dividing is exact.
    """

    def tell(theta: float) -> List[Dict[str, Tuple]]:
        sets = [
            behaviour_set(task, rate * theta, threshold=theta) for task, rate in (("patrol", 0.25), ("inspect", 0.125))
        ]
        one = agent("one", nested(*sets), ["patrol", "inspect"])
        told = []
        for cycle, (sender, possible, expected) in enumerate(story, start=1):
            now = time_of(cycle)
            heard = [announced(sender, "patrol", now, expected)] if sender else []
            decision = step(one, now, heard, impossible=() if possible else ("inspect",))
            (message,) = (m for m in decision.messages if m.topic.endswith("time_to_activation"))
            until = [None if math.isnan(each) else each for each in message.fields["seconds"]]
            said = [
                (each["motivation"] / theta, each["impatience"] / theta, each["active"], each["resetted"])
                for each in motivations(decision).values()
            ]
            told.append({"task": (decision.task,), "said": tuple(said), "until": tuple(until)})
        return told

    assert tell(threshold) == tell(1.0)


@given(st.floats(0.0, 29.0), st.floats(0.01, 5.0), st.floats(0.5, 50.0))
def test_time_to_activation_falls_with_motivation_impatience_and_spin_rate(
    value: float, growth: float, rate: float
) -> None:
    def until(motivation: float, impatience: float, spin_rate: float) -> float:
        return equations.time_to_activation(motivation, impatience, THETA, spin_rate, is_blocked=False)

    seconds = until(value, growth, rate)
    assert seconds > 0.0
    assert until(value + 0.5, growth, rate) < seconds
    assert until(value, growth * 1.5, rate) < seconds
    assert until(value, growth, rate * 1.5) < seconds
    cycles = seconds * rate
    assert value + cycles * growth >= THETA - 1e-6
