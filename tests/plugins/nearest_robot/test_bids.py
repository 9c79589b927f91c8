from __future__ import annotations

import math
from typing import Any, Dict

import pytest
from nearest_robot.bids import Bid, Offer, bid_message, claim_message, read_bid

from rqt_mrta_py.hooks import Heard
from tests.plugins.nearest_robot.team import as_heard

SOUND: Dict[str, Any] = {
    "robot_id": "a",
    "task_ids": ["t", "u"],
    "costs": [1.0, 2.0],
    "robots": [1, 2],
    "holding": "t",
    "ordered": "",
}


def heard(**changes: Any) -> Heard:
    return Heard("/nearest_robot/bids", "nearest_robot_msgs/Bid", 1.0, {**SOUND, **changes})


def test_bid_is_read() -> None:
    assert read_bid(heard()) == Bid("a", {"t": Offer(1.0, 1), "u": Offer(2.0, 2)}, "t")
    assert read_bid(heard(robot_id="/a", task_ids=[], costs=[], robots=[], holding="")) == Bid("a", {})


@pytest.mark.parametrize(
    "changes",
    [
        {"robot_id": ""},
        {"costs": [1.0]},
        {"robots": [1]},
        {"task_ids": ["t"]},
        {"task_ids": ["t", "t"]},
        {"task_ids": ["t", ""]},
        {"costs": [1.0, math.nan]},
        {"costs": [-math.inf, 1.0]},
        {"robots": [1, 0]},
    ],
    ids=str,
)
def test_bid_that_contradicts_itself_is_none(changes: Dict[str, Any]) -> None:
    assert read_bid(heard(**changes)) is None


def test_bid_is_told_as_it_is_read() -> None:
    told = Bid("a", {"t": Offer(1.5, 1), "u": Offer(2.0, 3)}, "t", "u")
    message = bid_message(told, 4.2)
    assert message.fields["header"] == {"stamp": 4.2, "frame_id": "/a"}
    assert read_bid(as_heard(message, 4.2)) == told


def test_claim_names_robot_and_task() -> None:
    message = claim_message("a", "t", 4.2)
    assert (message.topic, message.type) == ("/nearest_robot/claims", "nearest_robot_msgs/Claim")
    assert message.fields == {"header": {"stamp": 4.2, "frame_id": "/a"}, "robot_id": "a", "task_id": "t"}
