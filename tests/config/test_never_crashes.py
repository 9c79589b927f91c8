"""Whatever bytes come, a reader gives a specification or a ConfigError."""

from __future__ import annotations

from typing import Callable, List

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.config.mission import mission_from_texts
from rqt_mrta_py.config.parameters.parameter_file import parse_parameters
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import MissionTexts

NAMES = ["rqt_mrta", "architecture", "application", "name", "robots", "type", "busy_robots", "topic", "configs"]
NAMES += ["config_0", "config_1", "id", "param_0", "params_1", "array_2", "size", "launches", "tasks", "robot_0", "x"]
VALUES = ["", " ", "ST", "@index@", "@task_id@", "/r 1", "0", "-1", "nan", "int", "size", "a/b", "p/M", "&lt;"]
KEYS = ["tasks", "id", "kind", "place", "x", "y", "robots", "arena", "min_x", "events", "time", "predecessors", "data"]

elements = st.recursive(
    st.builds("<{0}>{1}</{0}>".format, st.sampled_from(NAMES), st.sampled_from(VALUES)),
    lambda inner: st.builds(
        lambda name, parts: f"<{name}>{''.join(parts)}</{name}>", st.sampled_from(NAMES), st.lists(inner, max_size=5)
    ),
    max_leaves=30,
)
documents = st.builds(lambda parts: f"<rqt_mrta>{''.join(parts)}</rqt_mrta>", st.lists(elements, max_size=4))
scalars = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-3, 3),
    st.floats(),
    st.sampled_from(["a", "1e3", "robot_stops", ".nan", "0b_"]),
)


def flow(value: object) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {flow(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(flow, value)) + "]"
    return "null" if value is None else str(value).lower()


yaml_texts = st.recursive(
    scalars,
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(st.sampled_from(KEYS), inner, max_size=6)),
    max_leaves=30,
).map(flow)
yaml_noise = st.lists(
    st.sampled_from(
        [
            *KEYS,
            ": ",
            "- ",
            "\n",
            "  ",
            "&a ",
            "*a",
            "!!int ",
            "? ",
            "|",
            ">",
            "'",
            '"',
            "\\U99999999",
            "{",
            "[",
            "]",
            "}",
            "#",
            "%",
            "---",
            "...",
        ]
    ),
    max_size=30,
).map("".join)


def problems_of(reader: Callable[[], object]) -> List[Problem]:
    try:
        reader()
    except ConfigError as error:
        return list(error.problems) or [Problem("nothing said", 0, "", "\n")]
    return []


def reads_or_refuses(reader: Callable[[], object]) -> None:
    problems = problems_of(reader)

    assert problems == sorted(problems)
    assert not any("\n" in str(problem) for problem in problems)


@settings(deadline=None)
@given(st.one_of(st.binary(max_size=300), st.text(max_size=200), documents))
def test_xml_readers_give_a_specification_or_a_config_error(text: object) -> None:
    reads_or_refuses(lambda: read_architecture(text, "a.xml", "a"))  # type: ignore[arg-type]
    reads_or_refuses(lambda: read_application(text, "a.xml", "a"))  # type: ignore[arg-type]


@settings(deadline=None)
@given(st.one_of(st.binary(max_size=300), st.text(max_size=200), yaml_texts, yaml_noise))
def test_yaml_readers_give_a_specification_or_a_config_error(text: object) -> None:
    reads_or_refuses(lambda: read_tasks(text, "t.yaml"))  # type: ignore[arg-type]
    reads_or_refuses(lambda: read_scenario(text, "s.yaml", ["a"]))  # type: ignore[arg-type]
    reads_or_refuses(lambda: parse_parameters(text, "p.yaml"))  # type: ignore[arg-type]


@settings(deadline=None)
@given(st.lists(st.one_of(st.text(max_size=100), documents, yaml_texts), min_size=5, max_size=5))
def test_mission_from_texts_gives_a_mission_or_a_config_error(texts: List[str]) -> None:
    reads_or_refuses(lambda: mission_from_texts(MissionTexts(*texts[:4]), "a", "b", texts[4], None))


@pytest.mark.parametrize("text", ["[" * 100_000, "{a: " * 100_000, "- " * 10_000, "? " * 10_000, "&a " * 10_000])
def test_deep_yaml_is_refused_and_does_not_hang(text: str) -> None:
    with pytest.raises(ConfigError):
        read_tasks(text, "t.yaml")
