"""What is held back until it is its turn, and how a watcher cuts a live stream into ticks."""

from __future__ import annotations

from typing import List, Sequence, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.live.hold_back import SIMULATION, HoldBack, agent_node
from rqt_mrta_py.app.live.tick_messages import Said, TickDone, TickNews
from rqt_mrta_py.app.live.tick_stream import TickStream
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.hooks import Connection, Stamped

R1, R2 = agent_node("r1"), agent_node("r2")
CLOCK = Said(SIMULATION, "/clock")
S = 1_000_000_000


def said(caller: str, topic: str, text: str, receipt: float = 0.0) -> Stamped:
    return Stamped(
        Connection(topic, "std_msgs/String", "0" * 32, "string data", caller), round(receipt * S), text.encode()
    )


def texts(messages: Sequence[Stamped]) -> List[str]:
    return [each.raw.decode() for each in messages]


WORDS = st.lists(st.tuples(st.sampled_from([R1, R2, SIMULATION]), st.sampled_from(["/a", "/b"])), max_size=12)


@given(WORDS, st.randoms(use_true_random=False))
def test_whatever_order_messages_arrive_in_they_are_heard_in_that_of_the_manifest(
    words: List[Tuple[str, str]], chance: object
) -> None:
    """Only what one node says on one topic keeps its order on the way."""
    hold_back = HoldBack(["r1", "r2"])
    numbered = [said(caller, topic, str(number)) for number, (caller, topic) in enumerate(words)]
    lanes = [
        [each for each in numbered if (each.connection.caller, each.connection.topic) == lane] for lane in set(words)
    ]
    hold_back.expect([Said(*word) for word in words])
    while any(lanes):
        assert hold_back.missing
        lane = chance.choice([lane for lane in lanes if lane])  # type: ignore[attr-defined]
        hold_back.put(lane.pop(0))
    assert hold_back.missing == ()
    turn = hold_back.take(1, 2)
    by_agents = [str(number) for number, (caller, _) in enumerate(words) if caller != SIMULATION]
    by_world = [str(number) for number, (caller, _) in enumerate(words) if caller == SIMULATION]
    assert texts(turn.agents) == by_agents
    assert texts(turn.events) == by_world
    assert {each.receipt_ns for each in turn.agents} <= {1}
    assert {each.receipt_ns for each in turn.events} <= {2}


def test_what_an_agent_says_early_waits_for_the_next_manifest() -> None:
    hold_back = HoldBack(["r1"])
    hold_back.put(said(R1, "/a", "tick 0"))
    hold_back.put(said(R1, "/a", "tick 1"))
    hold_back.expect([Said(R1, "/a"), CLOCK])
    assert hold_back.missing == (CLOCK,)
    hold_back.put(said(SIMULATION, "/clock", "1"))
    assert texts(hold_back.take(0, 1).agents) == ["tick 0"]
    hold_back.expect([Said(R1, "/a")])
    assert texts(hold_back.take(1, 2).agents) == ["tick 1"]


def test_drivers_speak_through_the_simulation_and_keep_their_names() -> None:
    hold_back = HoldBack(["r1"])
    hold_back.put(said(SIMULATION, "/tf", "pose of r1"))
    hold_back.expect([CLOCK, Said("/r1/driver", "/tf")])
    hold_back.put(said(SIMULATION, "/clock", "1"))
    turn = hold_back.take(0, 1)
    assert [each.connection.caller for each in turn.senses] == [SIMULATION, "/r1/driver"]


def test_strangers_are_heard_after_all_others_and_need_no_manifest() -> None:
    hold_back = HoldBack(["r1"])
    hold_back.put(said("/stranger", "/a", "hello"))
    hold_back.expect([Said(R1, "/a")])
    hold_back.put(said(R1, "/a", "mine"))
    turn = hold_back.take(3, 4)
    assert (texts(turn.agents), texts(turn.others), turn.others[0].receipt_ns) == (["mine"], ["hello"], 4)


def test_what_an_absent_agent_said_last_is_heard_like_a_strangers() -> None:
    """It was never announced, so it must not be taken for what its successor says."""
    hold_back = HoldBack(["r1"])
    hold_back.put(said(R1, "/a", "last words"))
    hold_back.expect([], absent=["r1"])
    assert texts(hold_back.take(0, 1).others) == ["last words"]
    hold_back.expect([Said(R1, "/a")])
    assert hold_back.missing == (Said(R1, "/a"),)


def test_what_is_not_heard_here_is_not_waited_for() -> None:
    hold_back = HoldBack(["r1"], hears=lambda topic: topic == "/a")
    hold_back.expect([CLOCK, Said(SIMULATION, "/b"), Said(SIMULATION, "/a")])
    assert hold_back.missing == (Said(SIMULATION, "/a"),)
    hold_back.put(said(SIMULATION, "/a", "heard"))
    assert texts(hold_back.take(0, 1).senses) == ["heard"]


def test_a_free_stream_is_cut_where_ticks_are_told_and_its_time_never_goes_back() -> None:
    """Ten ticks a second; mission second s carries stamp s + 1."""
    stream = TickStream(["r1"], RunClock(10), lock_step=False)
    stream.hear(said(SIMULATION, "/a", "before any clock", 0.0))
    stream.begin(TickNews(0, 1.0))
    stream.hear(said(R1, "/a", "late", 1.1))
    stream.hear(said(R1, "/a", "told before its tick", 1.3))
    stream.begin(TickNews(1, 1.1))
    stream.hear(said(R1, "/a", "behind", 1.0))
    stream.begin(TickNews(2, 1.2, over=True))
    cuts = [stream.cut() for _ in range(4)]
    assert cuts[3] is None
    found = [
        (texts(cut.before), [each.receipt_ns for each in cut.before], cut.ends, cut.over) for cut in cuts[:3] if cut
    ]
    assert found == [
        (["before any clock"], [S], 0, False),
        (["late", "told before its tick"], [S + S // 10, S + S // 10], 1, False),
        (["behind"], [S + S // 10], None, True),
    ]


def test_in_lock_step_a_tick_ends_when_what_was_said_in_it_has_been_told() -> None:
    stream = TickStream(["r1"], RunClock(10), lock_step=True)
    stream.begin(TickNews(0, 1.0, lock_step=True, manifest=(CLOCK,)))
    assert stream.cut() is None
    stream.hear(said(SIMULATION, "/clock", "now"))
    first = stream.cut()
    stream.begin(TickNews(1, 1.1, lock_step=True, over=True, manifest=(Said(R1, "/a"),)))
    assert stream.cut() is None
    assert stream.missing == (Said(R1, "/a"),)
    stream.hear(said(R1, "/a", "done"))
    second = stream.cut()
    assert first is not None
    assert second is not None
    assert (first.before, first.ends, texts(first.after), first.over) == ((), None, ["now"], False)
    assert (texts(second.before), second.ends, second.after, second.over) == (["done"], 0, (), True)


@pytest.mark.parametrize(
    "value",
    [
        TickNews(
            7, 1.35, True, False, frozenset({"r2"}), {"r1": -0.5}, frozenset({"r3"}), (Said("/r1/driver", "/tf"), CLOCK)
        ),
        TickNews(8, 1.4, over=True),
        TickDone(7, "r1", ("/r1/cmd_vel", "/a", "/a")),
    ],
)
def test_what_is_told_of_ticks_comes_through_as_it_was(value: object) -> None:
    codec = compose().codec()
    message = value.message()  # type: ignore[attr-defined]
    connection = codec.connection(message.topic, message.type)
    fields = codec.decode(connection, codec.encode(message.type, message.fields))
    assert type(value).of(fields) == value  # type: ignore[attr-defined]
