"""What operators order."""

from __future__ import annotations

import pytest

from rqt_mrta_py.app.live import orders
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, Mission, Task, Taxonomy

MISSION = Mission(
    ApplicationSpec("yard", "Yard", "auction"),
    ArchitectureSpec("auction", "Auction", Taxonomy.parse("ST-SR-IA")),
    (Task("dig", "digging"),),
    later_tasks=(Task("rake", "raking"),),
)


def test_task_given_as_text_is_passed_on() -> None:
    order = orders.submitted({"task_id": "", "task_yaml": "{id: plant, kind: planting}"}, MISSION, 2.0)
    fields = order.fields
    assert (fields["task_id"], fields["progress"], fields["header"]) == ("plant", 4, {"stamp": 2.0})
    assert fields["task_yaml"] == "id: plant\nkind: planting\n"


def test_task_that_is_listed_needs_no_text() -> None:
    order = orders.submitted({"task_id": "/rake", "task_yaml": ""}, MISSION, 2.0)
    assert (order.fields["task_id"], order.fields["task_yaml"]) == ("rake", "")


@pytest.mark.parametrize(
    ("task_id", "text", "message"),
    [
        ("", "", "task_id: is empty; accepted: dig, rake"),
        ("rakes", "", "task_id: nobody knows 'rakes'; nearest is 'rake'"),
        ("dig", "{id: plant, kind: planting}", "task_yaml: defines 'plant', but task_id is 'dig'"),
        ("", "{id: plant}", "task_yaml"),
        ("", "- [", "task_yaml"),
    ],
)
def test_task_that_makes_no_sense_is_refused(task_id: str, text: str, message: str) -> None:
    with pytest.raises(MrtaError) as refusal:
        orders.submitted({"task_id": task_id, "task_yaml": text}, MISSION, 2.0)
    assert message in str(refusal.value)


def test_task_is_taken_back() -> None:
    fields = orders.withdrawn({"task_id": "dig", "reason": "rain"}, ["dig"], 3.0).fields
    assert (fields["task_id"], fields["progress"], fields["detail"]) == ("dig", 5, "rain")


def test_task_goes_to_a_robot() -> None:
    request = {"task_id": "dig", "robot_id": "/r2", "reason": ""}
    fields = orders.reassigned(request, ["dig"], ["r1", "r2"], 3.0).fields
    assert (fields["task_id"], fields["robot_id"], fields["progress"]) == ("dig", "r2", 6)


def test_robot_that_nobody_knows_gets_nothing() -> None:
    request = {"task_id": "dig", "robot_id": "no robot!", "reason": ""}
    with pytest.raises(MrtaError, match="robot_id: nobody knows 'no robot!'; accepted: r1, r2"):
        orders.reassigned(request, ["dig"], ["r1", "r2"], 3.0)


def test_of_a_team_that_is_not_listed_anybody_will_do() -> None:
    request = {"task_id": "dig", "robot_id": "r7", "reason": ""}
    assert orders.reassigned(request, [], [], 3.0).fields["robot_id"] == "r7"
