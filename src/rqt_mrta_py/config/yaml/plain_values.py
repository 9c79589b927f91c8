"""Checking values that no file holds by the tables of those that files hold."""

from __future__ import annotations

from typing import Any, Mapping, Tuple

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.yaml.rows import Row, read_table
from rqt_mrta_py.config.yaml.schema import Table
from rqt_mrta_py.config.yaml.text import YamlNode
from rqt_mrta_py.errors import Problem

__all__ = ["read_plain"]


def read_plain(values: Mapping[str, Any], table: Table) -> Tuple[Row, Tuple[Problem, ...]]:
    """Read nested builtins by a table, whoever made them.

    Args:
        values: by key.
        table: the keys.

    Returns:
        What was read, and what is wrong with it: problems without path and line.
    """
    problems = Problems("")
    row = read_table(_node(values), table, "", problems)
    return row, problems.found


def _node(value: Any) -> YamlNode:
    if isinstance(value, Mapping):
        nodes = {str(key): _node(child) for key, child in value.items()}
        return YamlNode(nodes, 0, dict.fromkeys(nodes, 0), 1 + sum(node.size for node in nodes.values()))
    if isinstance(value, (list, tuple)):
        items = tuple(_node(child) for child in value)
        return YamlNode(items, 0, {}, 1 + sum(node.size for node in items))
    return YamlNode(value, 0, {}, 1)
