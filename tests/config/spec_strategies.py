"""Specifications as a file can say them, for property tests."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Dict, Tuple, TypeVar

from hypothesis import strategies as st

from rqt_mrta_py.model import (
    AllocationType,
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    ArrayTemplate,
    ConfigTemplate,
    IncludeSpec,
    LaunchArgument,
    LaunchTemplate,
    MapTemplate,
    MonitoredTopic,
    ParameterTemplate,
    ParameterType,
    RobotType,
    TaskType,
    Taxonomy,
    TopicCondition,
    TopicJoin,
)

__all__ = ["applications", "architectures"]

_T = TypeVar("_T")

_characters = st.one_of(
    st.sampled_from("ab/<>&\"'@ \t]"),
    st.characters(exclude_categories=("Cs", "Cc"), exclude_characters="\ufffe\uffff"),
)


def _one_line(text: str) -> str:
    """Make a text one that readers give: trimmed, in one line."""
    return " ".join(text.replace("\r", "\n").split("\n")).strip()


texts = st.text(_characters, max_size=20).map(_one_line)
words = st.one_of(texts, st.sampled_from(["@robot_id@", "$(find @package@)/a.launch", "]]>", "&amp;", "x" * 300]))
some_words = words.filter(bool)
ids = st.text(_characters, min_size=1, max_size=12).filter(lambda text: not any(map(str.isspace, text)))
_steps = st.one_of(
    st.sampled_from(["size", "sensor@index@", "@robot_id@", "fast rate", "<&>"]),
    texts.map(lambda text: text.replace("/", "").strip()).filter(bool),
)
names = st.builds("/".join, st.lists(_steps, min_size=1, max_size=2))
segments = st.from_regex(r"\A[A-Za-z][A-Za-z0-9_]{0,5}\Z", fullmatch=True)
fields = st.builds("/".join, st.lists(segments, min_size=1, max_size=3))
seconds = st.floats(min_value=1e-300, allow_infinity=False)
plain_topics = st.builds("/{}".format, fields)
TOLD = ["/@robot_id@/x", "/x/@task_id@"]


def _unique(values: st.SearchStrategy[_T], by: Callable[[_T], Any], most: int = 3) -> st.SearchStrategy[Tuple[_T, ...]]:
    return st.lists(values, max_size=most, unique_by=by).map(tuple)


def _topic(
    name: str, kind: Tuple[str, str], parts: Dict[str, Any], numbers: Tuple[int, float, float]
) -> MonitoredTopic:
    return MonitoredTopic(name, "/".join(kind), **parts, queue_size=numbers[0], timeout=numbers[1], horizon=numbers[2])


_numbers = st.tuples(st.integers(0, 999_999_999), seconds, seconds)
_optional = {
    "robot_field": fields,
    "task_field": fields,
    "join": st.builds(
        TopicJoin,
        st.one_of(plain_topics, st.sampled_from(TOLD)),
        st.builds("{}/{}".format, segments, segments),
        fields,
        fields,
    ),
    "condition": st.builds(TopicCondition, fields, some_words),
}
topics = st.one_of(
    st.builds(
        _topic,
        plain_topics,
        st.tuples(segments, segments),
        st.fixed_dictionaries({"field": fields}, optional=_optional),
        _numbers,
    ),
    st.builds(
        _topic,
        st.sampled_from(TOLD),
        st.tuples(segments, segments),
        st.fixed_dictionaries({}, optional={"field": fields, **_optional}),
        _numbers,
    ),
)
topic_lists = st.lists(topics, max_size=3).map(tuple)
bid_lists = st.lists(st.builds(lambda topic, bid: replace(topic, bid_field=bid), topics, fields), max_size=3).map(tuple)

_values = {
    ParameterType.BOOL: st.sampled_from(["true", "False", "TRUE", "@robot_id@"]),
    ParameterType.INT: st.one_of(st.integers(-(10**17), 10**17).map(str), st.just("@array_size@")),
    ParameterType.DOUBLE: st.one_of(st.floats(allow_nan=False, allow_infinity=False).map(repr), st.just("@index@")),
    ParameterType.STRING: some_words,
}


def _parameter_of(kind: ParameterType) -> st.SearchStrategy[ParameterTemplate]:
    value = st.one_of(st.none(), _values[kind])
    return st.builds(ParameterTemplate, names, st.just(kind), value, value, words)


parameters = st.sampled_from(list(ParameterType)).flatmap(_parameter_of)
sizes = st.builds(ParameterTemplate, st.just("size"), st.just(ParameterType.INT), st.just("@array_size@"))


def _items(leaves: st.SearchStrategy[Any], further: st.SearchStrategy[Any]) -> st.SearchStrategy[Tuple[Any, ...]]:
    return _unique(st.one_of(leaves, further), lambda item: item.name)


def _with_size(drawn: Tuple[Tuple[Any, ...], ParameterTemplate]) -> Tuple[Any, ...]:
    items, size = drawn
    arrays = any(isinstance(item, ArrayTemplate) for item in items)
    return (*(item for item in items if item.name != "size"), size) if arrays else items


def _groups(inner: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    held = st.tuples(_unique(inner, lambda item: item.name), sizes).map(_with_size)
    return st.one_of(st.builds(MapTemplate, names, held), st.builds(ArrayTemplate, names, held))


_any_item = st.recursive(parameters, _groups, max_leaves=12)
top_items = _unique(_any_item.filter(lambda item: not isinstance(item, ArrayTemplate)), lambda item: item.name)
configs = _unique(st.builds(ConfigTemplate, ids, top_items), lambda config: config.id)

arguments = st.builds(LaunchArgument, some_words, words, words)
includes = st.builds(IncludeSpec, some_words, st.lists(arguments, max_size=3).map(tuple))
launches = _unique(st.builds(LaunchTemplate, ids, st.lists(includes, max_size=3).map(tuple)), lambda launch: launch.id)
taxonomies = st.builds(Taxonomy, st.sampled_from(RobotType), st.sampled_from(TaskType), st.sampled_from(AllocationType))


@st.composite
def architectures(draw: st.DrawFn) -> ArchitectureSpec:
    """Draw an architecture that a file can say."""
    held, files = draw(configs), draw(launches)
    chosen = draw(st.sampled_from([None, *(config.id for config in held)]))
    return ArchitectureSpec(
        package="a",
        name=draw(some_words),
        taxonomy=draw(taxonomies),
        busy_robots=draw(topic_lists),
        idle_robots=draw(topic_lists),
        incoming_tasks=draw(topic_lists),
        allocated_tasks=draw(topic_lists),
        completed_tasks=draw(topic_lists),
        failed_tasks=draw(topic_lists),
        bids=draw(bid_lists),
        # A file's only config is every robot's, said or not.
        robot_config_id=held[0].id if len(held) == 1 else chosen,
        robot_launch_id=draw(st.sampled_from([None, *(launch.id for launch in files)])),
        configs=held,
        launches=files,
        widgets=tuple(draw(st.lists(some_words, max_size=2))),
    )


@st.composite
def applications(draw: st.DrawFn) -> ApplicationSpec:
    """Draw an application that a file can say."""
    robots = st.builds(ApplicationRobot, ids, _unique(ids, lambda name: name))
    return ApplicationSpec(
        package="a",
        name=draw(some_words),
        architecture=draw(st.one_of(st.none(), some_words)),
        robots=draw(_unique(robots, lambda robot: robot.id, most=12)),
        configs=draw(configs),
        launches=draw(launches),
    )
