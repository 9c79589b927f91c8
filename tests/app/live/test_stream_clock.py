"""Times of receipt of a live stream."""

from __future__ import annotations

from typing import List, Tuple

from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.app.live.stream_clock import StreamClock
from rqt_mrta_py.hooks import Connection, Stamped

ANY = Connection("/any", "std_msgs/Empty", "0" * 32, "")


class Ros:
    """A ROS time that a test sets [ns]."""

    def __init__(self) -> None:
        self.ns = 0

    def now(self) -> float:
        return self.ns / 1e9


@given(st.lists(st.tuples(st.integers(-5_000, 5_000), st.integers(0, 3)), max_size=40))
def test_receipts_never_go_back_whatever_ros_time_does(steps: List[Tuple[int, int]]) -> None:
    ros = Ros()
    ros.ns = 10**9
    clock = StreamClock(ros.now)
    receipts = []
    for change, messages in steps:
        ros.ns = max(1, ros.ns + change * 1_000_000)
        if change < 0:
            clock.jump(ros.now())
        if messages:
            receipts += [each.receipt_ns for each in clock.stamped([Stamped(ANY, ros.ns, b"")] * messages)]
        else:
            receipts.append(clock.receipt())
    assert receipts == sorted(receipts)
    assert clock.jumps == sum(change < 0 for change, _ in steps)


def test_receipts_go_on_from_the_newest_as_fast_as_ros_time() -> None:
    ros = Ros()
    clock = StreamClock(ros.now)
    ros.ns = 100_000_000_000
    assert clock.receipt() == 100_000_000_000
    ros.ns = 5_000_000_000
    clock.jump(5.0)
    ros.ns = 7_000_000_000
    assert clock.receipt() == 102_000_000_000
    assert clock.stamped([Stamped(ANY, 8_000_000_000, b"")])[0].receipt_ns == 103_000_000_000


def test_looking_stamps_nothing() -> None:
    ros = Ros()
    clock = StreamClock(ros.now)
    ros.ns = 3_000_000_000
    assert clock.look() == 3_000_000_000
    assert clock.stamped([Stamped(ANY, 2_000_000_000, b"")])[0].receipt_ns == 2_000_000_000
