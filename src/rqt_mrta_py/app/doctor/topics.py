"""Whether an architecture's monitored topics can be read: known types, string fields, timeouts that go together."""

from __future__ import annotations

import re
from pathlib import Path
from typing import (
    AbstractSet,
    Dict,
    FrozenSet,
    Iterator,
    List,
    Mapping,
    NamedTuple,
    Optional,
    Sequence,
    Tuple,
)

from rqt_mrta_py.app.doctor.dependencies import package_problem
from rqt_mrta_py.app.doctor.flaws import flaws_of
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.gaps import touches
from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.xml.element import Element, Text
from rqt_mrta_py.errors import Problem, TransportError
from rqt_mrta_py.hooks import Codec
from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN, MonitoredTopic
from rqt_mrta_py.transport.codec.definitions import Definition, parse_definition
from rqt_mrta_py.wording import accepted, shown

__all__ = ["check_topics", "field_fault"]

_OF_ROBOTS = (("robots", "busy_robots"), ("robots", "idle_robots"))
_OF_TASKS = (
    ("tasks", "incoming_tasks"),
    ("tasks", "completed_tasks"),
    ("tasks", "failed_tasks"),
    ("allocations", "allocated_tasks"),
    ("allocations", "bids"),
)
_PARTS = ("robots", "tasks", "allocations")
_FIELDS = ("field", "robot_field", "task_field")
_TASK_FIELDS = ("field", "task_field")
_NUMBERS = ("timeout", "queue_size", "horizon")
_IDS = frozenset(("string",))
_WHOLE = frozenset(("byte", "char", *(f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64))))
_WORDS = {"bool": re.compile("true|false"), **dict.fromkeys(_WHOLE, re.compile("0|-?[1-9][0-9]*"))}
_COMPARED = _IDS | _WORDS.keys()
_NUMBERS_BID = _WHOLE | {"float32", "float64"}
_NOT_OF_TIMEOUTS = ("type", "queue_size", "horizon", *_FIELDS)


class _Topic(NamedTuple):
    """A topic that is filled in, as the file has it.

    Attributes:
        kind: the element that holds it, such as ``busy_robots``.
        element: its own, read as far as it is asked about here.
        texts: of its children, without those that the reader does not accept.
        flaws: names of children with which something is wrong; empty for the topic itself.
    """

    kind: str
    element: Element
    texts: Mapping[str, Text]
    flaws: FrozenSet[str]

    @property
    def name(self) -> str:
        """Of the topic; empty where it is not known."""
        return self.texts["name"].value if "name" in self.texts else ""

    @property
    def type(self) -> str:
        """Of its messages; empty where it is not known."""
        return self.texts["type"].value if "type" in self.texts else ""

    @property
    def timeout(self) -> float:
        """How long a message counts [s]."""
        return float(self.texts["timeout"].value) if "timeout" in self.texts else MonitoredTopic("", "").timeout

    def problem(self, name: str, message: str) -> None:
        """Note a problem of a child, where that stands if it does."""
        self.element.problem(name, message, self.texts[name].line if name in self.texts else None)


def check_topics(subject: Subject) -> Iterator[Problem]:
    """Find topics that nobody could read, or that tell other things than their place in the file says."""
    for architecture in subject.architectures:
        if architecture.spec is None:
            continue
        problems = Problems(str(architecture.path))
        topics = _read(Element(subject.root(architecture.path), "", problems), architecture.problems)
        codec = subject.host.codec()
        for topic in topics:
            if topic.name and topic.flaws.issubset(("name", "type", *_NUMBERS)):
                _check_what_it_tells(topic)
            definition = None
            if topic.type and not _is_told_of_package(subject, architecture.path, topic.type):
                definition = _check_type(topic, codec)
            if definition is not None:
                _check_condition(topic, definition)
            _check_join(subject, architecture.path, topic, codec)
        _check_one_type_each([topic for topic in topics if topic.name and topic.type])
        if not any(_is_about_timeouts_of_busy(problem.element) for problem in architecture.problems):
            _check_flicker([topic for topic in topics if topic.flaws.issubset(_NOT_OF_TIMEOUTS)])
        yield from problems.found


def field_fault(definition: Definition, path: str) -> Optional[str]:
    """Say why no id can be read at a path of a message type; None if one can.

    Args:
        definition: of the type.
        path: names of fields, joined by ``/``.
    """
    return _look_up(definition, path, _IDS, "type string")[1]


def _look_up(definition: Definition, path: str, kinds: AbstractSet[str], wanted: str) -> Tuple[str, Optional[str]]:
    """Give the type of the field at a path; with it, why that is none of some kinds, or None if it is."""
    spec = definition.root
    steps = path.split("/")
    for depth, step in enumerate(steps):
        found = next((item for item in spec.fields if item.name == step), None)
        if found is None:
            what = f"{step!r} of {path!r}" if len(steps) > 1 else repr(step)
            return "", f"{spec.name} has no field {what}; {accepted(step, [item.name for item in spec.fields])}"
        kind = f"an array of {found.type}" if found.is_array else f"of type {found.type}"
        if depth + 1 == len(steps):
            fits = found.type in kinds and not found.is_array
            return found.type, None if fits else f"{path!r} is {kind}; give a field of {wanted}"
        if found.is_array or found.is_primitive:
            through = f"{path!r} leads through {step!r}, which is {kind}"
            return "", f"{through}; give a path that ends in a field of {wanted}"
        spec = definition.specs[found.type]
    return "", None


def _read(root: Element, wrong: Sequence[Problem]) -> List[_Topic]:
    architecture = root.child("architecture")
    parts = {name: architecture.child(name) for name in _PARTS} if architecture is not None else {}
    topics: List[_Topic] = []
    for name, kind in (*_OF_ROBOTS, *_OF_TASKS):
        part = parts.get(name)
        holder = part.child(kind) if part is not None else None
        if holder is None:
            continue
        for element in [*holder.repeated("topic"), *(entry.element for entry in holder.numbered(["topic"]))]:
            # One that was never filled in counts for nothing.
            if element.has("name"):
                found = {child: element.text(child) for child in ("name", "type", "timeout", "bid_field", *_FIELDS)}
                told = [
                    each.element for each in flaws_of(element.lines, wrong) if touches([each.element], element.path)
                ]
                flaws = frozenset(each[len(element.path) + 1 :] for each in told)
                texts = {name: text for name, text in found.items() if text is not None and name not in flaws}
                topics.append(_Topic(kind, element, texts, flaws))
    return topics


def _check_what_it_tells(topic: _Topic) -> None:
    """Note a topic of robots that names no robot, or one of tasks that names no task."""
    of_robots = topic.kind in [kind for _, kind in _OF_ROBOTS]
    what, token, fields = ("robot", ROBOT_TOKEN, _FIELDS[:1]) if of_robots else ("task", TASK_TOKEN, _TASK_FIELDS)
    if token not in topic.name and not any(field in topic.texts for field in fields):
        topic.problem(
            "field", f"is missing, so that nothing tells the {what}; give the field with its id, or {token} in the name"
        )


def _is_told_of_package(subject: Subject, path: Path, type_name: str) -> bool:
    """Tell whether a type is unknown because its package is, of which other checks tell already."""
    package = type_name.partition("/")[0]
    unknown = package not in subject.host.registry.packages
    return unknown and any(True for _ in package_problem(subject, package, path, 0, ""))


def _check_type(topic: _Topic, codec: Codec) -> Optional[Definition]:
    """Note a type that nobody knows, or fields of it that hold no id; give what is known of it."""
    try:
        definition = _definition(topic.type, codec)
    except TransportError as error:
        topic.problem("type", str(error))
        return None
    for name in _FIELDS:
        fault = field_fault(definition, topic.texts[name].value) if name in topic.texts else None
        if fault is not None:
            topic.problem(name, fault)
    if "bid_field" in topic.texts:
        fault = _look_up(definition, topic.texts["bid_field"].value, _NUMBERS_BID, "a number")[1]
        if fault is not None:
            topic.problem("bid_field", fault)
    return definition


def _check_condition(topic: _Topic, definition: Definition) -> None:
    """Note a condition that no message of a type can meet."""
    condition = None if _has_flaw(topic, "when") else topic.element.child("when")
    field = condition.text("field") if condition is not None else None
    if condition is None or field is None:
        return
    kind, fault = _look_up(definition, field.value, _COMPARED, "type string, bool or integer")
    if fault is not None:
        condition.problem("field", fault, field.line)
        return
    value = condition.text("value")
    if value is not None and kind in _WORDS and not _WORDS[kind].fullmatch(value.value):
        words = "true or false" if kind == "bool" else "a whole number"
        message = f"must be {words}, for {field.value!r} is of type {kind} (got {shown(value.value)})"
        condition.problem("value", message, value.line)


def _check_join(subject: Subject, path: Path, topic: _Topic, codec: Codec) -> None:
    """Note a join of a type that nobody knows, or fields of it that hold no id."""
    join = None if _has_flaw(topic, "join") else topic.element.child("join")
    kind = join.text("type") if join is not None else None
    if join is None or kind is None or _is_told_of_package(subject, path, kind.value):
        return
    try:
        definition = _definition(kind.value, codec)
    except TransportError as error:
        join.problem("type", str(error), kind.line)
        return
    for name in ("field", "task_field"):
        field = join.text(name)
        fault = field_fault(definition, field.value) if field is not None else None
        if field is not None and fault is not None:
            join.problem(name, fault, field.line)


def _has_flaw(topic: _Topic, child: str) -> bool:
    """Tell whether something is wrong within a child."""
    return any(flaw.partition("/")[0] == child for flaw in topic.flaws)


def _definition(type_name: str, codec: Codec) -> Definition:
    return parse_definition(type_name, codec.connection("/topic", type_name).definition)


def _check_one_type_each(topics: Sequence[_Topic]) -> None:
    """Note topics that are said to carry messages of two types."""
    first: Dict[str, _Topic] = {}
    for topic in topics:
        other = first.setdefault(topic.name, topic)
        if other.type != topic.type:
            line = other.texts["type"].line
            topic.problem("type", f"is {topic.type}, but {topic.name} carries {other.type} by line {line}; give one")


def _is_about_timeouts_of_busy(element: str) -> bool:
    """Tell whether timeouts of busy_robots may be others than those that were read."""
    return element.startswith("architecture/robots/busy_robots") and element.rpartition("/")[2] not in _NOT_OF_TIMEOUTS


def _check_flicker(topics: Sequence[_Topic]) -> None:
    """Note allocations that end while their robots are busy with them."""
    busy = [topic for topic in topics if topic.kind == "busy_robots"]
    for topic in topics:
        if topic.kind != "allocated_tasks" or not busy:
            continue
        least = min(other.timeout for other in [each for each in busy if each.name == topic.name] or busy)
        if topic.timeout < least:
            topic.problem(
                "timeout",
                f"is {topic.timeout:g} s, shorter than that of busy_robots, so that tasks seem to be given up while "
                f"their robots are busy with them; give at least {least:g}",
            )
