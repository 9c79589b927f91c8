"""The plugin manager: contract first, then order, then isolation."""

from __future__ import annotations

import logging
from typing import Any, Dict, List, Mapping, Sequence

import pluggy
import pytest

from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import HookSpecs, ParameterProblem, PluginManager, Verb, hookimpl
from rqt_mrta_py.hooks.contract import HOOKS
from rqt_mrta_py.model import Event, Severity

EVENT = Event(1.0, "robot_state", Severity.INFO, "robot1 is idle")
VERB = Verb("does nothing", lambda parser: None, lambda options, tools: 0)
CHECK: Dict[str, Any] = {"architecture": "a", "robot_id": "r", "parameters": {}, "tasks": ()}


def manager_of(**plugins: object) -> PluginManager:
    manager = PluginManager()
    for name, plugin in plugins.items():
        manager.register(plugin, name)
    return manager


def said(plugin: object) -> str:
    manager = PluginManager()
    with pytest.raises(HookError) as caught:
        manager.register(plugin, "mine")
    assert manager.names == ()
    return str(caught.value)


class Agents:
    def __init__(self, *names: str) -> None:
        self.factories = dict.fromkeys(names, lambda setup: self)

    @hookimpl
    def mrta_register_agents(self) -> Mapping[str, Any]:
        return self.factories


class Answers:
    """Answers both kinds of question with what it was given."""

    def __init__(self, answer: Any) -> None:
        self.answer = answer

    @hookimpl
    def mrta_register_robot_models(self) -> Any:
        return self.answer

    @hookimpl
    def mrta_register_agents(self) -> Any:
        return self.answer

    @hookimpl
    def mrta_register_verbs(self) -> Any:
        return self.answer

    @hookimpl
    def mrta_register_benchmarks(self) -> Any:
        return self.answer

    @hookimpl
    def mrta_register_exporters(self) -> Any:
        return self.answer

    @hookimpl
    def mrta_check_parameters(self) -> Any:
        return self.answer


def test_registered_joins_plugins_in_the_order_of_their_registration() -> None:
    forward = manager_of(one=Agents("b", "a"), two=Agents("c"))
    backward = manager_of(two=Agents("c"), one=Agents("b", "a"))

    assert list(forward.registered("mrta_register_agents")) == ["b", "a", "c"]
    assert list(backward.registered("mrta_register_agents")) == ["c", "b", "a"]


def test_registered_keeps_the_first_of_a_name_and_logs_the_other(caplog: pytest.LogCaptureFixture) -> None:
    one, two = Agents("a"), Agents("a", "b")

    with caplog.at_level(logging.WARNING, "rqt_mrta_py.hooks"):
        found = manager_of(one=one, two=two).registered("mrta_register_agents")

    assert found == {"a": one.factories["a"], "b": two.factories["b"]}
    assert caplog.messages == ["event=collision hook=mrta_register_agents name=a kept=one dropped=two"]


def test_registered_is_empty_without_plugins() -> None:
    assert PluginManager().registered("mrta_register_worlds") == {}


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (None, "mrta_register_agents returned None; a mapping by name is needed"),
        (["a"], "mrta_register_agents returned ['a']; a mapping by name is needed"),
        ({1: print}, "mrta_register_agents registers under 1; a name is needed"),
        ({"a": 1}, "mrta_register_agents registers 'a' as 1; something callable is needed"),
    ],
)
def test_registered_refuses_what_does_not_fit_and_names_plugin_and_hook(answer: Any, message: str) -> None:
    with pytest.raises(HookError) as caught:
        manager_of(mine=Answers(answer)).registered("mrta_register_agents")

    assert str(caught.value) == f"plugin 'mine': {message}"


@pytest.mark.parametrize(
    ("hook", "type_name"),
    [
        ("mrta_register_robot_models", "RobotModel"),
        ("mrta_register_verbs", "Verb"),
        ("mrta_register_benchmarks", "Benchmark"),
    ],
)
def test_registered_wants_values_of_their_type(hook: str, type_name: str) -> None:
    with pytest.raises(HookError, match=f"{hook} registers 'm' as 'big'; a {type_name} is needed"):
        manager_of(mine=Answers({"m": "big"})).registered(hook)


@pytest.mark.parametrize("name", ["Plan", "plan_structure", "plan structure", "-plan", "plan-", "../plan", "plan\n"])
def test_registered_wants_names_of_verbs_that_can_be_typed(name: str) -> None:
    with pytest.raises(HookError) as caught:
        manager_of(mine=Answers({name: VERB})).registered("mrta_register_verbs")

    assert str(caught.value) == (
        f"plugin 'mine': mrta_register_verbs registers under {name!r}; "
        "lower case letters and digits, joined by '-', are accepted"
    )


def test_registered_wants_names_of_exporters_that_can_be_folders() -> None:
    with pytest.raises(HookError, match=r"under '\.\./csv'; lower case letters and digits, joined by '-' or '_', are"):
        manager_of(mine=Answers({"../csv": print})).registered("mrta_register_exporters")


def test_registered_takes_what_fits() -> None:
    manager = manager_of(mine=Answers({"plan-2": VERB}))

    assert manager.registered("mrta_register_verbs") == {"plan-2": VERB}


def test_registered_names_the_plugin_that_raised_and_keeps_the_cause() -> None:
    class Broken:
        @hookimpl
        def mrta_register_agents(self) -> Any:
            raise ZeroDivisionError("by zero")

    with pytest.raises(HookError) as caught:
        manager_of(fine=Agents("a"), broken=Broken()).registered("mrta_register_agents")

    assert str(caught.value) == "plugin 'broken': mrta_register_agents raised ZeroDivisionError: by zero"
    assert isinstance(caught.value.__cause__, ZeroDivisionError)


def test_problems_are_joined_in_order_and_arguments_given_by_name() -> None:
    class Check:
        def __init__(self, path: str) -> None:
            self.path = path

        @hookimpl
        def mrta_check_parameters(self, robot_id: str, architecture: str) -> Sequence[ParameterProblem]:
            return [ParameterProblem(self.path, f"{architecture} {robot_id}")]

    found = manager_of(one=Check("x"), two=Check("y")).problems("mrta_check_parameters", **CHECK)

    assert found == (ParameterProblem("x", "a r"), ParameterProblem("y", "a r"))


@pytest.mark.parametrize("answer", [None, "text", 1, [("path", "message")], {"path": "message"}])
def test_problems_refuses_what_does_not_fit(answer: Any) -> None:
    with pytest.raises(HookError, match=r"plugin 'mine': mrta_check_parameters returned .* is needed"):
        manager_of(mine=Answers(answer)).problems("mrta_check_parameters", **CHECK)


def test_notify_tells_all_in_order_and_logs_the_one_that_raises(caplog: pytest.LogCaptureFixture) -> None:
    told: List[str] = []

    class Observer:
        def __init__(self, name: str) -> None:
            self.name = name

        @hookimpl
        def mrta_on_event(self, event: Event) -> None:
            told.append(f"{self.name}: {event.text}")
            if self.name == "two":
                raise RuntimeError("no")

    manager = manager_of(**{name: Observer(name) for name in ("one", "two", "three")})
    with caplog.at_level(logging.ERROR, "rqt_mrta_py.hooks"):
        manager.notify("mrta_on_event", event=EVENT)

    assert told == ["one: robot1 is idle", "two: robot1 is idle", "three: robot1 is idle"]
    assert caplog.messages == ["event=observer_failed plugin=two hook=mrta_on_event"]


def test_owner_tells_whose_registration_won() -> None:
    manager = manager_of(one=Agents("a"), two=Agents("a", "b"))

    assert manager.owner("mrta_register_agents", "a") == "one"
    assert manager.owner("mrta_register_agents", "b") == "two"
    with pytest.raises(KeyError):
        manager.owner("mrta_register_agents", "c")


def test_calls_that_the_host_gets_wrong_are_programming_mistakes() -> None:
    manager = PluginManager()

    with pytest.raises(ValueError, match="'mrta_on_event' is no mrta_register_\\* hook"):
        manager.registered("mrta_on_event")
    with pytest.raises(ValueError, match="nearest is 'mrta_register_agents'"):
        manager.registered("mrta_register_agent")
    with pytest.raises(TypeError, match=r"mrta_on_event\(event\) was called with \(evnt\)"):
        manager.notify("mrta_on_event", evnt=EVENT)


def test_register_refuses_an_unknown_hook_and_names_the_nearest() -> None:
    class Plugin:
        @hookimpl
        def mrta_register_agent(self, setup: Any) -> Any:
            return setup

    assert said(Plugin()) == (
        "plugin 'mine': mrta_register_agent(setup) implements mrta_register_agent, which is no hook; "
        "nearest is mrta_register_agents()"
    )


def test_register_refuses_an_argument_that_the_hook_does_not_give() -> None:
    class Plugin:
        @hookimpl
        def mrta_on_event(self, event: Event, robot: str) -> None:
            pass

    assert said(Plugin()) == (
        "plugin 'mine': mrta_on_event(event, robot) asks for 'robot', which the hook does not give; "
        "the contract says mrta_on_event(event)"
    )


def test_register_refuses_what_pluggy_would_pass_over_in_silence() -> None:
    class Plugin:
        @hookimpl
        def mrta_on_event(self, event: Any = None) -> None:
            pass

        @hookimpl
        def mrta_on_mission_end(self, **rest: Any) -> None:
            pass

        @hookimpl(tryfirst=True)
        def mrta_register_agents(self) -> Any:
            pass

        def mrta_register_worlds(self) -> Any:
            pass

    assert said(Plugin()) == (
        "plugin 'mine': mrta_on_event(event=None) has a default for 'event', which then is never given; "
        "the contract says mrta_on_event(event); "
        "mrta_on_mission_end(**rest) takes **rest, which no hook fills in; the contract says "
        "mrta_on_mission_end(record); "
        "mrta_register_agents() asks for tryfirst, but plugins are asked in the order of discovery; leave it out; "
        "mrta_register_worlds() is not marked; put @hookimpl above it"
    )


def test_register_refuses_two_implementations_of_one_hook_in_one_plugin() -> None:
    class Plugin:
        @hookimpl
        def mrta_on_event(self) -> None:
            pass

        @hookimpl(specname="mrta_on_event")
        def second(self) -> None:
            pass

    assert said(Plugin()) == (
        "plugin 'mine': mrta_on_event and second both implement mrta_on_event; one plugin answers a hook once"
    )


def test_register_refuses_a_name_or_plugin_twice() -> None:
    plugin = Agents("a")
    manager = manager_of(one=plugin)

    with pytest.raises(HookError, match="plugin 'one' is registered already"):
        manager.register(Agents("b"), "one")
    with pytest.raises(HookError, match="plugin 'two' is registered already, under another name"):
        manager.register(plugin, "two")
    assert manager.names == ("one",)


def test_register_does_not_look_behind_properties() -> None:
    class Plugin(Agents):
        @property
        def mrta_trap(self) -> None:
            raise RuntimeError("looked")

    assert list(manager_of(one=Plugin("a")).registered("mrta_register_agents")) == ["a"]


def test_every_specification_is_a_hook_with_pluggys_idea_of_its_arguments() -> None:
    plain = pluggy.PluginManager("rqt_mrta_py")
    plain.add_hookspecs(HookSpecs)

    for name, signature in HOOKS.items():
        specification = getattr(plain.hook, name).spec
        assert tuple(signature.parameters) == tuple(specification.argnames)
