"""Reads a robot's parameters from the nested form of its YAML file, which is the original nodes' own."""

from __future__ import annotations

from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, TypeVar

from mrta_alliance.parameters import (
    AllianceParameters,
    BehaviourSetParameters,
    SensorParameters,
)
from rqt_mrta_py.hooks import ParameterProblem, ParameterRangeError
from rqt_mrta_py.model import is_legal_name

__all__ = ["find_problems", "read_parameters"]

_Value = TypeVar("_Value")

_RATES = ("spin_rate", "broadcast_rate", "timeout_duration", "buffer_horizon")
_SWITCHES = ("strict_original", "low_level_feedback")
_SENSOR_NUMBERS = {name: name for name in ("timeout_duration", "buffer_horizon")}
_BEHAVIOUR_SET_NUMBERS = {
    "task_expected_duration": "task_expected_duration",
    "threshold": "motivational_behaviour/threshold",
    "yielding_delay": "motivational_behaviour/acquiescence/yielding_delay",
    "giving_up_delay": "motivational_behaviour/acquiescence/giving_up_delay",
    "fast_rate": "motivational_behaviour/impatience/fast_rate",
    "head_start": "motivational_behaviour/impatience/head_start",
    "fairness": "motivational_behaviour/impatience/fairness",
}
_FEEDBACK = "motivational_behaviour/sensory_feedback"
_BEHAVIOUR_SET_GROUPS = (
    "motivational_behaviour",
    "motivational_behaviour/acquiescence",
    "motivational_behaviour/impatience",
    _FEEDBACK,
)


def read_parameters(nested: Mapping[str, Any], tasks: Sequence[str]) -> AllianceParameters:
    """Make a robot's parameters from their nested form; what is missing takes its default.

    Args:
        nested: as in the robot's YAML file.
        tasks: ids of the tasks that this robot may carry out.

    Raises:
        ParameterRangeError: carries everything that is wrong.
    """
    parameters, problems = _read(nested, tasks)
    if parameters is None or problems:
        raise ParameterRangeError(tuple(problems))
    return parameters


def find_problems(nested: Mapping[str, Any], tasks: Sequence[str]) -> Sequence[ParameterProblem]:
    """List everything that is wrong with a robot's parameters.

    Args:
        nested: as in the robot's YAML file.
        tasks: ids of the tasks that this robot may carry out.

    Returns:
        Problems by path, in the order of the file; empty if there are none.
    """
    return _read(nested, tasks)[1]


def _read(
    nested: Mapping[str, Any], tasks: Sequence[str]
) -> Tuple[Optional[AllianceParameters], List[ParameterProblem]]:
    problems: List[ParameterProblem] = []
    robot = {**_numbers(nested, "", {name: name for name in _RATES}, problems), **_switches(nested, problems)}
    sensors: Dict[str, SensorParameters] = {}
    for path in _elements(nested, "sensors", "sensor", problems):
        sensor = _sensor(nested, path, problems)
        if sensor is not None:
            sensors[sensor.topic_name] = sensor
    sets: Dict[str, BehaviourSetParameters] = {}
    for path in _elements(nested, "behaviour_sets", "behaviour_set", problems):
        behaviour_set = _behaviour_set(nested, path, sensors, problems)
        if behaviour_set is not None:
            task = behaviour_set.task_id
            message = _objection(task, tasks, sets)
            if message:
                problems.append(ParameterProblem(f"{path}/task_id", message))
            sets.setdefault(task, behaviour_set)
    parameters = _made(
        "",
        problems,
        lambda: AllianceParameters(tuple(sets.values()), sensors=tuple(sensors.values()), **robot),
    )
    return parameters, problems


def _sensor(nested: Mapping[str, Any], path: str, problems: List[ParameterProblem]) -> Optional[SensorParameters]:
    topic = _text(nested, f"{path}/topic_name", "", problems)
    plugin = _text(nested, f"{path}/plugin_name", SensorParameters.plugin_name, problems)
    numbers = _numbers(nested, path, _SENSOR_NUMBERS, problems)
    return _made(path, problems, lambda: SensorParameters(topic, plugin_name=plugin, **numbers))


def _behaviour_set(
    nested: Mapping[str, Any], path: str, sensors: Mapping[str, SensorParameters], problems: List[ParameterProblem]
) -> Optional[BehaviourSetParameters]:
    for group in _BEHAVIOUR_SET_GROUPS:
        _group(nested, f"{path}/{group}", problems)
    topics = []
    for where in _elements(nested, f"{path}/{_FEEDBACK}/sensors", "sensor", problems):
        topic = _text(nested, f"{where}/topic_name", "", problems)
        if topic not in sensors:
            known = ", ".join(sensors) or "none"
            message = f"must be the topic of one of the robot's own sensors (got {topic!r}); there are: {known}"
            problems.append(ParameterProblem(f"{where}/topic_name", message))
        topics.append(topic)
    task = _text(nested, f"{path}/task_id", "", problems)
    evaluator = _text(nested, f"{path}/{_FEEDBACK}/plugin_name", BehaviourSetParameters.evaluator, problems)
    numbers = _numbers(nested, path, _BEHAVIOUR_SET_NUMBERS, problems)
    return _made(
        path,
        problems,
        lambda: BehaviourSetParameters(task, evaluator=evaluator, sensors=tuple(topics), **numbers),
    )


def _objection(task: str, tasks: Sequence[str], before: Mapping[str, BehaviourSetParameters]) -> str:
    if task in before:
        return f"must differ from the other behaviour sets' (got {task!r} again)"
    if task not in tasks:
        return f"must be a task of this robot (got {task!r}); there are: {', '.join(tasks) or 'none'}"
    if not is_legal_name(f"alliance/motivation/{task}"):
        return f"must be fit for a topic (got {task!r}); letters, digits and _ are"
    return ""


def _made(path: str, problems: List[ParameterProblem], make: Callable[[], _Value]) -> Optional[_Value]:
    try:
        return make()
    except ParameterRangeError as error:
        problems += [ParameterProblem(_join(path, problem.path), problem.message) for problem in error.problems]
        return None


def _elements(nested: Mapping[str, Any], path: str, name: str, problems: List[ParameterProblem]) -> Iterator[str]:
    """Yield the paths of a group's numbered elements: as many as ``size`` says, or, without it, as there are."""
    group = _group(nested, path, problems)
    if group is None:
        return
    size = group.get("size", sum(key.startswith(name) for key in group))
    if not isinstance(size, int) or isinstance(size, bool) or size < 0:
        problems.append(ParameterProblem(f"{path}/size", f"must be a whole number, at least 0 (got {size!r})"))
        return
    for index in range(size):
        if not isinstance(group.get(f"{name}{index}"), Mapping):
            problems.append(ParameterProblem(f"{path}/{name}{index}", f"is missing; size says that there are {size}"))
            return
        yield f"{path}/{name}{index}"


def _group(nested: Mapping[str, Any], path: str, problems: List[ParameterProblem]) -> Optional[Mapping[str, Any]]:
    group = _find(nested, path)
    if group is None or isinstance(group, Mapping):
        return group
    problems.append(ParameterProblem(path, f"must be a group of parameters (got {group!r})"))
    return None


def _numbers(
    nested: Mapping[str, Any], path: str, names: Mapping[str, str], problems: List[ParameterProblem]
) -> Dict[str, float]:
    """Read the numbers that are there, by attribute."""
    found: Dict[str, float] = {}
    for attribute, name in names.items():
        value = _find(nested, _join(path, name))
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            found[attribute] = float(value)
        elif value is not None:
            problems.append(ParameterProblem(_join(path, name), f"must be a number (got {value!r})"))
    return found


def _switches(nested: Mapping[str, Any], problems: List[ParameterProblem]) -> Dict[str, Any]:
    """Read the robot's switches that are there, by attribute."""
    found: Dict[str, Any] = {}
    for name in _SWITCHES:
        value = nested.get(name)
        if isinstance(value, bool):
            found[name] = value
        elif value is not None:
            problems.append(ParameterProblem(name, f"must be true or false (got {value!r})"))
    return found


def _text(nested: Mapping[str, Any], path: str, default: str, problems: List[ParameterProblem]) -> str:
    value = _find(nested, path)
    if value is None:
        return default
    if not isinstance(value, str):
        problems.append(ParameterProblem(path, f"must be a text (got {value!r})"))
        return default
    return value


def _find(nested: Any, path: str) -> Any:
    for name in path.split("/"):
        if not isinstance(nested, Mapping):
            return None
        nested = nested.get(name)
    return nested


def _join(path: str, name: str) -> str:
    return f"{path}/{name}" if path else name
