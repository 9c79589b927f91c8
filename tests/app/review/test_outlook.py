"""What is known of a block before it is taken in: places, ordinals and last messages, by hand."""

from __future__ import annotations

from typing import Dict, List, Tuple

import pytest

from rqt_mrta_py.app.habit import Habit
from rqt_mrta_py.app.review.habits import Speaker
from rqt_mrta_py.app.review.outlook import Outlook
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import Block, ConnectionList
from rqt_mrta_py.transport.routes import MetWish

_NS = 10**9


def connection(topic: str, caller: str) -> Connection:
    return Connection(topic, "std_msgs/Empty", "0" * 32, "", caller)


A, B, C = connection("/a", "/one"), connection("/a", "/two"), connection("/c", "/one")


def outlook_of(said: List[Connection], counts: Dict[str, int], again: Tuple[Connection, ...] = ()) -> Outlook:
    connections = ConnectionList()
    messages = [Stamped(each, number * _NS, b"") for number, each in enumerate(said)]
    block = Block.of(connections, messages)
    wish = MetWish(print, "", "", (), None, None)  # type: ignore[arg-type]
    habits = [Habit(False, False, False, False, None, (wish,) if each in again else ()) for each in connections]
    return Outlook(block, [Speaker(each, habit) for each, habit in zip(connections, habits)], counts)


def test_messages_of_a_topic_are_counted_whoever_says_them_and_from_block_to_block() -> None:
    counts = {"/a": 7}
    outlook = outlook_of([A, C, B, A, C], counts)
    assert [outlook.key(place) for place in range(5)] == [
        ("/a", 0.0, 7),
        ("/c", 1.0, 0),
        ("/a", 2.0, 8),
        ("/a", 3.0, 9),
        ("/c", 4.0, 1),
    ]
    assert counts == {"/a": 10, "/c": 2}


@pytest.mark.parametrize("before", [0, 20])
def test_the_last_message_of_each_connection_in_a_stretch(before: int) -> None:
    """Few messages are looked at in another way than many."""
    outlook = outlook_of([A] * before + [A, C, B, A, C, B, A], {}, again=(C,))
    last = {end: outlook.last_ones(0, before + end) for end in (1, 3, 5, 7)}
    assert last == {
        1: [before],
        3: [before, before + 1, before + 2],
        5: [before + 2, before + 3, before + 4],
        7: [before + 4, before + 5, before + 6],
    }
    assert outlook.last_ones(before + 1, before + 3) == [before + 1, before + 2]
    assert outlook.last_again(0, before + 4) == [before + 1]
    assert outlook.last_again(before + 2, before + 4) == []
    assert outlook.last_again(before + 2, before + 7) == [before + 4]
