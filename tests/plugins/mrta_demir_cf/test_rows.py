"""Every row of the table of task states, reached by what a robot hears, by the numbers of docs/architectures."""

from __future__ import annotations

import re
from typing import Callable, Dict

import pytest
from mrta_demir_cf.message_kinds import CancelReason, Kind, WarnedState
from mrta_demir_cf.task_states import TASK_ROWS, TaskBelief

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Progress
from tests.plugins.mrta_demir_cf.script import ME, Script, kinds

B = TaskBelief

NEAR = {"t": (4.0, 0.0)}
TWO = {"t": (4.0, 0.0), "u": (0.0, 6.0)}


def others_task() -> Script:
    """A robot that leaves t to a, which is nearer to it; nobody holds it yet."""
    script = Script(NEAR)
    script.step(script.hello("a", (4.0, 1.0)))
    script.wait(1.0)
    assert script.state("t") is B.INITIAL
    return script


def uncertain() -> Script:
    """The same, after a's request of t was followed by nothing but signs of life."""
    script = others_task()
    script.step(script.request("a", "t", 1.0, (4.0, 1.0)))
    for _ in range(9):
        script.step(script.hello("a"))
    assert script.state("t") is B.UNCERTAIN
    return script


def executed_by_a(cost: float = 1.0) -> Script:
    script = others_task()
    script.step(script.execution("a", "t", cost, (4.0, 1.0)))
    assert script.state("t") is B.EXECUTING_OTHER
    return script


def requested_by_a(cost: float = 1.0) -> Script:
    script = others_task()
    script.step(script.request("a", "t", cost, (4.0, 1.0)))
    assert script.state("t") is B.REQUESTED_OTHER
    return script


def test_row_1_task_that_is_selected_is_requested_from_all() -> None:
    script = Script(NEAR)
    assert script.wait(1.0) == []
    (request,) = script.step()
    assert (request.kind, request.task, request.recipient, request.cost) == (Kind.REQUEST, "t", "", 4.0)
    assert request.deadline == script.now + 1.0
    assert script.state("t") is B.REQUESTED


def test_row_1_uncertain_task_is_selected_like_a_free_one() -> None:
    script = uncertain()
    said = script.step(script.hello("a", (50.0, 0.0)))
    assert kinds(said) == [Kind.REQUEST]


def test_row_2_request_of_a_free_task_is_noted_and_answered_by_a_cheaper_robot_only() -> None:
    script = others_task()
    assert script.step(script.request("a", "t", 3.9, (4.0, 1.0))) == []
    assert (script.state("t"), script.holder("t")) == (B.REQUESTED_OTHER, "a")
    script = others_task()
    (bid,) = script.step(script.request("a", "t", 4.1, (4.0, 1.0)))
    assert (bid.kind, bid.task, bid.recipient, bid.cost) == (Kind.BID, "t", "a", 4.0)


def test_row_2_uncertain_task_may_be_requested_again() -> None:
    script = uncertain()
    script.step(script.request("c", "t", 3.0))
    assert (script.state("t"), script.holder("t")) == (B.REQUESTED_OTHER, "c")


@pytest.mark.parametrize("before", [others_task, uncertain, requested_by_a])
def test_row_3_task_that_another_executes_is_its(before: Callable[[], Script]) -> None:
    script = before()
    script.step(script.execution("c", "t", 2.5))
    model = script.agent.mind.tasks["t"]
    assert (model.belief, model.holder, model.cost, model.heard) == (B.EXECUTING_OTHER, "c", 2.5, script.now)


def test_row_4_task_that_is_awarded_to_another_is_left_to_it_for_as_long_as_an_execution() -> None:
    script = others_task()
    script.step(script.award("a", "t", "c"))
    assert (script.state("t"), script.holder("t")) == (B.REQUESTED_OTHER, "c")
    script.wait(6.5, "a", "c")
    assert script.state("t") is B.REQUESTED_OTHER
    script.wait(1.0, "a", "c")
    assert script.state("t") is B.UNCERTAIN


@pytest.mark.parametrize("before", [others_task, uncertain, requested_by_a, executed_by_a])
def test_row_5_robot_that_is_free_takes_what_it_is_awarded_and_sets_out(before: Callable[[], Script]) -> None:
    script = before()
    (execution,) = script.step(script.award("a", "t", ME))
    assert (execution.kind, execution.task, execution.cost) == (Kind.EXECUTION, "t", 4.0)
    assert script.carried_out == "t"


def test_row_5_robot_that_requests_a_task_itself_takes_the_award_of_it() -> None:
    script = Script(NEAR).requested()
    script.step(script.award("a", "t", ME))
    assert script.state("t") is B.EXECUTING
    assert script.agent.mind.auction is None


def test_row_6_robot_that_is_committed_elsewhere_refuses_an_award() -> None:
    script = Script(TWO).executing()
    (refusal,) = script.step(script.award("a", "u", ME))
    assert (refusal.kind, refusal.task, refusal.reason) == (Kind.CANCELLATION, "u", CancelReason.AWARD_REFUSED)
    assert (script.state("u"), script.carried_out) == (B.INITIAL, "t")


def test_row_6_robot_refuses_what_it_cannot_carry_out_any_more() -> None:
    script = requested_by_a()
    script.applicable["t"] = False
    (refusal,) = script.step(script.award("a", "t", ME))
    assert refusal.reason is CancelReason.AWARD_REFUSED
    assert script.state("t") is B.INITIAL


def test_row_7_uncertain_task_is_free_when_anybody_withdraws_from_it() -> None:
    script = uncertain()
    script.step(script.cancellation("c", "t"))
    assert script.state("t") is B.INITIAL


def test_rows_8_and_10_lowest_bid_below_the_own_cost_gets_the_award() -> None:
    script = Script(NEAR).requested()
    assert script.step(script.bid("a", "t", 3.0), script.bid("c", "t", 2.0)) == []
    assert script.state("t") is B.REQUESTED
    (award,) = script.step()
    assert (award.kind, award.task, award.winner, award.recipient) == (Kind.AWARD, "t", "c", "")
    assert (script.state("t"), script.holder("t"), script.carried_out) == (B.REQUESTED_OTHER, "c", None)


def test_row_8_bid() -> None:
    script = Script(NEAR).requested()
    script.step(script.bid("a", "t", 3.0))
    assert script.state("t") is B.REQUESTED


def test_row_9_robot_that_nobody_undercuts_by_the_deadline_begins() -> None:
    script = Script(NEAR).requested()
    script.step(script.bid("c", "t", 4.0))
    (execution,) = script.step()
    assert (execution.kind, execution.cost) == (Kind.EXECUTION, 4.0)
    assert script.carried_out == "t"


def test_row_9_of_equal_costs_the_smaller_id_wins() -> None:
    """a bids what b asked for and wins by its id; c, above, lost by it."""
    script = Script(NEAR).requested()
    script.step(script.bid("a", "t", 4.0))
    (award,) = script.step()
    assert award.winner == "a"


def test_row_10_award_that_nobody_follows_leaves_the_task_uncertain() -> None:
    script = Script(NEAR).requested()
    script.step(script.bid("a", "t", 3.0))
    script.step()
    script.wait(7.0, "a")
    assert script.state("t") is B.REQUESTED_OTHER
    assert kinds(script.wait(1.0, "a")) == [Kind.REQUEST]


def test_row_11_request_at_less_takes_the_auction_over() -> None:
    script = Script(NEAR).requested()
    assert script.step(script.request("c", "t", 3.0)) == []
    assert (script.state("t"), script.holder("t"), script.agent.mind.auction) == (B.REQUESTED_OTHER, "c", None)


def test_row_11_award_to_another_closes_the_auction() -> None:
    script = Script(NEAR).requested()
    script.step(script.award("a", "t", "c"))
    assert (script.state("t"), script.holder("t"), script.agent.mind.auction) == (B.REQUESTED_OTHER, "c", None)


def test_row_12_request_at_more_is_told_who_keeps_the_auction() -> None:
    script = Script(NEAR, reply_timeout=2.0).requested()
    script.step()
    (warning,) = script.step(script.request("c", "t", 4.0))
    assert (warning.kind, warning.recipient, warning.state) == (Kind.WARNING, "c", WarnedState.REQUESTED)
    assert (warning.holder, warning.cost) == (ME, 4.0)
    assert script.state("t") is B.REQUESTED


def test_row_12_request_at_more_that_crossed_the_own_needs_no_word() -> None:
    script = Script(NEAR).requested()
    assert script.step(script.request("c", "t", 4.0)) == []
    assert script.state("t") is B.REQUESTED


@pytest.mark.parametrize("seconds", [0.0, 1.0], ids=["requested", "executing"])
def test_row_13_path_robot_waits_while_another_goes_for_less(seconds: float) -> None:
    script = Script(TWO, gives_way=True, objective="path").requested()
    script.wait(seconds)
    (withdrawal,) = script.step(script.request("c", "u", 3.0))
    assert (withdrawal.kind, withdrawal.task, withdrawal.reason) == (
        Kind.CANCELLATION,
        "t",
        CancelReason.DEARER_REQUEST,
    )
    assert (script.state("t"), script.carried_out) == (B.INITIAL, None)
    assert script.step(script.execution("c", "u", 3.0)) == []
    assert kinds(script.step(script.completion("c", "u"))) == [Kind.REQUEST]


def test_row_13_time_robot_waits_for_a_neighbour_only() -> None:
    """The schedule is t and u, 4 m and 6 m away; c is no neighbour, and v lies far outside of it."""
    script = Script({**TWO, "v": (90.0, 0.0)}, gives_way=True)
    script.step(script.hello("c", (90.0, 9.0)), script.hello("a", (0.0, -30.0)))
    script.executing()
    assert script.step(script.request("c", "v", 1.0, (90.0, 9.0))) == []
    (withdrawal, *_) = script.step(script.request("a", "u", 3.0, (0.0, -30.0)))
    assert (withdrawal.task, withdrawal.reason) == ("t", CancelReason.DEARER_NEIGHBOUR)


def test_row_14_execution_of_what_is_auctioned_closes_the_auction() -> None:
    script = Script(NEAR).requested()
    assert script.step(script.execution("c", "t", 9.0)) == []
    assert (script.state("t"), script.holder("t"), script.agent.mind.auction) == (B.EXECUTING_OTHER, "c", None)


def test_row_14_executor_at_more_is_then_asked_for_the_task() -> None:
    script = Script(NEAR, exchange=True).requested()
    (offer,) = script.step(script.execution("c", "t", 9.0))
    assert (offer.kind, offer.recipient, offer.cost) == (Kind.EXCHANGE, "c", 4.0)


def test_row_15_robot_turns_to_what_has_become_nearer() -> None:
    script = Script(NEAR, {"u": (0.0, 1.0)}).executing()
    script.applicable["u"] = True
    said = script.step(reports=[script.report("u", Progress.APPEARED)])
    assert [(message.kind, message.task) for message in said] == [(Kind.CANCELLATION, "t"), (Kind.REQUEST, "u")]
    assert said[0].reason is CancelReason.IMPROVED


def test_row_15_robot_keeps_what_is_not_farther_by_the_margin() -> None:
    script = Script(NEAR, {"u": (0.0, 3.7)}).executing()
    script.applicable["u"] = True
    assert script.step(reports=[script.report("u", Progress.APPEARED)]) == []


def test_row_15_robot_lets_go_what_is_not_applicable_any_more() -> None:
    script = Script(NEAR).executing()
    script.applicable["t"] = False
    (withdrawal,) = script.step()
    assert (withdrawal.reason, script.carried_out) == (CancelReason.CHANGED_SCHEDULE, None)


def test_row_16_robot_says_at_once_that_it_sets_out() -> None:
    script = Script(NEAR).requested()
    assert script.step() == []
    (execution,) = script.step()
    assert (execution.kind, execution.cost, execution.eta) == (Kind.EXECUTION, 4.0, pytest.approx(4.0 / 0.3))


def test_row_17_robot_says_every_heartbeat_what_is_left() -> None:
    script = Script(NEAR).executing()
    script.here = (3.0, 0.0)
    assert script.wait(1.5) == []
    (execution,) = script.step()
    assert (execution.kind, execution.cost) == (Kind.EXECUTION, 1.0)


def test_row_18_robot_that_has_done_a_task_says_so_once_and_selects_again() -> None:
    script = Script(TWO).executing()
    said = script.step(reports=[script.done("t")])
    assert [(message.kind, message.task) for message in said] == [(Kind.COMPLETION, "t"), (Kind.REQUEST, "u")]
    assert script.state("t") is B.COMPLETED


def test_row_19_request_of_what_is_executed_is_answered() -> None:
    script = Script(NEAR).executing()
    (execution,) = script.step(script.request("c", "t", 3.7))
    assert (execution.kind, script.carried_out) == (Kind.EXECUTION, "t")


def test_row_19_award_of_what_is_executed_is_answered() -> None:
    script = Script(NEAR).executing()
    (execution,) = script.step(script.award("a", "t", "c"))
    assert (execution.kind, script.carried_out) == (Kind.EXECUTION, "t")


def test_row_20_request_at_less_by_the_margin_gets_what_is_executed() -> None:
    script = Script(NEAR).executing()
    (withdrawal,) = script.step(script.request("c", "t", 3.5))
    assert (withdrawal.kind, withdrawal.reason) == (Kind.CANCELLATION, CancelReason.HANDED_OVER)
    assert (script.state("t"), script.holder("t"), script.carried_out) == (B.REQUESTED_OTHER, "c", None)


def test_row_21_of_two_executors_the_dearer_yields() -> None:
    script = Script(NEAR).executing()
    (withdrawal,) = script.step(script.execution("a", "t", 4.0))
    assert (withdrawal.kind, withdrawal.reason) == (Kind.CANCELLATION, CancelReason.PARALLEL)
    assert (script.state("t"), script.holder("t"), script.carried_out) == (B.EXECUTING_OTHER, "a", None)


def test_row_22_of_two_executors_the_cheaper_says_that_it_goes_on() -> None:
    script = Script(NEAR).executing()
    (execution,) = script.step(script.execution("c", "t", 4.0))
    assert (execution.kind, script.carried_out) == (Kind.EXECUTION, "t")


def test_row_23_executor_hands_over_to_one_that_asks_and_is_nearer_by_the_margin() -> None:
    script = Script(NEAR, exchange=True).executing()
    (award,) = script.step(script.message("c", Kind.EXCHANGE, "t", recipient=ME, cost=3.5))
    assert (award.kind, award.winner) == (Kind.AWARD, "c")
    assert (script.state("t"), script.holder("t"), script.carried_out) == (B.REQUESTED_OTHER, "c", None)


@pytest.mark.parametrize(("exchange", "cost"), [(True, 3.7), (False, 1.0)])
def test_row_23_executor_answers_an_offer_that_it_does_not_take(exchange: bool, cost: float) -> None:
    script = Script(NEAR, exchange=exchange).executing()
    (execution,) = script.step(script.message("c", Kind.EXCHANGE, "t", recipient=ME, cost=cost))
    assert (execution.kind, script.carried_out) == (Kind.EXECUTION, "t")


def test_row_24_robot_that_finds_no_way_says_so_and_turns_to_something_else() -> None:
    script = Script(TWO).executing()
    said = script.step(reports=[script.report("t", Progress.UNREACHABLE, ME)])
    assert [(message.kind, message.task) for message in said] == [(Kind.UNACHIEVABILITY, "t"), (Kind.REQUEST, "u")]
    assert (said[0].map_stamp, script.state("t")) == (script.now, B.UNACHIEVABLE)


def test_row_25_robot_that_was_away_withdraws_listens_and_begins_again() -> None:
    script = Script(NEAR).executing()
    script.now += 8.0
    (withdrawal,) = script.step()
    assert (withdrawal.kind, withdrawal.reason, script.carried_out) == (Kind.CANCELLATION, CancelReason.FAILURE, None)
    assert kinds(script.wait(1.0)) == [Kind.REQUEST]


@pytest.mark.parametrize("before", [requested_by_a, executed_by_a])
def test_row_26_holder_that_withdraws_frees_its_task(before: Callable[[], Script]) -> None:
    script = before()
    script.step(script.cancellation("c", "t"))
    assert script.holder("t") == "a"
    script.step(script.cancellation("a", "t"))
    assert (script.state("t"), script.holder("t")) == (B.INITIAL, "")


def test_row_27_request_that_nothing_follows_is_uncertain_after_its_time() -> None:
    script = requested_by_a()
    script.wait(4.0, "a")
    assert script.state("t") is B.REQUESTED_OTHER
    script.wait(0.5, "a")
    assert script.state("t") is B.UNCERTAIN


def test_row_28_executor_that_is_heard_again_keeps_its_task() -> None:
    script = executed_by_a()
    for _ in range(3):
        script.wait(5.0, "a")
        script.step(script.execution("a", "t", 0.5, (4.0, 1.0)))
    assert (script.state("t"), script.agent.mind.tasks["t"].cost) == (B.EXECUTING_OTHER, 0.5)


def test_row_28_of_two_executors_the_cheaper_is_believed_to_hold_the_task() -> None:
    script = executed_by_a(1.0)
    script.step(script.execution("c", "t", 2.0))
    assert script.holder("t") == "a"
    script.step(script.execution("c", "t", 0.9))
    assert script.holder("t") == "c"


def test_row_28_of_two_requesters_the_cheaper_holds_a_task_unless_it_was_awarded() -> None:
    script = requested_by_a(1.0)
    script.step(script.request("c", "t", 1.0))
    assert script.holder("t") == "a"
    script.step(script.request("c", "t", 0.5))
    assert script.holder("t") == "c"
    script.step(script.award("c", "t", "a"))
    script.step(script.request("c", "t", 0.1))
    assert script.holder("t") == "a"


def test_row_29_executor_that_falls_silent_leaves_its_task_uncertain() -> None:
    script = executed_by_a()
    script.wait(7.0)
    assert script.state("t") is B.EXECUTING_OTHER
    script.step()
    assert script.state("t") in (B.UNCERTAIN, B.REQUESTED)


def test_row_30_executor_is_asked_for_a_task_that_is_nearer_by_the_margin() -> None:
    script = Script(NEAR, exchange=True)
    script.step(script.execution("a", "t", 5.0))
    (offer,) = script.wait(1.0)
    assert (offer.kind, offer.recipient, offer.task, offer.cost) == (Kind.EXCHANGE, "a", "t", 4.0)
    assert script.state("t") is B.EXECUTING_OTHER


@pytest.mark.parametrize("exchange", [True, False])
def test_row_30_executor_is_left_alone_where_little_is_gained_or_nobody_exchanges(exchange: bool) -> None:
    script = Script(NEAR, exchange=exchange)
    script.step(script.execution("a", "t", 4.4 if exchange else 50.0))
    assert script.wait(3.0) == []


@pytest.mark.parametrize("told", ["completion", "warning"])
def test_row_31_robot_stops_when_it_hears_that_its_task_is_done(told: str) -> None:
    script = Script(NEAR).executing()
    heard = script.completion("a", "t") if told == "completion" else script.warning("a", "t", "completed")
    assert script.step(heard) == []
    assert (script.state("t"), script.carried_out) == (B.COMPLETED, None)


@pytest.mark.parametrize("told", ["unachievability", "warning"])
def test_row_32_robot_stops_when_it_hears_that_its_task_cannot_be_reached(told: str) -> None:
    script = Script(NEAR, retry=0.0).executing()
    warned = told == "warning"
    heard = script.warning("a", "t", "unachievable", at=3.0) if warned else script.unachievability("a", "t", 3.0)
    assert script.step(heard) == []
    assert (script.state("t"), script.carried_out) == (B.UNACHIEVABLE, None)


@pytest.mark.parametrize("state", ["executing", "requested"])
def test_row_33_robot_that_is_warned_of_a_claim_closes_its_auction(state: str) -> None:
    script = Script(NEAR).requested()
    script.step(script.warning("c", "t", state, holder="a", cost=2.0))
    expected = B.EXECUTING_OTHER if state == "executing" else B.REQUESTED_OTHER
    assert (script.state("t"), script.holder("t"), script.agent.mind.auction) == (expected, "a", None)


@pytest.mark.parametrize("before", [others_task, uncertain, requested_by_a])
def test_row_33_warning_tells_who_executes_a_task(before: Callable[[], Script]) -> None:
    script = before()
    script.step(script.warning("a", "t", "executing", holder="c", cost=2.0))
    assert (script.state("t"), script.holder("t")) == (B.EXECUTING_OTHER, "c")


def test_row_34_task_that_can_be_reached_again_is_selected_again() -> None:
    script = Script(NEAR, retry=0.0).executing()
    script.step(script.unachievability("a", "t", script.now))
    assert script.state("t") is B.UNACHIEVABLE
    said = script.step(script.message("c", Kind.NEW_TASK, "t", place=(4.0, 0.0), map_stamp=script.now))
    assert kinds(said) == [Kind.REQUEST]


def test_row_34_way_that_opens_on_the_robots_own_map_is_told_to_all() -> None:
    script = Script(NEAR, retry=0.0).executing()
    script.costs["t"] = None
    script.step(reports=[script.report("t", Progress.UNREACHABLE, ME)])
    assert script.wait(5.0) == []
    script.costs["t"] = 4.0
    said = script.wait(2.0)
    assert kinds(said)[:2] == [Kind.NEW_TASK, Kind.REQUEST]
    assert said[0].place == (4.0, 0.0)


def test_row_34_task_is_tried_again_after_a_time_that_doubles() -> None:
    script = Script(NEAR, retry=5.0).executing()
    script.step(reports=[script.report("t", Progress.UNREACHABLE, ME)])
    assert script.wait(4.5) == []
    assert kinds(script.wait(2.0))[:2] == [Kind.NEW_TASK, Kind.REQUEST]
    script.wait(1.0)
    script.step(reports=[script.report("t", Progress.UNREACHABLE, ME)])
    assert script.wait(9.5) == []
    assert kinds(script.wait(2.0))[0] is Kind.NEW_TASK


@pytest.mark.parametrize("claim", ["request", "execution", "bid", "award"])
def test_row_35_claim_on_what_cannot_be_reached_is_set_right(claim: str) -> None:
    script = Script(NEAR, retry=0.0).executing()
    script.step(script.unachievability("a", "t", 3.0))
    (warning,) = script.step(a_claim(script, claim))
    assert (warning.recipient, warning.state, warning.map_stamp) == ("c", WarnedState.UNACHIEVABLE, 3.0)
    assert script.state("t") is B.UNACHIEVABLE


@pytest.mark.parametrize("claim", ["request", "execution", "bid", "award"])
def test_row_36_claim_on_what_is_done_is_set_right(claim: str) -> None:
    script = Script(NEAR).executing()
    script.step(script.completion("a", "t"))
    (warning,) = script.step(a_claim(script, claim))
    assert (warning.recipient, warning.state) == ("c", WarnedState.COMPLETED)
    assert script.state("t") is B.COMPLETED


def a_claim(script: Script, claim: str) -> Heard:
    made: Dict[str, Callable[[], Heard]] = {
        "request": lambda: script.request("c", "t", 1.0),
        "execution": lambda: script.execution("c", "t", 1.0),
        "bid": lambda: script.bid("c", "t", 1.0),
        "award": lambda: script.award("c", "t", ME),
    }
    return made[claim]()


def test_row_37_task_that_nobody_knew_is_added_by_any_message_that_names_it() -> None:
    script = Script(NEAR)
    script.step(script.execution("a", "z", 1.0))
    assert (script.state("z"), script.holder("z")) == (B.EXECUTING_OTHER, "a")
    script.step(script.cancellation("a", "z"))
    assert kinds(script.wait(8.0, "a")) == [Kind.REQUEST] + [Kind.EXECUTION] * 4
    assert script.carried_out == "t"


def test_every_row_of_the_table_has_its_test() -> None:
    named = {int(number) for name in globals() for number in re.findall(r"(?:row|rows|and)_(\d+)", name)}
    assert named == {row.number for row in TASK_ROWS} | {37} == set(range(1, 38))
