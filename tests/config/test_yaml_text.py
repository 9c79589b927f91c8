"""YAML values with lines."""

from __future__ import annotations

import pytest

from rqt_mrta_py.config.yaml.text import parse_yaml
from rqt_mrta_py.errors import ConfigError


def test_yaml_values_are_plain_and_know_their_lines() -> None:
    node = parse_yaml("a: 1\nb:\n  - 2.5\n  - [true, ~]\nc: {d: 2026-11-22, e: '7'}\n", "f.yaml")

    assert node is not None
    assert node.plain() == {"a": 1, "b": [2.5, [True, None]], "c": {"d": "2026-11-22", "e": "7"}}
    assert isinstance(node.value, dict)
    assert (node.value["b"].line, node.lines) == (3, {"a": 1, "b": 2, "c": 5})


@pytest.mark.parametrize("text", ["", "# only words\n", "~", "---\n"])
def test_yaml_that_says_nothing_is_none(text: str) -> None:
    assert parse_yaml(text, "f.yaml") is None


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (b"a: 1\nb: \xff\n", "f.yaml:2: is not UTF-8 text"),
        ("a: 1\nb: \x07\n", "f.yaml:2: is not YAML: the character '\\x07' is not allowed"),
        (b"a: 1\nb: \x07\n", "f.yaml:2: is not YAML: the character '\\x07' is not allowed"),
        ("a: [1,\nb: }", "f.yaml:2: is not YAML: expected the node content, but found '}'"),
        ("a: 0b_", "f.yaml:1: is not a number ('0b_')"),
        ('a: "\\ud800"', "f.yaml:1: holds half a character ('\\ud800')"),
        ("a: !!binary aGk=", "f.yaml:1: carries the tag 'tag:yaml.org,2002:binary'; tags are not accepted"),
        ("a: !!int hi", "f.yaml:1: is not a number ('hi')"),
        ("on: 1", "f.yaml:1: has the key True; keys are texts: put it in quotes"),
        ("[" * 60 + "]" * 60, "f.yaml:1: is nested deeper than 50 levels"),
        ("a: *b", "f.yaml:1: refers to 'b', which is not complete here"),
    ],
)
def test_yaml_that_is_not_accepted_is_refused_with_its_line(text: object, said: str) -> None:
    with pytest.raises(ConfigError) as caught:
        parse_yaml(text, "f.yaml")  # type: ignore[arg-type]

    assert str(caught.value) == said


def test_yaml_may_name_the_type_of_a_scalar() -> None:
    node = parse_yaml("{a: !!float 1, b: !!str 7}", "f.yaml")

    assert node is not None
    assert node.plain() == {"a": 1.0, "b": "7"}


def test_yaml_reports_every_key_that_stands_twice() -> None:
    with pytest.raises(ConfigError) as caught:
        parse_yaml("a: 1\na: 2\nb: {c: 1, c: 2}\n", "f.yaml")

    assert [problem.line for problem in caught.value.problems] == [2, 3]
