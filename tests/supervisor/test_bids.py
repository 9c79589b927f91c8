"""Bids as grounds, by topics and fields alone, from messages written by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List

import pytest

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Ground, MonitoredTopic, TopicCondition, TopicJoin
from rqt_mrta_py.supervisor import bid_grounds
from tests.supervisor.mini import mission

PLAIN = MonitoredTopic("/bids", "p/Bid", "task", robot_field="who", bid_field="amount")
JOINED = MonitoredTopic(
    "/bids", "p/Bid", "auction", robot_field="who", join=TopicJoin("/news", "p/News", "id", "task"), bid_field="amount"
)


def told(topic: MonitoredTopic, *messages: Heard) -> List[Ground]:
    """Give what is made of messages by a topic of bids; each reader hears those of the topics that it asked for."""
    readers = bid_grounds(replace(mission().architecture, bids=(topic,)))
    grounds: List[Ground] = []
    for message in messages:
        for reader in readers:
            if message.topic in [wish.topic for wish in reader.subscriptions()]:
                grounds += reader.hear(message)
    return grounds


def bid(time: float, amount: Any, who: str = "/robot1", **fields: str) -> Heard:
    told_fields: Dict[str, Any] = {"who": who, "amount": amount, "task": "dig", **fields}
    return Heard("/bids", "p/Bid", time, told_fields)


def test_a_bid_is_a_ground_of_who_bids() -> None:
    assert told(PLAIN, bid(1.0, 2.5)) == [Ground(1.0, "dig", "bids 2.5", "robot1", {"bid": 2.5})]


def test_a_bid_told_again_is_no_new_ground_but_another_one_is() -> None:
    assert [each.text for each in told(PLAIN, bid(1.0, 2), bid(2.0, 2), bid(3.0, 3))] == ["bids 2", "bids 3"]


def test_what_stands_for_a_task_is_looked_up() -> None:
    news = Heard("/news", "p/News", 0.5, {"id": "a-1", "task": "/dig"})
    assert [each.task for each in told(JOINED, news, bid(1.0, 2.5, auction="a-1"))] == ["dig"]
    assert told(JOINED, news, bid(1.0, 2.5, auction="a-2")) == []


@pytest.mark.parametrize("amount", [float("nan"), float("inf"), "3", True, None, [1.0]])
def test_what_is_no_number_is_no_bid(amount: Any) -> None:
    assert told(PLAIN, bid(1.0, amount)) == []


def test_only_messages_that_meet_the_condition_count() -> None:
    topic = replace(PLAIN, condition=TopicCondition("open", "yes"))
    assert [each.time for each in told(topic, bid(1.0, 2.0, open="no"), bid(2.0, 3.0, open="yes"))] == [2.0]


def test_an_architecture_without_bids_reads_nothing() -> None:
    assert list(bid_grounds(mission().architecture)) == []
