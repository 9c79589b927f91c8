"""The contingency table: what a robot observes and what it does; and every reason for which it withdraws."""

from __future__ import annotations

from typing import List

import pytest
from mrta_demir_cf.message_kinds import CancelReason, Kind, WarnedState
from mrta_demir_cf.robot_states import RobotBelief
from mrta_demir_cf.task_states import TaskBelief, TaskEvent

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Pose, Progress, Task
from tests.plugins.mrta_demir_cf.script import ME, Script, kinds

B = TaskBelief
NEAR = {"t": (4.0, 0.0)}
TWO = {"t": (4.0, 0.0), "u": (0.0, 6.0)}


def test_unknown_robot_is_added_and_counts_in_rough_schedules() -> None:
    script = Script(NEAR)
    script.step(script.hello("stranger", (4.0, 1.0)))
    assert script.wait(3.0, "stranger") == []
    assert script.agent.mind.robots["stranger"].belief is RobotBelief.IDLE


def test_robot_that_has_not_said_where_it_is_is_left_out_of_rough_schedules() -> None:
    script = Script(NEAR)
    script.step(script.hello("a", (float("nan"), 0.0)))
    assert kinds(script.wait(1.0)) == [Kind.REQUEST]


def test_robot_that_falls_silent_leaves_its_cell_and_gets_it_back_when_it_is_heard_again() -> None:
    script = Script(TWO)
    script.step(script.hello("a", (0.0, 5.0)))
    said = script.wait(9.0)
    assert [message.task for message in said if message.kind is Kind.REQUEST] == ["t"]
    assert script.agent.mind.robots["a"].belief is RobotBelief.FAILED
    said = script.step(script.hello("a"), reports=[script.done("t")])
    assert kinds(said) == [Kind.COMPLETION]
    assert script.agent.mind.robots["a"].belief is RobotBelief.IDLE
    assert script.wait(6.0, "a") == []


def test_tasks_of_a_robot_that_has_failed_are_uncertain_at_once() -> None:
    """Awarded 2 s before a falls silent, so that its own time is not over when a's is."""
    script = Script(NEAR)
    script.step(script.hello("a", (4.0, 1.0)))
    script.wait(5.0)
    script.step(script.award("c", "t", "a"))
    script.wait(2.0, "c")
    assert script.agent.mind.robots["a"].belief is RobotBelief.FAILED
    assert script.state("t") in (B.UNCERTAIN, B.REQUESTED)


def test_task_that_never_moves_on_is_passed_over_by_a_nearer_robot_that_has_been_idle_too_long() -> None:
    """a cannot carry t out, whatever the reason; it is there, and does nothing."""
    script = Script(NEAR)
    script.step(script.hello("a", (4.0, 1.0)))
    assert script.wait(6.0, "a") == []
    assert kinds(script.wait(3.0, "a"))[0] is Kind.REQUEST


def test_robot_that_carries_out_what_never_ends_leaves_its_cell_to_others() -> None:
    script = Script(NEAR)
    script.step(script.execution("a", "guard", 0.0, (4.0, 1.0), perpetual=True))
    assert kinds(script.wait(1.0)) == [Kind.REQUEST]


def test_one_correction_goes_to_one_robot_about_one_task_in_a_heartbeat() -> None:
    script = Script(NEAR).executing()
    script.step(script.completion("a", "t"))
    said = script.step(script.request("c", "t", 1.0), script.execution("c", "t", 1.0), script.bid("d", "t", 1.0))
    assert [(message.kind, message.recipient) for message in said] == [(Kind.WARNING, "c"), (Kind.WARNING, "d")]
    for _ in range(3):
        assert script.step(script.request("c", "t", 1.0)) == []
    assert kinds(script.step(script.request("c", "t", 1.0))) == [Kind.WARNING]


def test_bid_that_goes_astray_is_told_who_holds_the_task() -> None:
    script = Script(NEAR)
    script.step(script.execution("a", "t", 1.0, (4.0, 1.0)))
    (warning,) = script.step(script.bid("c", "t", 0.5))
    assert (warning.recipient, warning.state, warning.holder) == ("c", WarnedState.EXECUTING, "a")


def test_robot_whose_map_is_newer_refutes_that_a_task_cannot_be_reached_once() -> None:
    script = Script(NEAR, retry=0.0).executing()
    script.costs["t"] = None
    script.step(reports=[script.report("t", Progress.UNREACHABLE, ME)])
    stamp = script.now
    script.costs["t"] = 4.0
    script.wait(3.5)
    assert script.state("t") in (B.REQUESTED, B.EXECUTING)
    for expected in ([Kind.NEW_TASK], [], []):
        said = script.step(script.warning("a", "t", "unachievable", at=stamp))
        assert [kind for kind in kinds(said) if kind is not Kind.EXECUTION] == expected
    assert script.state("t") is B.EXECUTING


def test_message_for_another_robot_is_not_heard() -> None:
    script = Script(NEAR).executing()
    script.step(script.completion("a", "t"))
    assert script.step(script.message("c", Kind.BID, "t", recipient="a", cost=1.0)) == []


def test_message_in_its_own_name_is_not_heard() -> None:
    script = Script(NEAR).executing()
    assert script.step(script.completion(ME, "t")) == []
    assert script.carried_out == "t"


def test_message_that_comes_twice_or_late_counts_once() -> None:
    script = Script(TWO).executing()
    old = script.request("c", "u", 1.0)
    script.step(script.cancellation("c", "u"), old)
    assert script.state("u") is B.INITIAL


def test_award_goes_to_nobody_who_has_failed_meanwhile() -> None:
    """reply_timeout 8 s, so that a, which bids at once, is silent for longer than T_exec before it ends."""
    script = Script(NEAR, reply_timeout=8.0, heartbeat=2.0, execution_timeout=7.0 + 5.0, request_timeout=10.0)
    script.wait(8.5)
    script.step(script.bid("a", "t", 3.0), script.bid("c", "t", 3.5))
    script.agent.mind.robots["a"].heard = -10.0
    said = script.wait(8.0, "c")
    assert [message.winner for message in said if message.kind is Kind.AWARD] == ["c"]


def test_task_that_moved_is_where_it_is_said_to_be() -> None:
    script = Script(TWO).executing()
    script.places["t"] = (0.0, -2.0)
    moved = Task("t", "visit", Pose(0.0, -2.0))
    script.step(reports=[script.report("t", Progress.APPEARED, definition=moved)])
    assert script.agent.mind.tasks["t"].place == (0.0, -2.0)
    assert script.carried_out == "t"


def test_task_that_is_withdrawn_is_over_without_a_word() -> None:
    script = Script(TWO).executing()
    said = script.step(reports=[script.report("t", Progress.WITHDRAWN)])
    assert [(message.kind, message.task) for message in said] == [(Kind.REQUEST, "u")]
    assert script.state("t") is B.COMPLETED


def test_task_that_comes_back_is_a_new_one() -> None:
    script = Script(NEAR).executing()
    script.step(reports=[script.done("t")])
    assert script.wait(3.0) == []
    assert kinds(script.step(reports=[script.report("t", Progress.APPEARED)])) == [Kind.REQUEST]


def test_task_that_came_back_is_not_taken_for_done_because_it_once_was() -> None:
    script = Script(NEAR).executing()
    script.step(reports=[script.done("t")])
    long_ago = script.now
    script.wait(2.0)
    script.step(reports=[script.report("t", Progress.APPEARED)])
    script.step(script.warning("a", "t", "completed", at=long_ago))
    assert script.state("t") is B.REQUESTED
    script.step(script.warning("a", "t", "completed", at=script.now))
    assert script.state("t") is B.COMPLETED


def test_completion_that_was_lost_is_told_with_the_next_word() -> None:
    script = Script(TWO).executing()
    script.step(reports=[script.done("t")])
    script.wait(1.0)
    (execution,) = [message for message in script.said if message.kind is Kind.EXECUTION and message.task == "u"]
    assert execution.completed == "t"
    listener = Script(TWO)
    listener.step(listener.execution("c", "t", 1.0))
    listener.speaker("c").completed = "t"
    listener.step(listener.hello("c"))
    assert listener.state("t") is B.COMPLETED


def test_robot_without_handling_tells_a_completion_once() -> None:
    script = Script(TWO, handling=False).executing()
    script.step(reports=[script.done("t")])
    script.wait(1.0)
    assert {message.completed for message in script.said} == {""}


def test_task_that_came_back_is_not_told_to_be_done_any_more() -> None:
    script = Script(NEAR).executing()
    script.step(reports=[script.done("t")])
    script.step(reports=[script.report("t", Progress.APPEARED)])
    assert script.said[-1].completed == ""
    script.speaker("a").completed = "t"
    script.step(script.hello("a"))
    assert script.state("t") is B.REQUESTED


def test_what_another_robots_host_reports_counts_like_its_message() -> None:
    script = Script(TWO).executing()
    script.step(reports=[script.report("t", Progress.DONE, "a")])
    assert (script.state("t"), kinds(script.said[-1:])) == (B.COMPLETED, [Kind.REQUEST])
    script.step(reports=[script.report("u", Progress.FAILED, "a")])
    assert script.state("u") is B.UNACHIEVABLE


def test_robot_that_did_what_it_had_let_go_tells_all() -> None:
    script = Script(NEAR).executing()
    script.step(script.execution("a", "t", 1.0))
    assert script.state("t") is B.EXECUTING_OTHER
    assert kinds(script.step(reports=[script.done("t")])) == [Kind.COMPLETION]


def test_operator_gives_a_task_before_all_costs_and_it_stays() -> None:
    script = Script(TWO, exchange=True, gives_way=True).executing()
    said = script.step(reports=[script.report("u", Progress.REASSIGNED, ME)])
    assert [(message.kind, message.task) for message in said] == [(Kind.CANCELLATION, "t"), (Kind.EXECUTION, "u")]
    assert (said[0].reason, said[1].ordered) == (CancelReason.OPERATOR, True)
    claims: List[Heard] = [
        script.request("a", "u", 0.1),
        script.execution("a", "u", 0.1),
        script.message("a", Kind.EXCHANGE, "u", recipient=ME, cost=0.1),
        script.request("a", "t", 0.1),
    ]
    for claim in claims:
        assert set(kinds(script.step(claim))) <= {Kind.EXECUTION}
        assert script.carried_out == "u"


def test_operator_may_give_what_another_executes_and_what_could_not_be_reached() -> None:
    script = Script(NEAR, retry=0.0)
    script.step(script.execution("a", "t", 1.0))
    script.step(reports=[script.report("t", Progress.REASSIGNED, ME)])
    assert script.carried_out == "t"
    script.step(reports=[script.report("t", Progress.UNREACHABLE, ME)])
    script.step(reports=[script.report("t", Progress.REASSIGNED, ME)])
    assert script.carried_out == "t"


def test_order_that_cannot_be_obeyed_is_withdrawn() -> None:
    script = Script(TWO).executing()
    script.applicable["u"] = False
    said = script.step(reports=[script.report("u", Progress.REASSIGNED, ME)])
    assert [(message.kind, message.task) for message in said][:2] == [
        (Kind.CANCELLATION, "t"),
        (Kind.CANCELLATION, "u"),
    ]


def test_operator_who_gives_the_robots_task_to_another_recalls_it() -> None:
    script = Script(NEAR).executing()
    said = script.step(reports=[script.report("t", Progress.REASSIGNED, "c")])
    assert [(message.kind, message.reason) for message in said] == [(Kind.CANCELLATION, CancelReason.OPERATOR)]
    assert (script.state("t"), script.holder("t"), script.carried_out) == (B.REQUESTED_OTHER, "c", None)
    script.step(script.request("a", "t", 0.0))
    assert script.holder("t") == "c"


def test_operator_who_gives_it_to_nobody_lets_it_be_auctioned_anew() -> None:
    script = Script(NEAR).executing()
    assert kinds(script.step(reports=[script.report("t", Progress.REASSIGNED)])) == [Kind.CANCELLATION, Kind.REQUEST]


def test_cost_that_rises_makes_the_robot_look_for_something_else() -> None:
    script = Script(TWO).executing()
    script.costs["t"] = 9.0
    said = script.wait(2.0)
    assert [(message.kind, message.task) for message in said] == [
        (Kind.EXECUTION, "t"),
        (Kind.CANCELLATION, "t"),
        (Kind.REQUEST, "u"),
    ]
    assert said[1].reason is CancelReason.IMPROVED


def test_robot_that_is_overdue_estimates_anew_and_says_so() -> None:
    """4 m at 1 m/s, twice as long: due 8 s after it set out; without that, the next word were at 8 s, not at 8.5."""
    script = Script(NEAR, speed=1.0, heartbeat=2.0).executing()
    said = script.wait(8.0)
    assert kinds(said) == [Kind.EXECUTION] * 4
    assert kinds(script.step()) == [Kind.EXECUTION]


def test_robot_that_waits_for_an_award_requests_nothing_else_meanwhile() -> None:
    script = Script(TWO)
    script.step(script.hello("a", (4.0, 1.0)), script.hello("c", (0.0, 7.0)))
    script.wait(1.0)
    assert kinds(script.step(script.request("a", "t", 9.0), script.hello("c", (0.0, 60.0)))) == [Kind.BID]
    assert script.wait(1.5) == []
    assert kinds(script.step()) == [Kind.REQUEST]


def test_literal_award_is_taken_only_with_an_empty_schedule() -> None:
    script = Script(TWO, literal_award=True)
    script.step(script.hello("a", (4.0, 1.0)))
    script.wait(0.5)
    assert script.agent.mind.schedule == ()
    script.step(script.award("a", "t", ME))
    assert script.carried_out == "t"
    script = Script(TWO, literal_award=True)
    script.step(script.hello("a", (4.0, 1.0)))
    script.requested()
    (refusal,) = script.step(script.request("a", "u", 1.0), script.award("a", "t", ME))
    assert refusal.reason is CancelReason.AWARD_REFUSED


@pytest.mark.parametrize("objective", ["path", "time"])
def test_path_robot_begins_nothing_dearer_than_what_another_carries_out(objective: str) -> None:
    script = Script(NEAR, objective=objective)
    script.step(script.execution("c", "z", 3.0))
    said = script.wait(3.0, "c")
    assert bool(said) == (objective == "time")
    if not said:
        assert kinds(script.step(script.completion("c", "z"))) == [Kind.REQUEST]


@pytest.mark.parametrize("rival", ["a", "c"])
def test_of_two_robots_that_request_at_one_cost_one_goes_however_their_costs_waver(rival: str) -> None:
    script = Script(TWO, objective="path", gives_way=True).requested()
    script.costs["t"] = 4.1
    script.step(script.request(rival, "u", 4.0))
    assert script.state("t") is (B.INITIAL if rival == "a" else B.REQUESTED)


def without_handling() -> Script:
    return Script(NEAR, handling=False).executing()


@pytest.mark.parametrize("claim", ["request", "cheap request", "execution", "award", "bid"])
def test_robot_without_handling_neither_answers_nor_yields(claim: str) -> None:
    script = without_handling()
    heard = {
        "request": script.request("a", "t", 3.9),
        "cheap request": script.request("a", "t", 0.1),
        "execution": script.execution("a", "t", 0.1),
        "award": script.award("a", "t", "c"),
        "bid": script.bid("a", "t", 0.1),
    }[claim]
    assert script.step(heard) == []
    assert script.carried_out == "t"


def test_robot_without_handling_warns_nobody_but_still_waits_for_others_in_vain() -> None:
    script = without_handling()
    script.step(script.completion("a", "t"))
    assert script.step(script.request("c", "t", 1.0)) == []
    script = Script(NEAR, handling=False)
    script.step(script.execution("a", "t", 1.0))
    assert kinds(script.wait(8.0)) == [Kind.REQUEST]


def test_change_that_the_table_does_not_allow_is_counted_and_told_once_and_not_carried_out() -> None:
    script = Script(NEAR).executing()
    mind = script.agent.mind
    for _ in range(2):
        assert mind.change(mind.tasks["t"], TaskEvent.AUCTION_WON) is None
    assert (mind.contradictions, script.state("t")) == (2, B.EXECUTING)
    (notice,) = mind.take_notices()
    assert notice == "task=t state=executing event='deadline, and nobody bid less' change=refused"


def test_scripts_above_made_no_contradiction() -> None:
    """A robot that is told everything at once, in every order, decides nothing that its table does not allow."""
    for first in range(9):
        script = Script(TWO, exchange=True, gives_way=True)
        for step in range(24):
            heard = [
                script.request("a", "t", 3.0),
                script.execution("c", "t", 2.0),
                script.award("a", "t", ME),
                script.bid("c", "u", 1.0),
                script.cancellation("c", "t"),
                script.warning("a", "u", "executing", holder="c", cost=1.0),
                script.unachievability("a", "u", float(step)),
                script.message("c", Kind.NEW_TASK, "u", place=(0.0, 6.0), map_stamp=step + 0.5),
                script.message("a", Kind.EXCHANGE, "u", recipient=ME, cost=0.5),
            ]
            script.step(*heard[first:], *heard[: step % 9])
        script.step(script.completion("c", "t"))
        assert script.agent.mind.contradictions == 0
        assert script.state("t") is B.COMPLETED


REASONS = {
    "a": CancelReason.DEARER_REQUEST,
    "b": CancelReason.DEARER_NEIGHBOUR,
    "c": CancelReason.CHANGED_SCHEDULE,
    "d": CancelReason.IMPROVED,
    "e": CancelReason.PARALLEL,
    "f": CancelReason.HANDED_OVER,
    "g": CancelReason.AWARD_REFUSED,
    "h": CancelReason.FAILURE,
    "i": CancelReason.OPERATOR,
}


@pytest.mark.parametrize("letter", REASONS)
def test_every_reason_to_withdraw_is_given(letter: str) -> None:
    path = Script(TWO, gives_way=True, objective="path" if letter == "a" else "time").executing()
    makers = {
        "a": lambda: path.step(path.request("c", "u", 3.0)),
        "b": lambda: path.step(path.request("a", "u", 3.0, (0.0, 7.0))),
        "c": lambda: path.applicable.update(t=False) or path.step(),
        "d": lambda: path.costs.update(t=9.0) or path.wait(2.0),
        "e": lambda: path.step(path.execution("a", "t", 1.0)),
        "f": lambda: path.step(path.request("a", "t", 1.0)),
        "g": lambda: path.step(path.award("a", "u", ME)),
        "h": lambda: setattr(path, "now", path.now + 9.0) or path.step(),
        "i": lambda: path.step(reports=[path.report("t", Progress.REASSIGNED)]),
    }
    said = makers[letter]()
    assert [message.reason for message in said if message.kind is Kind.CANCELLATION] == [REASONS[letter]]
    assert set(REASONS.values()) == set(CancelReason)
