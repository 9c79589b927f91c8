"""All faults, and which rules must find them."""

from __future__ import annotations

from typing import Tuple

from rqt_mrta_py.app.bench.incidents import clocks, radio, wire, world
from rqt_mrta_py.app.bench.incidents.fault import Fault, Place
from rqt_mrta_py.app.bench.incidents.setting import (
    ALLIANCE,
    ARCHITECTURES,
    BASELINES,
    DEMIR_CF,
    L_ALLIANCE,
    NEAREST_ROBOT,
)
from rqt_mrta_py.app.bench.incidents.yards import YardKind

__all__ = ["FAULTS", "RULES", "faults_for"]

_WATCH, _ERRANDS, _DEADLINES, _ARRIVALS = YardKind

_FREE = (ALLIANCE, L_ALLIANCE, DEMIR_CF, NEAREST_ROBOT)
"""Under these a robot that is free takes what another has left; the baselines deal tasks once."""

FAULTS: Tuple[Fault, ...] = (
    Fault("holder_stops", Place.WORLD, ("robot_silent_with_task",), "a robot with a task stops, for good or a while",
          _WATCH, ARCHITECTURES, world.holder_stops),
    Fault("idle_robot_stops", Place.WORLD, ("topic_gap",), "a robot without a task stops, for good or a while",
          _WATCH, ARCHITECTURES, world.idle_robot_stops),
    Fault("all_able_stop", Place.WORLD, ("task_held_by_nobody", "robot_silent_with_task"),
          "all robots that can carry out a task stop", _WATCH, _FREE, world.all_able_stop),
    Fault("everybody_slows", Place.WORLD, ("duration_overrun",), "all robots slow down to next to nothing",
          _DEADLINES, (ALLIANCE, DEMIR_CF, NEAREST_ROBOT, BASELINES), world.everybody_slows),
    Fault("holder_sticks", Place.WORLD, ("duration_overrun",), "a robot with a task is stuck",
          _DEADLINES, (BASELINES,), world.holder_sticks),
    Fault("change_their_minds", Place.WORLD, ("flipping_allocation",), "operators give a task to and fro",
          _WATCH, ARCHITECTURES, world.change_their_minds),
    Fault("estimate_in_turns", Place.WORLD, ("flipping_allocation",), "two robots find a task dear in turns",
          _WATCH, (NEAREST_ROBOT,), world.estimate_in_turns),
    Fault("others_dear", Place.WORLD, ("unequal_share",), "all robots but one find everything dear",
          _ARRIVALS, (NEAREST_ROBOT, DEMIR_CF), world.others_dear),
    Fault("holder_cut_off", Place.RADIO, ("task_held_by_two_robots",), "the radio of a robot with a task fails",
          _WATCH, _FREE, radio.holder_cut_off),
    Fault("parted", Place.RADIO, ("task_held_by_two_robots",), "the radio parts the team in two",
          _WATCH, _FREE, radio.parted),
    Fault("worker_cut_off", Place.RADIO, ("task_completed_twice",), "the radio of a robot fails early",
          _ERRANDS, _FREE, radio.worker_cut_off),
    Fault("ahead", Place.CLOCKS, ("message_from_the_future",), "a clock is set ahead",
          _WATCH, ARCHITECTURES, clocks.ahead),
    Fault("ahead_for_a_while", Place.CLOCKS, ("message_from_the_future",), "a clock is set ahead, and right again",
          _WATCH, ARCHITECTURES, clocks.ahead_for_a_while),
    Fault("drifts_ahead", Place.CLOCKS, ("message_from_the_future",), "a clock gains",
          _WATCH, ARCHITECTURES, clocks.drifts_ahead),
    Fault("behind", Place.CLOCKS, ("message_from_the_past",), "a clock is set back",
          _WATCH, ARCHITECTURES, clocks.behind),
    Fault("drifts_behind", Place.CLOCKS, ("message_from_the_past",), "a clock loses",
          _WATCH, ARCHITECTURES, clocks.drifts_behind),
    Fault("late_words", Place.WIRE, ("message_from_the_past",), "what a robot says is under way for long",
          _WATCH, ARCHITECTURES, wire.late_words),
    Fault("silent_topic", Place.WIRE, ("topic_gap",), "a robot says nothing on its idle topics",
          _WATCH, (ALLIANCE, L_ALLIANCE, DEMIR_CF), wire.silent_topic),
    Fault("holds_another", Place.WIRE, ("robot_with_two_tasks",), "a robot claims a second task",
          _WATCH, (ALLIANCE, L_ALLIANCE, NEAREST_ROBOT, BASELINES), wire.holds_another),
    Fault("leaps", Place.WIRE, ("flipping_allocation",), "a robot claims two tasks in turns, each instead of the other",
          _WATCH, (DEMIR_CF,), wire.leaps),
    Fault("busy_with_nothing", Place.WIRE, ("busy_without_task",), "a robot says that it works, and not on what",
          _WATCH, ARCHITECTURES, wire.busy_with_nothing),
    Fault("goes_on", Place.WIRE, ("illegal_state_change",), "a robot goes on with a task that it has done",
          _ERRANDS, ARCHITECTURES, wire.goes_on),
    Fault("ends_otherwise", Place.WIRE, ("illegal_state_change",), "a task that is done is said to have failed",
          _ERRANDS, ARCHITECTURES, wire.ends_otherwise),
    Fault("completes_again", Place.WIRE, ("task_completed_twice", "illegal_state_change"),
          "a robot completes a task that it has done", _ERRANDS, ARCHITECTURES, wire.completes_again),
    Fault("stranger", Place.WIRE, ("unknown_robot",), "a robot that is not of the team claims a task",
          _WATCH, ARCHITECTURES, wire.stranger),
    Fault("stranger_reports", Place.WIRE, ("unknown_robot",), "a robot that is not of the team reports on a task",
          _WATCH, ARCHITECTURES, wire.stranger_reports),
    Fault("misspelt_task", Place.WIRE, ("unknown_task",), "a robot claims a task whose name is misspelt",
          _WATCH, ARCHITECTURES, wire.misspelt_task),
    Fault("task_of_others", Place.WIRE, ("unknown_task",), "a robot reports on a task that nobody knows",
          _WATCH, ARCHITECTURES, wire.task_of_others),
    Fault("nobody_begins", Place.WIRE, ("task_held_by_nobody",), "no robot begins with what it has decided",
          _WATCH, _FREE, wire.nobody_begins),
)  # fmt: skip
"""In the order of places."""

RULES: Tuple[str, ...] = tuple(sorted({rule for fault in FAULTS for rule in fault.rules}))
"""Ids of the rules that some fault is for."""


def faults_for(rule: str) -> Tuple[Fault, ...]:
    """List the faults that a rule must find."""
    return tuple(fault for fault in FAULTS if rule in fault.rules)
