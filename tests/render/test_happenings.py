from __future__ import annotations

from typing import Dict, List, Tuple

import pytest

from rqt_mrta_py.hooks import Heard, ScenarioLabel
from rqt_mrta_py.model import ScenarioEventKind
from rqt_mrta_py.render.happenings import Condition, LabelKeeper, conditions, happening_word, radio_is_split


def event(kind: str, robot: str = "robot1", parameters: str = "", time: float = 1.0) -> Heard:
    fields = {"kind": kind, "robot_id": robot, "task_id": "", "parameters_yaml": parameters, "text": f"{robot} {kind}."}
    return Heard("/mrta/scenario_event", "rqt_mrta_py/ScenarioEvent", time, fields)


def labels(*events: Heard) -> Tuple[ScenarioLabel, ...]:
    keeper = LabelKeeper()
    for each in events:
        keeper.hear(each)
    return keeper.labels()


CASES: List[Tuple[List[Tuple[str, str]], Dict[str, Condition]]] = [
    ([], {}),
    ([("robot_stops", "")], {"robot1": Condition.STOPPED}),
    ([("robot_stops", ""), ("robot_returns", "")], {}),
    ([("robot_stops", ""), ("robot_stops", ""), ("robot_returns", "")], {"robot1": Condition.STOPPED}),
    ([("robot_returns", ""), ("robot_stops", "")], {"robot1": Condition.STOPPED}),
    ([("robot_sticks", ""), ("robot_sticks", ""), ("robot_comes_free", "")], {}),
    ([("robot_slows", "factor: 0.5\n")], {"robot1": Condition.SLOW}),
    ([("robot_slows", "factor: 0.5\n"), ("robot_slows", "factor: 1.0\n")], {}),
    ([("robot_clock_shifts", "{offset: -3}")], {"robot1": Condition.CLOCK_OFF}),
    ([("robot_clock_shifts", "offset: -3"), ("robot_clock_shifts", "offset: 0")], {}),
    ([("robot_slows", "factor: 0.1"), ("radio_fails", "")], {"robot1": Condition.OFF_THE_AIR}),
    ([("radio_fails", ""), ("robot_stops", ""), ("radio_returns", "")], {"robot1": Condition.STOPPED}),
    ([("radio_partitions", ""), ("task_appears", ""), ("nonsense", "")], {}),
]


@pytest.mark.parametrize(("happened", "expected"), CASES)
def test_conditions_follow_from_what_happened(happened: List[Tuple[str, str]], expected: Dict[str, Condition]) -> None:
    assert conditions(labels(*(event(kind, "robot1", text) for kind, text in happened))) == expected


def test_conditions_need_a_robot() -> None:
    assert conditions(labels(event("robot_stops", ""))) == {}


@pytest.mark.parametrize("text", ["{", "factor: [1]", "- 1", "factor: one", "\x00", "factor: 1\n" * 9000])
def test_parameters_that_make_no_sense_set_nothing_right(text: str) -> None:
    assert conditions(labels(event("robot_slows", "robot1", text))) == {"robot1": Condition.SLOW}


def test_radio_is_split_until_it_heals() -> None:
    assert not radio_is_split(labels(event("radio_fails")))
    assert radio_is_split(labels(event("radio_partitions", ""), event("radio_fails")))
    assert not radio_is_split(labels(event("radio_partitions", ""), event("radio_heals", "")))


@pytest.mark.parametrize("kind", list(ScenarioEventKind))
def test_every_kind_has_a_word_of_its_own(kind: ScenarioEventKind) -> None:
    words = [happening_word(label) for label in labels(*(event(other.value) for other in ScenarioEventKind))]
    word = happening_word(labels(event(kind.value))[0])
    assert words.count(word) == 1
    assert len(word) <= 16


def test_words_tell_what_is_set_right() -> None:
    slow, quick = labels(event("robot_slows", parameters="factor: 0.5"), event("robot_slows", parameters="factor: 1"))
    assert (happening_word(slow), happening_word(quick)) == ("slows", "full speed")
    assert happening_word(ScenarioLabel(0.0, "volcano_erupts", "")) == "volcano erupts"


def test_keeper_makes_labels_of_untrusted_text_short_and_keeps_a_bounded_number() -> None:
    keeper = LabelKeeper()
    for number in range(5000):
        keeper.hear(event("k\x07" * 1000, "/r" * 10, time=float(number)))
    kept = keeper.labels()
    assert len(kept) == 2000
    assert kept[-1].time == 4999.0
    assert len(kept[-1].kind) <= 40
    assert kept[-1].kind.isprintable()
    assert kept[-1].robot == "r" + "/r" * 9
