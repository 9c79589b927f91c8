"""ROS time: the wall's, and a simulated one that may go backwards."""

from __future__ import annotations

import struct
import time
from typing import List

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.transport.ros1 import clock as clock_module
from rqt_mrta_py.transport.ros1.clock import RosClock
from tests.ros_master import MasterProcess
from tests.ros_process import PythonProcess
from tests.transport.ros1.nodes import OURS


def test_receipts_do_not_follow_the_wall_clock_backwards(monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter([1000, 3000, 2000, 2500, 4000])
    monkeypatch.setattr(clock_module, "_wall_ns", lambda: next(times))
    clock = RosClock(simulated=False)
    assert [clock.receipt() for _ in range(5)] == [1000, 3000, 3000, 3000, 4000]


def test_simulated_time_is_zero_until_it_is_told() -> None:
    clock = RosClock(simulated=True)
    assert (clock.now(), clock.receipt()) == (0.0, 0)
    assert clock.tick(struct.pack("<II", 12, 500_000_000)) is None
    assert (clock.now(), clock.receipt()) == (12.5, 12_500_000_000)
    with pytest.raises(struct.error):
        clock.tick(b"short")
    assert clock.now() == 12.5


@settings(deadline=None, max_examples=50)
@given(st.lists(st.integers(0, 2**32 * 10**9 - 1), max_size=20))
def test_jumps_are_told_exactly_where_time_goes_back(times: List[int]) -> None:
    clock, before = RosClock(simulated=True), 0
    for now in times:
        jump = clock.tick(struct.pack("<II", *divmod(now, 10**9)))
        assert jump == ((before / 10**9, now / 10**9) if now < before else None)
        assert clock.receipt() == now
        before = now


@pytest.mark.ros
def test_clock_that_goes_backwards_is_told_before_any_later_message(own_master: MasterProcess) -> None:
    own_master.start()
    own_master.ask("setParam", "/use_sim_time", True)
    with PythonProcess(own_master.environment) as process:
        process.do(OURS + "node = RosNode.start('node', codec); told = []; assert node.now() == 0.0")
        process.do("node.on_time_jump(lambda old, new: told.append(['jump', old, new]))")
        process.do("node.hear(lambda t, k: t == '/clock', lambda h: told.append(['clock', h.receipt_ns / 1e9]))")
        process.do("node.hear(lambda t, k: t == '/news', lambda h: told.append(['news', h.receipt_ns / 1e9]))")
        process.do("for t in ('/clock rosgraph_msgs/Clock', '/news std_msgs/String'): node.advertise(*t.split())")
        process.until("all(mouth.is_heard for mouth in node._mouths._by_topic.values())")
        expected: List[object] = []
        for now in (5.0, 7.5, 2.0, 2.25):
            if now == 2.0:
                expected.append(["jump", 7.5, 2.0])
            expected += [["clock", now], ["news", now]]
            process.do(f"node.publish(Outgoing('/clock', 'rosgraph_msgs/Clock', {{'clock': {now}}}), {now})")
            process.until(f"node.now() == {now} and told[-1][0] == 'clock'")
            process.do(f"node.publish(Outgoing('/news', 'std_msgs/String', {{}}), {now})")
            process.until("told[-1][0] == 'news'")
        assert process.ask("told") == expected
        process.do("import rospy")
        assert process.ask("rospy.Time.now().to_sec()") == 2.25
        process.do("node.shut_down('the test is over')")


def test_wall_clock_is_the_time_otherwise() -> None:
    before = time.time()
    assert before <= RosClock(simulated=False).now() <= time.time()
