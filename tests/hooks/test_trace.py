"""The trace of hook calls."""

from __future__ import annotations

import logging
from typing import Any, List

import pytest

from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import PluginManager, hookimpl
from rqt_mrta_py.hooks.trace import HookTrace
from rqt_mrta_py.model import Event, Severity

EVENT = Event(1.0, "robot_state", Severity.INFO, "robot1 is idle")


class Plugin:
    def __init__(self, agents: Any) -> None:
        self.agents = agents

    @hookimpl
    def mrta_register_agents(self) -> Any:
        return self.agents()

    @hookimpl
    def mrta_on_event(self) -> None:
        pass


def manager_of(agents: Any, *times: float) -> PluginManager:
    """Make a manager whose trace begins at the first of these times and looks at the clock at each other [s]."""
    clock = iter(times)
    manager = PluginManager(trace=HookTrace(logging.getLogger("trace"), lambda: next(clock)))
    manager.register(Plugin(agents), "mine")
    return manager


def test_each_call_is_a_line_with_time_plugin_hook_and_what_came_of_it(caplog: pytest.LogCaptureFixture) -> None:
    manager = manager_of(lambda: {"b": print, "a": print}, 100.0, 100.25, 100.2625, 101.0, 101.0)

    with caplog.at_level(logging.INFO, "trace"):
        manager.registered("mrta_register_agents")
        manager.notify("mrta_on_event", event=EVENT)

    assert caplog.messages == [
        "at_ms=250.000 plugin=mine hook=mrta_register_agents took_ms=12.500 returned={b,a}",
        "at_ms=1000.000 plugin=mine hook=mrta_on_event took_ms=0.000 returned=None",
    ]


def test_what_is_registered_is_asked_for_once_until_a_plugin_comes() -> None:
    asked: List[str] = []

    def agents() -> Any:
        asked.append("agents")
        return {"a": print}

    manager = PluginManager()
    manager.register(Plugin(agents), "one")
    for _ in range(3):
        manager.registered("mrta_register_agents").clear()
    assert (asked, list(manager.registered("mrta_register_agents"))) == (["agents"], ["a"])

    manager.register(Plugin(lambda: {"b": print}), "two")
    assert list(manager.registered("mrta_register_agents")) == ["a", "b"]


def test_a_call_that_raises_is_a_line_too(caplog: pytest.LogCaptureFixture) -> None:
    manager = manager_of(lambda: 1 / 0, 0.0, 0.0, 0.001)

    with caplog.at_level(logging.INFO, "trace"), pytest.raises(HookError):
        manager.registered("mrta_register_agents")

    assert caplog.messages == [
        "at_ms=0.000 plugin=mine hook=mrta_register_agents took_ms=1.000 raised=ZeroDivisionError"
    ]


@pytest.mark.parametrize(
    ("answer", "shown"),
    [
        ({str(number): print for number in range(10)}, "{0,1,2,3,4,5,6,7,and 2 more}"),
        (("a", "b"), "2 of tuple"),
        ("x" * 100, "'" + "x" * 59 + "..."),
    ],
)
def test_what_came_back_is_told_in_short(answer: Any, shown: str, caplog: pytest.LogCaptureFixture) -> None:
    trace = HookTrace(logging.getLogger("trace"), lambda: 0.0)

    with caplog.at_level(logging.INFO, "trace"):
        assert trace.call("mine", "hook", lambda: answer) is answer

    assert caplog.messages == [f"at_ms=0.000 plugin=mine hook=hook took_ms=0.000 returned={shown}"]
