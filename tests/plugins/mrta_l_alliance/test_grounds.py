"""What was learned before a task was taken, told from memories written by hand."""

from __future__ import annotations

from typing import Any, Dict

from mrta_l_alliance.grounds import LAllianceGrounds
from mrta_l_alliance.memory import Memory, Performance
from mrta_l_alliance.messages import MEMORY_FIELDS, MEMORY_TYPE, memory_message

from rqt_mrta_py.hooks import GroundsSetup, Heard
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, Ground, Mission, Taxonomy
from tests.plugins.mrta_alliance.test_grounds import felt

MISSION = Mission(ApplicationSpec("", ""), ArchitectureSpec("mrta_l_alliance", "L-ALLIANCE", Taxonomy()), ())
KNOWN = Memory({("one", "fetch"): Performance((10.0, 20.0), 1), ("two", "fetch"): Performance((30.0,))})


def remembered(memory: Memory, time: float) -> Heard:
    said: Dict[str, Any] = dict(memory_message("one", time, memory, lambda robot, task: None).fields)
    fields = {name: said[name] for name in MEMORY_FIELDS}
    return Heard("/one/l_alliance/memory", MEMORY_TYPE, time, fields, "one")


def test_what_a_robot_has_learned_of_a_task_is_told_with_means_and_failures() -> None:
    reader = LAllianceGrounds(GroundsSetup(MISSION))
    assert reader.hear(remembered(KNOWN, 5.0)) == [
        Ground(
            5.0,
            "fetch",
            "has learned how long it takes: one 15.0 s (2 trials, 1 failed), two 30.0 s (1 trial)",
            "one",
            {"mean_time_of_one": 15.0, "mean_time_of_two": 30.0},
        )
    ]


def test_a_memory_told_again_is_no_new_ground_and_only_what_changed_is_told() -> None:
    reader = LAllianceGrounds(GroundsSetup(MISSION))
    reader.hear(remembered(KNOWN, 5.0))
    assert list(reader.hear(remembered(KNOWN, 6.0))) == []
    more = KNOWN.including("two", "carry", Performance((), 2))
    assert [(each.task, each.text) for each in reader.hear(remembered(more, 7.0))] == [
        ("carry", "has learned how long it takes: two failed 2 times")
    ]


def test_motivations_are_told_as_under_alliance() -> None:
    (ground,) = LAllianceGrounds(GroundsSetup(MISSION)).hear(felt(0.2))
    assert ground.text == "motivation grows by 1 a cycle towards the threshold 30"
