"""What robots were doing when, on a record made by hand."""

from __future__ import annotations

from rqt_mrta_py.model import (
    Allocation,
    MissionRecord,
    Outcome,
    RobotInterval,
    RobotRecord,
    RobotState,
    Taxonomy,
    Whereabouts,
)
from rqt_mrta_py.supervisor.whereabouts import TeamHistory

IDLE, BUSY, OFFLINE = RobotState.IDLE, RobotState.BUSY, RobotState.OFFLINE


def history() -> TeamHistory:
    """robot1 is idle from 1 to 4 s, busy to 8 s, silent to 10 s; it holds dig from 3 to 6 s, heap from 5 to 8 s."""
    states = (RobotInterval(IDLE, 1.0, 4.0), RobotInterval(BUSY, 4.0, 8.0), RobotInterval(OFFLINE, 8.0, 10.0))
    held = (
        Allocation("dig", "robot1", 3.0, 6.0, Outcome.DONE),
        Allocation("heap", "robot1", 5.0, 8.0, Outcome.LOST),
    )
    robots = (RobotRecord("robot1", states, 8.0),)
    return TeamHistory(MissionRecord(None, None, Taxonomy(), None, 0.0, 10.0, robots, (), held, (), ()))


def test_history_changes_with_states_and_with_what_is_held() -> None:
    assert history().between("robot1", 1.0, 10.0) == (
        Whereabouts("robot1", IDLE, (), 1.0, 3.0),
        Whereabouts("robot1", IDLE, ("dig",), 3.0, 4.0),
        Whereabouts("robot1", BUSY, ("dig",), 4.0, 5.0),
        Whereabouts("robot1", BUSY, ("dig", "heap"), 5.0, 6.0),
        Whereabouts("robot1", BUSY, ("heap",), 6.0, 8.0),
        Whereabouts("robot1", OFFLINE, (), 8.0, 10.0),
    )


def test_history_of_a_stretch_is_cut_at_both_ends() -> None:
    assert history().between("robot1", 4.5, 5.5) == (
        Whereabouts("robot1", BUSY, ("dig",), 4.5, 5.0),
        Whereabouts("robot1", BUSY, ("dig", "heap"), 5.0, 5.5),
    )


def test_what_a_robot_does_at_a_moment_is_what_begins_then() -> None:
    assert history().at("robot1", 4.0) == Whereabouts("robot1", BUSY, ("dig",), 4.0, 5.0)


def test_nothing_is_known_of_a_robot_before_its_first_state_nor_of_one_never_seen() -> None:
    assert history().at("robot1", 0.5) == Whereabouts("robot1", None, (), 0.5, 1.0)
    assert history().between("robot9", 2.0, 3.0)[0].state is None
