from __future__ import annotations

from typing import Any, Dict, List

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.config.editing.yaml_document import YamlDocument
from rqt_mrta_py.errors import ConfigError

BLOCK = """\
# Who is there.
robots:   # all of them
  - {id: robot1, start: {x: 1, y: 2}}   # the first
  # The second is slow.
  - id: "robot2"
    start:
      x: 3   # far
      y: 4

  - {id: robot3, start: {x: 5, y: 6}}
# What happens.
events: [{robot: robot1}, {robot: robot2}]
"""


def ids(document: YamlDocument, key: str = "robots") -> List[str]:
    return [entry["id"] for entry in yaml.safe_load(document.text)[key]]


@pytest.mark.parametrize(
    ("index", "gone"),
    [
        (0, "  - {id: robot1, start: {x: 1, y: 2}}   # the first\n"),
        (1, '  - id: "robot2"\n    start:\n      x: 3   # far\n      y: 4\n'),
        (2, "  - {id: robot3, start: {x: 5, y: 6}}\n"),
    ],
)
def test_an_entry_goes_with_its_lines_and_nothing_else_changes(index: int, gone: str) -> None:
    document = YamlDocument(BLOCK, "s.yaml")
    document.remove_entry("robots", index)
    assert document.text == BLOCK.replace(gone, "")


def test_the_last_entry_leaves_an_empty_list() -> None:
    document = YamlDocument("a: 1\ntasks:  # none\n  - id: x\n    kind: y\nb: 2\n", "t.yaml")
    document.remove_entry("tasks", 0)
    assert document.text == "a: 1\ntasks: []  # none\nb: 2\n"
    document.append_entry("tasks", {"id": "z"})
    assert document.text == "a: 1\ntasks: [{id: z}]  # none\nb: 2\n"


@pytest.mark.parametrize(
    ("index", "left"), [(0, "e: [{a: 2}, {a: 3}]"), (1, "e: [{a: 1}, {a: 3}]"), (2, "e: [{a: 1}, {a: 2}]")]
)
def test_an_entry_of_a_list_in_brackets_goes_with_its_comma(index: int, left: str) -> None:
    document = YamlDocument("e: [{a: 1}, {a: 2}, {a: 3}]", "s.yaml")
    document.remove_entry("e", index)
    assert document.text == left


def test_an_entry_is_laid_out_as_the_one_before_it() -> None:
    document = YamlDocument(BLOCK, "s.yaml")
    document.append_entry("robots", {"id": "on", "start": {"x": 0.5, "y": -1.0}})
    last = "  - {id: robot3, start: {x: 5, y: 6}}\n"
    assert document.text == BLOCK.replace(last, f"{last}  - {{id: 'on', start: {{x: 0.5, y: -1.0}}}}\n")
    block = YamlDocument("tasks:\n- id: a\n  kind: b", "t.yaml")
    block.append_entry("tasks", {"id": "c", "kind": "d", "place": {"x": 1.0, "y": 2.0}})
    assert block.text == "tasks:\n- id: a\n  kind: b\n- id: c\n  kind: d\n  place: {x: 1.0, y: 2.0}\n"


def test_an_entry_joins_a_list_in_brackets_in_its_line_or_on_one_of_its_own() -> None:
    document = YamlDocument(BLOCK, "s.yaml")
    document.append_entry("events", {"robot": "robot3"})
    assert document.text == BLOCK.replace("{robot: robot2}]", "{robot: robot2}, {robot: robot3}]")
    lines = YamlDocument("e: [\n  {a: 1},\n  {a: 2}\n]\n", "s.yaml")
    lines.append_entry("e", {"a": 3})
    assert lines.text == "e: [\n  {a: 1},\n  {a: 2},\n  {a: 3}\n]\n"


def test_texts_are_replaced_where_they_stand() -> None:
    document = YamlDocument(BLOCK, "s.yaml")
    nodes = [value for entry in document.entries("robots") for name, value in entry.value if name.value == "id"]
    document.replace(nodes[:2], "yes")
    assert document.text == BLOCK.replace("id: robot1", "id: 'yes'").replace('id: "robot2"', "id: 'yes'")


def test_line_ends_of_windows_stay() -> None:
    document = YamlDocument(BLOCK.replace("\n", "\r\n"), "s.yaml")
    document.append_entry("robots", {"id": "x", "start": {"x": 0.0, "y": 0.0}})
    assert document.text.count("\n") == document.text.count("\r\n") == BLOCK.count("\n") + 1


def test_what_is_no_yaml_is_refused() -> None:
    with pytest.raises(ConfigError, match="is not YAML"):
        YamlDocument("a: [", "s.yaml")


ENTRIES = st.lists(
    st.fixed_dictionaries(
        {"id": st.text(st.characters(blacklist_categories=("Cs", "Cc", "Zl", "Zp")), min_size=1, max_size=5)},
        optional={"place": st.fixed_dictionaries({"x": st.floats(-9, 9), "y": st.integers(-9, 9)})},
    ),
    max_size=5,
)


@given(ENTRIES, st.booleans(), st.data())
def test_any_list_of_entries_can_be_edited(entries: List[Dict[str, Any]], flow: bool, data: st.DataObject) -> None:
    document = YamlDocument(yaml.safe_dump({"tasks": entries, "z": 1}, default_flow_style=flow or None), "t.yaml")
    for _ in range(data.draw(st.integers(1, 4))):
        if entries and data.draw(st.booleans()):
            index = data.draw(st.integers(0, len(entries) - 1))
            document.remove_entry("tasks", index)
            entries = [*entries[:index], *entries[index + 1 :]]
        else:
            entry = data.draw(ENTRIES.filter(bool))[0]
            document.append_entry("tasks", entry)
            entries = [*entries, entry]
        assert yaml.safe_load(document.text) == {"tasks": entries, "z": 1}
