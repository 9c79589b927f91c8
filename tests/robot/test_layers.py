"""Layers: the higher ones suppress the lower ones, actuator by actuator, tick by tick."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.errors import RobotError
from rqt_mrta_py.hooks import BehaviourStep, Command, Heard, Outgoing, Perception, Subscription
from rqt_mrta_py.model import Progress, Task, Twist
from rqt_mrta_py.robot.layers import LayeredBehaviour, suppressed, told_layers
from rqt_mrta_py.robot.perception import BehaviourPerception, Senses
from tests.robot.hosting import Digger, Scripted, about, hear, hear_progress, make_host, progress_codes, run

FORWARD = Command("base", Twist(vx=0.5))
BACK = Command("base", Twist(vx=-0.1))
LIFT = Command("arm", 1.0)
LOWER = Command("arm", -1.0)
LAYERED = Task("dig1", "dig", layers=("mow", "guard"))


def says(text: str) -> Outgoing:
    return Outgoing("speech", "std_msgs/String", {"data": text})


@dataclass
class Part:
    """A behaviour that plays back its steps, the last one for ever, and remembers what it was asked."""

    steps: Sequence[BehaviourStep] = (BehaviourStep(),)
    is_applicable: bool = True
    costs: Optional[float] = None
    topics: Sequence[str] = ()
    asked: List[Tuple[str, Task]] = field(default_factory=list)
    stepped: int = 0

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription(topic, "std_msgs/String", ("data",)) for topic in self.topics]

    def applicable(self, task: Task, perception: Perception) -> bool:
        self.asked.append(("applicable", task))
        return self.is_applicable

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        return self.costs

    def start(self, task: Task, perception: Perception) -> None:
        self.asked.append(("start", task))
        self.stepped = 0

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        self.asked.append(("step", task))
        self.stepped += 1
        return self.steps[min(self.stepped, len(self.steps)) - 1]


VIEW = BehaviourPerception(Senses())


def layered(task: Task = LAYERED, **parts: Any) -> LayeredBehaviour:
    behaviours = {"dig": Part(), "mow": Part(), "guard": Part(), **parts}
    return LayeredBehaviour(task, behaviours, dict.fromkeys(behaviours, VIEW))


def step(behaviour: LayeredBehaviour) -> BehaviourStep:
    return behaviour.step(LAYERED, VIEW)


@pytest.mark.parametrize(
    ("layers", "counted"),
    [
        ([], []),
        ([[FORWARD]], [FORWARD]),
        ([[FORWARD], [BACK]], [BACK]),
        ([[FORWARD], []], [FORWARD]),
        ([[FORWARD, LIFT], [BACK]], [BACK, LIFT]),
        ([[FORWARD], [LOWER], [BACK, LIFT]], [BACK, LIFT]),
    ],
)
def test_the_highest_layer_that_commands_an_actuator_counts(
    layers: List[List[Command]], counted: List[Command]
) -> None:
    assert suppressed(layers) == tuple(counted)


COMMANDS = st.lists(st.builds(Command, st.sampled_from("abcd"), st.floats(-1, 1)), unique_by=lambda each: each.actuator)


@given(st.lists(COMMANDS, max_size=5))
def test_each_actuator_obeys_one_layer_and_no_higher_one_commands_it(layers: List[List[Command]]) -> None:
    counted = suppressed(layers)
    by_actuator = {command.actuator: command for command in counted}
    assert len(by_actuator) == len(counted)
    assert set(by_actuator) == {command.actuator for layer in layers for command in layer}
    for actuator, command in by_actuator.items():
        commanding = [layer for layer in layers if any(each.actuator == actuator for each in layer)]
        assert any(each is command for each in commanding[-1])


@given(st.lists(COMMANDS, max_size=4), COMMANDS)
def test_a_layer_on_top_wins_and_touches_nothing_else(layers: List[List[Command]], top: List[Command]) -> None:
    before = {command.actuator: command for command in suppressed(layers)}
    after = {command.actuator: command for command in suppressed([*layers, top])}
    assert after == {**before, **{command.actuator: command for command in top}}


def test_a_layer_commands_an_actuator_once() -> None:
    with pytest.raises(ValueError, match="two commands to 'base' in one tick"):
        suppressed([[LIFT], [FORWARD, BACK]])


def test_a_layer_suppresses_only_while_it_commands() -> None:
    behaviour = layered(
        dig=Part([BehaviourStep((FORWARD,))]),
        mow=Part([BehaviourStep(), BehaviourStep((BACK,)), BehaviourStep()]),
    )
    assert [tuple(step(behaviour).commands) for _ in range(3)] == [(FORWARD,), (BACK,), (FORWARD,)]


def test_all_layers_are_heard_lower_ones_first() -> None:
    behaviour = layered(
        guard=Part([BehaviourStep((BACK,), messages=[says("guard")])]),
        dig=Part([BehaviourStep((FORWARD,), messages=[says("dig")])]),
        mow=Part([BehaviourStep(messages=[says("mow"), says("on")])]),
    )
    assert [said.fields["data"] for said in step(behaviour).messages] == ["dig", "mow", "on", "guard"]


@pytest.mark.parametrize("progress", [Progress.FAILED, Progress.UNREACHABLE])
def test_a_higher_layer_that_fails_ends_the_task(progress: Progress) -> None:
    behaviour = layered(guard=Part([BehaviourStep(progress=progress, detail="bumped")]))
    assert (step(behaviour).progress, step(behaviour).detail) == (progress, "layer guard: bumped")


def test_a_higher_layer_that_is_done_takes_no_more_steps_until_the_task_begins_anew() -> None:
    guard = Part([BehaviourStep((BACK,)), BehaviourStep((BACK,), Progress.DONE)])
    behaviour = layered(dig=Part([BehaviourStep((FORWARD,))]), guard=guard)
    commands = [tuple(step(behaviour).commands) for _ in range(4)]
    assert commands == [(BACK,), (BACK,), (FORWARD,), (FORWARD,)]
    assert (step(behaviour).progress, guard.stepped) == (Progress.RUNNING, 2)
    behaviour.start(LAYERED, VIEW)
    assert tuple(step(behaviour).commands) == (BACK,)


@pytest.mark.parametrize("progress", [Progress.DONE, Progress.FAILED, Progress.UNREACHABLE])
def test_the_lowest_layer_ends_the_task_whatever_higher_ones_say(progress: Progress) -> None:
    behaviour = layered(
        dig=Part([BehaviourStep(progress=progress, detail="deep enough")]),
        mow=Part([BehaviourStep(progress=Progress.FAILED, detail="no grass")]),
    )
    assert (step(behaviour).progress, step(behaviour).detail) == (progress, "deep enough")


def test_of_two_higher_layers_that_fail_the_lower_one_says_how() -> None:
    behaviour = layered(
        mow=Part([BehaviourStep(progress=Progress.UNREACHABLE)]), guard=Part([BehaviourStep(progress=Progress.FAILED)])
    )
    assert (step(behaviour).progress, step(behaviour).detail) == (Progress.UNREACHABLE, "layer mow")


@pytest.mark.parametrize("applicable", [True, False])
def test_the_lowest_layer_alone_says_what_the_task_costs_and_whether_it_is_applicable(applicable: bool) -> None:
    others = Part(is_applicable=not applicable, costs=9.0)
    behaviour = layered(dig=Part(is_applicable=applicable, costs=3.0), mow=others, guard=others)
    assert [behaviour.applicable(LAYERED, VIEW) for _ in range(2)] == [applicable] * 2
    assert behaviour.cost(LAYERED, VIEW) == 3.0


def test_higher_layers_are_asked_once_so_that_they_can_refuse_the_task() -> None:
    mow = Part()
    behaviour = layered(mow=mow)
    for _ in range(3):
        behaviour.applicable(LAYERED, VIEW)
    assert [asked for asked, _ in mow.asked] == ["applicable"]


def test_all_layers_begin_with_the_task() -> None:
    parts = {kind: Part() for kind in ("dig", "mow", "guard")}
    layered(**parts).start(LAYERED, VIEW)
    assert [[asked for asked, _ in part.asked] for part in parts.values()] == [["start"]] * 3


def test_each_layer_is_told_the_task_as_its_own() -> None:
    data = {"depth": 2.0, "layers": {"guard": {"distance": 0.3}}}
    task = Task("dig1", "dig", capabilities=("shovel",), data=data, layers=("mow", "guard"))
    lowest, mow, guard = told_layers(task)
    assert lowest == Task("dig1", "dig", capabilities=("shovel",), data={"depth": 2.0})
    assert mow == Task("dig1", "mow", capabilities=("shovel",))
    assert guard == Task("dig1", "guard", capabilities=("shovel",), data={"distance": 0.3})


def test_a_layer_is_handed_the_same_task_every_time() -> None:
    """Behaviours know a task again by its identity, and read its data once."""
    mow = Part()
    behaviour = layered(mow=mow)
    behaviour.start(LAYERED, VIEW)
    step(behaviour)
    step(behaviour)
    assert len({id(task) for _, task in mow.asked}) == 1


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ({"layers": [1]}, "data/layers: must hold data by layer (got [1])"),
        ({"layers": {"gaurd": {}}}, "data/layers/gaurd: is no layer of the task; nearest is 'guard'"),
        ({"layers": {"dig": {}}}, "data/layers/dig: is no layer of the task; accepted: mow, guard"),
        ({"layers": {"mow": 3}}, "data/layers/mow: must be a mapping (got 3)"),
    ],
)
def test_data_that_tell_nobody_anything_are_refused(data: Mapping[str, Any], message: str) -> None:
    with pytest.raises(ValueError) as caught:  # noqa: PT011 - the whole message follows
        layered(Task("dig1", "dig", data=data, layers=("mow", "guard")))
    assert str(caught.value) == message


@pytest.mark.parametrize(
    ("layers", "message"),
    [
        (("mow", "mow"), "layer 'mow' stands twice; give each once, the task's own kind not at all"),
        (("dig",), "layer 'dig' stands twice; give each once, the task's own kind not at all"),
        (("mown",), "no behaviour is of the kind of its layer 'mown'; nearest is 'mow'"),
    ],
)
def test_layers_that_cannot_stand_are_refused(layers: Tuple[str, ...], message: str) -> None:
    with pytest.raises(ValueError) as caught:  # noqa: PT011 - the whole message follows
        layered(Task("dig1", "dig", layers=layers))
    assert str(caught.value) == message


def test_every_layer_hears_its_own_topics() -> None:
    behaviour = layered(dig=Part(topics=["a"]), mow=Part(topics=["b", "c"]))
    assert [wish.topic for wish in behaviour.subscriptions()] == ["a", "b", "c"]


class TestInAHost:
    """A robot whose task has a layer: what is driven, said and told in the end."""

    def test_what_higher_layers_command_is_driven(self) -> None:
        guard = Digger([BehaviourStep(), BehaviourStep((BACK,)), BehaviourStep()])
        host = make_host(Scripted(lambda _: "roam"), (Task("roam", "dig", layers=("guard",)),), guard=guard)
        driven = [fields["linear"]["x"] for fields in about(run(host, 4), "cmd_vel")]
        assert driven == [0.5, -0.1, 0.5, 0.5]

    def test_a_layer_hears_what_it_asked_for(self) -> None:
        guard = Digger()
        host = make_host(Scripted(lambda _: "roam"), (Task("roam", "dig", layers=("guard",)),), guard=guard)
        hear(host, "scan", {"ranges": [1.0]})
        run(host, 1)
        (seen,) = guard.seen
        assert isinstance(seen, Heard)
        assert seen.fields == {"ranges": [1.0]}

    def test_a_layer_that_fails_is_told_to_the_team(self) -> None:
        guard = Digger([BehaviourStep(progress=Progress.FAILED, detail="bumped")])
        host = make_host(Scripted(lambda _: "roam"), (Task("roam", "dig", layers=("guard",)),), guard=guard)
        said = run(host, 1)
        assert progress_codes(said) == [("roam", Progress.RUNNING.code), ("roam", Progress.FAILED.code)]
        assert about(said, "/mrta/task_progress")[-1]["detail"] == "layer guard: bumped"

    def test_two_tasks_share_the_behaviours_of_their_layers(self) -> None:
        dig, guard = Digger(), Digger([BehaviourStep((LIFT,))])
        tasks = (Task("roam", "dig", layers=("guard",)), Task("watch", "guard"))
        host = make_host(Scripted(lambda turn: "roam" if turn < 2 else "watch"), tasks, dig=dig, guard=guard)
        run(host, 4)
        assert (dig.started, dig.stepped, guard.started, guard.stepped) == (1, 2, 2, 2)

    def test_a_task_that_appears_brings_its_layers(self) -> None:
        guard = Digger([BehaviourStep((BACK,))])
        host = make_host(Scripted(lambda turn: "roam" if turn else None), (Task("other", "guard"),), guard=guard)
        definition = "id: roam\nkind: dig\nlayers: [guard]\n"
        hear_progress(host, "roam", "", Progress.APPEARED.code, definition=definition)
        assert [fields["linear"]["x"] for fields in about(run(host, 2), "cmd_vel")] == [-0.1]

    def test_a_layer_nobody_knows_is_refused_by_name(self) -> None:
        with pytest.raises(RobotError) as caught:
            make_host(Scripted(lambda _: None), (Task("roam", "dig", layers=("gaurd",)),), guard=Digger())
        message = "robot1: task 'roam': no behaviour is of the kind of its layer 'gaurd'; nearest is 'guard'"
        assert str(caught.value) == message

    @pytest.mark.parametrize(
        ("answer", "cause"),
        [
            (None, "TypeError: answered None; accepted is BehaviourStep"),
            (BehaviourStep((FORWARD, BACK)), "ValueError: two commands to 'base' in one tick; at most one is accepted"),
            (
                BehaviourStep(progress=Progress.WITHDRAWN),
                f"ValueError: a progress of {Progress.WITHDRAWN!r}; RUNNING, DONE, FAILED, UNREACHABLE are accepted",
            ),
        ],
    )
    def test_a_layer_that_answers_amiss_is_named(self, answer: Any, cause: str) -> None:
        guard = Digger([answer])
        host = make_host(Scripted(lambda _: "roam"), (Task("roam", "dig", layers=("guard",)),), guard=guard)
        with pytest.raises(RobotError) as caught:
            run(host, 1)
        where = "robot1: behaviour 'dig' on task 'roam' failed at 1.000 s: LayerError: guard"
        assert str(caught.value) == f"{where}: {cause}"

    def test_a_layer_can_refuse_what_it_is_told_before_anything_moves(self) -> None:
        class Picky(Digger):
            def applicable(self, task: Task, perception: Perception) -> bool:
                raise ValueError(f"data has no {sorted(task.data)}")

        data: Dict[str, Any] = {"layers": {"guard": {"x": 1}}}
        with pytest.raises(RobotError) as caught:
            make_host(Scripted(lambda _: None), (Task("roam", "dig", data=data, layers=("guard",)),), guard=Picky())
        where = "robot1: behaviour 'dig' on task 'roam' cannot begin: LayerError: guard"
        assert str(caught.value) == f"{where}: ValueError: data has no ['x']"
