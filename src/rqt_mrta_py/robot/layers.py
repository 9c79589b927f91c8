"""Behaviours one above the other: higher layers suppress lower ones (Brooks 1986, subsumption)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple, TypeVar

from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.hooks import Behaviour, BehaviourStep, Command, Outgoing, Perception, Subscription
from rqt_mrta_py.model import Progress, Task
from rqt_mrta_py.robot.asking import checked
from rqt_mrta_py.wording import accepted, shown

__all__ = ["LAYERS_DATA", "LayerError", "LayeredBehaviour", "suppressed", "told_layers"]

LAYERS_DATA = "layers"
"""Under this key the data of a task with layers holds what is told to each of them, by kind."""

_TOLD = (Progress.RUNNING, Progress.DONE, Progress.FAILED, Progress.UNREACHABLE)
_ENDS_TASK = (Progress.FAILED, Progress.UNREACHABLE)

_Answer = TypeVar("_Answer")


class LayerError(Exception):
    """What a higher layer raised, told with its kind."""


class _Layer(NamedTuple):
    """One behaviour with the task as it is told, and what it perceives."""

    kind: str
    behaviour: Behaviour
    task: Task
    perception: Perception


def suppressed(commands: Sequence[Sequence[Command]]) -> Tuple[Command, ...]:
    """Join what layers command: of those that command one actuator, the highest counts.

    Differs from the paper: a suppression lasts for one tick, not for a time constant of its own; a layer that wants
    more commands again.

    Args:
        commands: of each layer, from lower to higher.

    Returns:
        One command for each actuator, in the order in which the layers, lower ones first, name them.

    Raises:
        ValueError: a layer commands one actuator twice.
    """
    counted: Dict[str, Command] = {}
    for layer in commands:
        named: Set[str] = set()
        for command in layer:
            if command.actuator in named:
                raise ValueError(f"two commands to {command.actuator!r} in one tick; at most one is accepted")
            named.add(command.actuator)
            counted[command.actuator] = command
    return tuple(counted.values())


def told_layers(task: Task) -> Tuple[Task, ...]:
    """Say what each layer of a task is told: the same task, of its own kind, with its own data.

    Args:
        task: with layers; ``data/layers/<kind>`` holds what is told to one of them, all else is for the lowest.

    Returns:
        The task for each layer, the behaviour that carries it out first.

    Raises:
        ValueError: the data tell something to what is no layer, or not by keys.
    """
    told = task.data.get(LAYERS_DATA, {})
    if not isinstance(told, Mapping):
        raise ValueError(f"data/{LAYERS_DATA}: must hold data by layer (got {shown(told)})")
    for kind, data in told.items():
        where = f"data/{LAYERS_DATA}/{kind}"
        if kind not in task.layers:
            raise ValueError(f"{where}: is no layer of the task; {accepted(str(kind), task.layers)}")
        if not isinstance(data, Mapping):
            raise ValueError(f"{where}: must be a mapping (got {shown(data)})")
    own = {key: value for key, value in task.data.items() if key != LAYERS_DATA}
    lowest = replace(task, data=own, layers=())
    return (lowest, *(replace(task, kind=kind, data=dict(told.get(kind, {})), layers=()) for kind in task.layers))


class LayeredBehaviour:
    """Carries out one task with several behaviours at once; implements Behaviour.

    The task's own kind is the lowest layer: what it costs, whether it is applicable and when it is done, this one says.
    Every layer takes every step, from lower to higher, and knows nothing of the others. While a higher layer commands
    an actuator, what lower ones command it does not count. What layers say is all said, the lowest first. A higher
    layer that is DONE takes no more steps until the task is begun anew; one that is FAILED or UNREACHABLE ends the
    task. Where several end it at once, the lowest says how.

    Args:
        task: that will be carried out.
        behaviours: of the robot, by kind; other tasks may share them.
        views: what each of them perceives, by the same kinds.

    Raises:
        ValueError: no behaviour is of the kind of a layer, a layer stands twice, or its data make no sense.
    """

    def __init__(self, task: Task, behaviours: Mapping[str, Behaviour], views: Mapping[str, Perception]) -> None:
        kinds = (task.kind, *task.layers)
        for index, kind in enumerate(kinds):
            if kind not in behaviours:
                raise ValueError(f"no behaviour is of the kind of its layer {kind!r}; {accepted(kind, behaviours)}")
            if kind in kinds[:index]:
                raise ValueError(f"layer {kind!r} stands twice; give each once, the task's own kind not at all")
        tasks = told_layers(task)
        self._lowest, *self._higher = (
            _Layer(kind, behaviours[kind], told, views[kind]) for kind, told in zip(kinds, tasks)
        )
        self._asked = False
        self._silent: Set[str] = set()

    def subscriptions(self) -> Sequence[Subscription]:
        """List what all layers hear, each of them by its own view."""
        return tuple(wish for layer in (self._lowest, *self._higher) for wish in layer.behaviour.subscriptions())

    def applicable(self, task: Task, perception: Perception) -> bool:
        """Ask the lowest layer.

        The others are asked once, so that they can refuse what makes no sense in the task; their answers do not count.
        """
        if not self._asked:
            for layer in self._higher:
                _ask(layer, layer.behaviour.applicable, layer.task, layer.perception)
            self._asked = True
        return self._lowest.behaviour.applicable(self._lowest.task, self._lowest.perception)

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Ask the lowest layer."""
        return self._lowest.behaviour.cost(self._lowest.task, self._lowest.perception)

    def start(self, task: Task, perception: Perception) -> None:
        """Begin with all layers, the lowest first."""
        self._silent.clear()
        self._lowest.behaviour.start(self._lowest.task, self._lowest.perception)
        for layer in self._higher:
            _ask(layer, layer.behaviour.start, layer.task, layer.perception)

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Let every layer take its step, and join what they answer."""
        lowest: Any = self._lowest.behaviour.step(self._lowest.task, self._lowest.perception)
        step = checked(lowest, BehaviourStep)
        commands: List[Sequence[Command]] = [step.commands]
        messages: List[Outgoing] = list(step.messages)
        progress, detail = step.progress, step.detail
        for layer in self._higher:
            if layer.kind in self._silent:
                continue
            above = _ask(layer, _stepped, layer)
            commands.append(above.commands)
            messages.extend(above.messages)
            if above.progress is Progress.DONE:
                self._silent.add(layer.kind)
            elif above.progress in _ENDS_TASK and progress is Progress.RUNNING:
                progress = above.progress
                detail = f"layer {layer.kind}: {above.detail}" if above.detail else f"layer {layer.kind}"
        return BehaviourStep(suppressed(commands), progress, detail, tuple(messages))


def _stepped(layer: _Layer) -> BehaviourStep:
    step: Any = layer.behaviour.step(layer.task, layer.perception)
    checked(step, BehaviourStep)
    if step.progress not in _TOLD:
        names = ", ".join(progress.name for progress in _TOLD)
        raise ValueError(f"a progress of {step.progress!r}; {names} are accepted")
    suppressed([step.commands])
    result: BehaviourStep = step
    return result


def _ask(layer: _Layer, question: Callable[..., _Answer], *arguments: object) -> _Answer:
    """Ask a higher layer; what it raises is told with its kind, for the task carries that of the lowest."""
    try:
        return question(*arguments)
    except MrtaError:
        raise
    except Exception as error:
        raise LayerError(f"{layer.kind}: {type(error).__name__}: {error}") from error
