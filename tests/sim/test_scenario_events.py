from __future__ import annotations

import pytest
import yaml

from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind
from rqt_mrta_py.sim import label_of


def test_label_tells_what_happened_to_whom():
    outgoing = label_of(ScenarioEvent(60.0, ScenarioEventKind.ROBOT_STOPS, "robot3"), 61.0)
    assert (outgoing.topic, outgoing.type, outgoing.latched) == (
        "/mrta/scenario_event",
        "rqt_mrta_py/ScenarioEvent",
        False,
    )
    assert outgoing.fields == {
        "header": {"stamp": 61.0, "frame_id": ""},
        "kind": "robot_stops",
        "robot_id": "robot3",
        "task_id": "",
        "parameters_yaml": "",
        "text": "robot3 stops: it stands still and falls silent.",
    }


def test_label_carries_parameters_as_yaml_in_one_order():
    event = ScenarioEvent(1.0, ScenarioEventKind.ROBOT_RETURNS, "robot5", "report", {"b": 2.5, "a": ["x", "ü"]})
    fields = label_of(event, 2.0).fields
    assert fields["task_id"] == "report"
    assert fields["parameters_yaml"].index("a:") < fields["parameters_yaml"].index("b:")
    assert yaml.safe_load(fields["parameters_yaml"]) == {"a": ["x", "ü"], "b": 2.5}
    assert fields["text"] == "robot5 returns."


def test_label_names_only_fields_of_its_message(root):
    text = (root / "msg" / "ScenarioEvent.msg").read_text()
    names = {line.split("#")[0].split()[1] for line in text.splitlines() if line.split("#")[0].strip()}
    event = ScenarioEvent(1.0, ScenarioEventKind.ROBOT_STOPS, "robot3")
    assert set(label_of(event, 1.0).fields) == names


@pytest.mark.parametrize("kind", list(ScenarioEventKind))
def test_label_has_a_sentence_for_every_kind(kind):
    text = label_of(ScenarioEvent(1.0, kind, "robot1"), 1.0).fields["text"]
    assert text.startswith("robot1 ")
    assert text.endswith(".")
