"""Bids and claims: what robots tell one another, as values and as messages of ``nearest_robot_msgs``."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Dict, Mapping, Optional, Tuple

from rqt_mrta_py.hooks import Heard, Outgoing, Subscription
from rqt_mrta_py.model import normalise_id, wire_id

__all__ = ["BIDS", "Bid", "Offer", "bid_message", "claim_message", "read_bid"]

_BIDS_TOPIC = "/nearest_robot/bids"
_CLAIMS_TOPIC = "/nearest_robot/claims"

BIDS = Subscription(
    _BIDS_TOPIC,
    "nearest_robot_msgs/Bid",
    ("robot_id", "task_ids", "costs", "robots", "holding", "ordered"),
)
"""What to subscribe to for ``read_bid``."""


@dataclass(frozen=True)
class Offer:
    """What one task would cost one robot.

    Attributes:
        cost: finite, smaller is better [m; s where nothing moves].
        robots: how many robots the task needs, at least 1.
    """

    cost: float
    robots: int = 1


@dataclass(frozen=True)
class Bid:
    """What one robot told in one cycle.

    Attributes:
        robot: its id.
        offers: by the id of each task that it could carry out then, in its mission's order.
        holding: the task that it carries out; empty if none.
        ordered: the task that an operator ordered it to carry out; empty if none.
    """

    robot: str
    offers: Mapping[str, Offer]
    holding: str = ""
    ordered: str = ""


def read_bid(heard: Heard) -> Optional[Bid]:
    """Read a message of ``BIDS``.

    Args:
        heard: from whomever.

    Returns:
        The bid; None if it names no robot, its lists differ in length, a cost is not finite, a task has no id or
        stands there twice, or a task needs no robot.
    """
    fields = heard.fields
    robot = normalise_id(fields["robot_id"])
    tasks, costs, needed = fields["task_ids"], fields["costs"], fields["robots"]
    offers: Dict[str, Offer] = {}
    if robot and len(tasks) == len(costs) == len(needed):
        offers = {task: Offer(cost, count) for task, cost, count in zip(tasks, costs, needed)}
    sound = all(task and math.isfinite(offer.cost) and offer.robots >= 1 for task, offer in offers.items())
    if not robot or not sound or not len(offers) == len(tasks) == len(costs) == len(needed):
        return None
    return Bid(robot, offers, fields["holding"], fields["ordered"])


def bid_message(bid: Bid, now: float) -> Outgoing:
    """Tell a bid at a time [s]."""
    tasks, costs, needed = _columns(bid)
    fields = {
        "header": {"stamp": now, "frame_id": wire_id(bid.robot)},
        "robot_id": bid.robot,
        "task_ids": tasks,
        "costs": costs,
        "robots": needed,
        "holding": bid.holding,
        "ordered": bid.ordered,
    }
    return Outgoing(BIDS.topic, BIDS.type, fields)


def claim_message(robot: str, task: str, now: float) -> Outgoing:
    """Tell at a time [s] that a robot carries out a task."""
    fields = {"header": {"stamp": now, "frame_id": wire_id(robot)}, "robot_id": robot, "task_id": task}
    return Outgoing(_CLAIMS_TOPIC, "nearest_robot_msgs/Claim", fields)


def _columns(bid: Bid) -> Tuple[Tuple[str, ...], Tuple[float, ...], Tuple[int, ...]]:
    offers = bid.offers.values()
    return tuple(bid.offers), tuple(offer.cost for offer in offers), tuple(offer.robots for offer in offers)
