"""What drivers publish, message by message, for tests that are about single robots."""

from __future__ import annotations

from typing import Any, Dict, Iterable, List

import numpy as np

from rqt_mrta_py.hooks import Outgoing, TeamOutgoing
from rqt_mrta_py.sim.sensing import Said


def nested(together: TeamOutgoing, row: int) -> Dict[str, Any]:
    """Give the fields of one robot's message."""
    fields: Dict[str, Any] = {}
    for path, column in together.columns.items():
        value = column[row] if isinstance(column, (np.ndarray, list, tuple)) else column
        *parts, last = path.split("/")
        within = fields
        for part in parts:
            within = within.setdefault(part, {})
        within[last] = value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value
    return {name: _with_lists(value) for name, value in fields.items()}


def by_robot(said: Iterable[Said]) -> Dict[str, List[Outgoing]]:
    """Give what each robot publishes, in order, by robot in the order of their first words."""
    messages: Dict[str, List[Outgoing]] = {}
    for each in said:
        if isinstance(each, TeamOutgoing):
            for row, robot in enumerate(each.robots):
                messages.setdefault(robot, []).append(Outgoing(each.topic, each.type, nested(each, row)))
        else:
            messages.setdefault(each.robot, []).extend(each.messages)
    return messages


def _with_lists(value: Any) -> Any:
    if not isinstance(value, dict):
        return value
    inner = {name: _with_lists(item) for name, item in value.items()}
    return [inner[str(number)] for number in range(len(inner))] if all(map(str.isdigit, inner)) else inner
