from __future__ import annotations

import re

import pytest
import yaml

from rqt_mrta_py.model import Pose, ScenarioEvent, ScenarioEventKind, Task
from rqt_mrta_py.sim import label_of, order_of


def test_label_tells_what_happened_to_whom():
    outgoing = label_of(ScenarioEvent(60.0, ScenarioEventKind.ROBOT_STOPS, "robot3"), 61.0)
    assert (outgoing.topic, outgoing.type, outgoing.latched) == (
        "/mrta/scenario_event",
        "rqt_mrta_py/ScenarioEvent",
        False,
    )
    assert outgoing.fields == {
        "header": {"stamp": 61.0},
        "kind": "robot_stops",
        "robot_id": "robot3",
        "task_id": "",
        "parameters_yaml": "",
        "text": "robot3 stops: it stands still and falls silent.",
    }


def test_label_carries_parameters_as_yaml_in_one_order():
    parameters = {"loss": 0.25, "kind": "lossy", "note": ["x", "ü"]}
    fields = label_of(ScenarioEvent(1.0, ScenarioEventKind.RADIO_CHANGES, parameters=parameters), 2.0).fields
    assert fields["parameters_yaml"] == "kind: lossy\nloss: 0.25\nnote:\n- x\n- ü\n"
    assert yaml.safe_load(fields["parameters_yaml"]) == parameters


def test_label_names_only_fields_of_its_message(root):
    text = (root / "msg" / "ScenarioEvent.msg").read_text()
    names = {line.split("#")[0].split()[1] for line in text.splitlines() if line.split("#")[0].strip()}
    event = ScenarioEvent(1.0, ScenarioEventKind.ROBOT_STOPS, "robot3")
    assert set(label_of(event, 1.0).fields) == names


KIND = ScenarioEventKind
TOLD = [
    (ScenarioEvent(1.0, KIND.ROBOT_STOPS, "r1"), "r1 stops: it stands still and falls silent."),
    (ScenarioEvent(1.0, KIND.ROBOT_RETURNS, "r1"), "r1 returns."),
    (ScenarioEvent(1.0, KIND.ROBOT_REMOVED, "r1"), "r1 is taken off the floor, with what it holds."),
    (ScenarioEvent(1.0, KIND.ROBOT_STICKS, "r1"), "r1 is stuck: it stands still but is heard."),
    (ScenarioEvent(1.0, KIND.ROBOT_COMES_FREE, "r1"), "r1 comes free."),
    (
        ScenarioEvent(1.0, KIND.ROBOT_SLOWS, "r1", parameters={"factor": 0.07}),
        "r1 slows down: it drives at 7 % of what it is commanded.",
    ),
    (ScenarioEvent(1.0, KIND.ROBOT_SLOWS, "r1", parameters={"factor": 1.0}), "r1 drives at full speed again."),
    (
        ScenarioEvent(1.0, KIND.ROBOT_CLOCK_SHIFTS, "r1", parameters={"offset": 2.5}),
        "The clock of r1 is set 2.5 s ahead of the true time.",
    ),
    (
        ScenarioEvent(1.0, KIND.ROBOT_CLOCK_SHIFTS, "r1", parameters={"offset": -0.5}),
        "The clock of r1 is set 0.5 s behind the true time.",
    ),
    (
        ScenarioEvent(1.0, KIND.ROBOT_CLOCK_SHIFTS, "r1", parameters={"offset": 0.0}),
        "The clock of r1 is set right.",
    ),
    (
        ScenarioEvent(1.0, KIND.RADIO_FAILS, "r1"),
        "The radio of r1 fails: it reaches nobody and nobody reaches it.",
    ),
    (ScenarioEvent(1.0, KIND.RADIO_RETURNS, "r1"), "The radio of r1 works again."),
    (
        ScenarioEvent(1.0, KIND.RADIO_PARTITIONS, parameters={"groups": [["r1", "r2"], [], ["r3"]]}),
        "The radio reaches only within groups: (r1, r2), (r3).",
    ),
    (
        ScenarioEvent(1.0, KIND.RADIO_PARTITIONS, parameters={"groups": [[f"r{i}" for i in range(1000)]]}),
        "The radio reaches only within groups: (r0, r1, r2, r3, r4 and 995 more).",
    ),
    (ScenarioEvent(1.0, KIND.RADIO_PARTITIONS, parameters={"groups": []}), "The radio reaches nobody."),
    (ScenarioEvent(1.0, KIND.RADIO_HEALS), "The radio reaches everybody again."),
    (
        ScenarioEvent(1.0, KIND.RADIO_CHANGES, parameters={"kind": "lossy", "loss": 0.2, "delay": 1}),
        "The radio is lossy from now on: delay 1, loss 0.2.",
    ),
    (ScenarioEvent(1.0, KIND.RADIO_CHANGES, parameters={"kind": "perfect"}), "The radio is perfect from now on."),
    (ScenarioEvent(1.0, KIND.TASK_APPEARS, task="dig"), "Task dig appears."),
    (ScenarioEvent(1.0, KIND.TASK_WITHDRAWN, task="dig"), "An operator withdraws task dig."),
    (ScenarioEvent(1.0, KIND.TASK_REASSIGNED, "r2", "dig"), "An operator reassigns task dig to r2."),
]


@pytest.mark.parametrize(("event", "sentence"), TOLD, ids=lambda told: getattr(told, "kind", told))
def test_label_says_in_a_sentence_what_happens(event, sentence):
    fields = label_of(event, 1.0).fields
    assert fields["text"] == sentence
    assert (fields["kind"], fields["robot_id"], fields["task_id"]) == (
        event.kind.value,
        event.robot or "",
        event.task or "",
    )


def test_sentences_cover_every_kind():
    assert {event.kind for event, _ in TOLD} == set(ScenarioEventKind)


DIG = Task("dig", "dig_hole", Pose(1.0, 2.0))


def test_operators_order_carries_the_task_that_appears():
    order = order_of(ScenarioEvent(1.0, KIND.TASK_APPEARS, task="dig"), DIG, 2.0)
    assert (order.topic, order.type, order.latched) == ("/mrta/task_progress", "rqt_mrta_py/TaskProgress", False)
    assert order.fields["header"] == {"stamp": 2.0}
    assert (order.fields["task_id"], order.fields["robot_id"]) == ("dig", "")
    assert yaml.safe_load(order.fields["task_yaml"]) == {"id": "dig", "kind": "dig_hole", "place": {"x": 1.0, "y": 2.0}}


def test_operator_tells_which_robot_was_removed():
    order = order_of(ScenarioEvent(1.0, KIND.ROBOT_REMOVED, "r2"), None, 2.0)
    assert (order.topic, order.type, order.fields) == ("/mrta/robot_removed", "std_msgs/String", {"data": "r2"})


def test_operator_tells_of_all_who_were_removed_so_far():
    order = order_of(ScenarioEvent(1.0, KIND.ROBOT_REMOVED, "r2"), None, 2.0, removed=("r4", "r1"))
    assert order.fields == {"data": "r4 r1 r2"}


def test_operators_order_to_reassign_names_the_robot_that_it_goes_to():
    fields = order_of(ScenarioEvent(1.0, KIND.TASK_REASSIGNED, "r2", "dig"), DIG, 2.0).fields
    assert (fields["task_id"], fields["robot_id"], fields["task_yaml"]) == ("dig", "r2", "")


@pytest.mark.parametrize(
    ("kind", "constant"),
    [(KIND.TASK_APPEARS, "APPEARED"), (KIND.TASK_WITHDRAWN, "WITHDRAWN"), (KIND.TASK_REASSIGNED, "REASSIGNED")],
)
def test_operators_order_says_what_its_message_means(root, kind, constant):
    text = (root / "msg" / "TaskProgress.msg").read_text()
    codes = dict(re.findall(r"uint8 (\w+)=(\d+)", text))
    fields = order_of(ScenarioEvent(1.0, kind, None, "dig"), DIG, 2.0).fields
    assert fields["progress"] == int(codes[constant])
    names = {line.split("#")[0].split()[1] for line in text.splitlines() if line.split("#")[0].strip()}
    assert set(fields) <= names


def test_operators_speak_of_what_happens_to_tasks_and_of_robots_that_are_taken_away():
    orders = {event.kind for event, _ in TOLD if order_of(event, None, 1.0) is not None}
    assert orders == {KIND.ROBOT_REMOVED, KIND.TASK_APPEARS, KIND.TASK_WITHDRAWN, KIND.TASK_REASSIGNED}
