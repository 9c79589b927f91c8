"""Plugins that take for ever are interrupted and named; nothing else is disturbed by the alarm."""

from __future__ import annotations

import logging
import re
import signal
import threading
import time
from types import ModuleType
from typing import Any, List

import pytest

from rqt_mrta_py.errors import HookError, MrtaError
from rqt_mrta_py.hooks import PluginManager, hookimpl
from rqt_mrta_py.hooks.patience import OutOfPatienceError, Patience
from rqt_mrta_py.model import Event, Severity

SHORT = 0.1
EVENT = Event(1.0, "robot_state", Severity.INFO, "robot1 is idle")


def module_of(name: str, text: str) -> Any:
    module = ModuleType(name)
    exec(compile(text, f"/plugins/{name}.py", "exec"), vars(module))
    return module


def for_ever() -> None:
    while True:
        time.sleep(0.01)


def test_code_that_does_not_return_is_interrupted_and_told_with_its_place() -> None:
    patience = Patience(SHORT)
    slow = module_of("slow_plugin", "def think():\n    while True:\n        pass\n")
    patience.know("slow_plugin.inner")

    with pytest.raises(OutOfPatienceError) as caught, patience.limit("the mission's tick at 12.35 s"):
        slow.think()

    place = r"in think \(/plugins/slow_plugin\.py:[23]\)"
    advice = r"RQT_MRTA_PY_PATIENCE sets another limit \[s\], 0 for none"
    message = rf"the mission's tick at 12\.35 s: no answer within 0\.1 s; interrupted {place}; {advice}"
    assert re.fullmatch(message, str(caught.value))
    assert isinstance(caught.value, MrtaError)


def test_the_place_is_the_innermost_code_of_a_plugin_whatever_library_it_calls() -> None:
    patience = Patience(SHORT)
    patience.know("outer_plugin")
    library = module_of("library", "def work(callback):\n    callback()\n")
    plugin = module_of("outer_plugin", "def ask(library, callback):\n    library.work(callback)\n")

    with pytest.raises(OutOfPatienceError, match=r"in ask \(/plugins/outer_plugin\.py:2\)"), patience.limit("it"):
        plugin.ask(library, for_ever)


def test_code_in_time_is_left_alone_and_so_is_what_follows() -> None:
    patience = Patience(SHORT)

    with patience.limit("it"):
        pass
    time.sleep(2 * SHORT)

    assert signal.getitimer(signal.ITIMER_REAL)[0] == 0.0


def test_what_the_code_raises_in_time_passes() -> None:
    with pytest.raises(ZeroDivisionError), Patience(SHORT).limit("it"):
        raise ZeroDivisionError


def test_code_that_swallows_every_exception_is_interrupted_all_the_same() -> None:
    def stubborn() -> None:
        while True:
            try:
                for_ever()
            except Exception:  # noqa: BLE001 - that is the point
                pass

    with pytest.raises(OutOfPatienceError), Patience(SHORT).limit("it"):
        stubborn()


def test_code_that_swallows_the_interruption_once_is_interrupted_again() -> None:
    caught: List[str] = []

    def stubborn() -> None:
        try:
            for_ever()
        except BaseException as error:  # noqa: BLE001 - that is the point
            caught.append(type(error).__name__)
        for_ever()

    with pytest.raises(OutOfPatienceError), Patience(SHORT).limit("it"):
        stubborn()

    assert len(caught) == 1


def test_an_outer_limit_stands_still_within_an_inner_one_and_then_goes_on() -> None:
    outer, inner = Patience(4 * SHORT), Patience(60.0)
    told: List[str] = []

    def work() -> None:
        with inner.limit("inner"):
            time.sleep(8 * SHORT)
        told.append("the inner one had its time")
        for_ever()

    with pytest.raises(OutOfPatienceError, match=r"^outer: "), outer.limit("outer"):
        work()

    assert told == ["the inner one had its time"]


def test_an_inner_limit_that_falls_is_told_by_its_own_name_and_the_outer_one_holds() -> None:
    with Patience(60.0).limit("outer"):
        with pytest.raises(OutOfPatienceError, match=r"^inner: "), Patience(SHORT).limit("inner"):
            for_ever()
        assert 0.0 < signal.getitimer(signal.ITIMER_REAL)[0] <= 60.0

    assert signal.getitimer(signal.ITIMER_REAL)[0] == 0.0


def test_no_limit_waits() -> None:
    with Patience(0.0).limit("it"):
        assert signal.getitimer(signal.ITIMER_REAL)[0] == 0.0


def test_off_the_main_thread_there_is_no_limit_and_no_failure() -> None:
    timers: List[float] = []

    def work() -> None:
        with Patience(SHORT).limit("it"):
            timers.append(signal.getitimer(signal.ITIMER_REAL)[0])

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()

    assert timers == [0.0]


def test_somebody_elses_alarm_is_left_to_them() -> None:
    rung: List[int] = []
    before = signal.signal(signal.SIGALRM, lambda number, frame: rung.append(number))
    try:
        signal.setitimer(signal.ITIMER_REAL, SHORT)
        with Patience(60.0).limit("it"):
            time.sleep(2 * SHORT)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)

    assert rung == [signal.SIGALRM]


def test_what_a_plugins_code_raises_at_work_is_told_with_its_place() -> None:
    patience = Patience()
    patience.know("failing_plugin")
    plugin = module_of("failing_plugin", "def think(helper):\n    return helper()\n")

    with pytest.raises(HookError) as caught, patience.at_work("the mission's tick at 3 s"):
        plugin.think(lambda: 1 / 0)

    assert str(caught.value) == (
        "the mission's tick at 3 s: ZeroDivisionError: division by zero, in think (/plugins/failing_plugin.py:2)"
    )
    assert isinstance(caught.value.__cause__, ZeroDivisionError)


def test_what_our_own_code_raises_at_work_stays_as_it_is() -> None:
    with pytest.raises(ZeroDivisionError), Patience().at_work("it"):
        raise ZeroDivisionError


def test_what_speaks_to_the_user_already_stays_as_it_is_at_work() -> None:
    patience = Patience()
    patience.know("failing_plugin")
    plugin = module_of("failing_plugin", "def think(error):\n    raise error\n")

    with pytest.raises(HookError, match=r"^as it is$"), patience.at_work("it"):
        plugin.think(HookError("as it is"))


def test_plugins_at_work_are_limited() -> None:
    with pytest.raises(OutOfPatienceError, match=r"^it: no answer within "), Patience(SHORT).at_work("it"):
        for_ever()


class Slow:
    """Takes for ever where it was told to."""

    def __init__(self, *where: str) -> None:
        self.where = where
        self.called: List[str] = []

    @hookimpl
    def mrta_register_agents(self) -> Any:
        return self.answer("agents", {"slow": print})

    @hookimpl
    def mrta_on_event(self, event: Event) -> None:
        self.answer("event", None)

    def answer(self, what: str, value: Any) -> Any:
        self.called.append(what)
        if what in self.where:
            for_ever()
        return value


def test_a_hook_that_takes_for_ever_stops_the_command_and_names_the_plugin() -> None:
    manager = PluginManager(Patience(SHORT))
    manager.register(Slow("agents"), "slow")

    with pytest.raises(
        HookError, match=r"^plugin 'slow': mrta_register_agents: no answer within 0\.1 s; interrupted in "
    ):
        manager.registered("mrta_register_agents")


def test_an_observer_that_takes_for_ever_is_logged_and_hears_no_more(caplog: pytest.LogCaptureFixture) -> None:
    manager = PluginManager(Patience(SHORT))
    slow, quick = Slow("event"), Slow()
    manager.register(slow, "slow")
    manager.register(quick, "quick")

    with caplog.at_level(logging.ERROR, "rqt_mrta_py.hooks"):
        manager.notify("mrta_on_event", event=EVENT)
        manager.notify("mrta_on_event", event=EVENT)

    assert (slow.called, quick.called) == (["event"], ["event", "event"])
    (message,) = caplog.messages
    assert message.startswith(
        "event=observer_dismissed plugin=slow hook=mrta_on_event: "
        "plugin 'slow': mrta_on_event: no answer within 0.1 s; interrupted in for_ever"
    )
