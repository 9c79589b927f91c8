"""From the text of a tasks.yaml to tasks."""

from __future__ import annotations

from typing import Dict, List, Mapping, Tuple, Union

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.tasks.task_text import TASK, check_id, check_layers, id_of, task_of
from rqt_mrta_py.config.yaml.rows import Row, read_document
from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.config.yaml.text import parse_yaml
from rqt_mrta_py.model import Task, normalise_id
from rqt_mrta_py.wording import accepted

__all__ = ["TASKS_FILE", "read_tasks"]

TASKS_FILE = Table(
    "tasks.yaml",
    "The tasks of an application, for simulation and hardware alike.",
    (Key("tasks", ValueType.TABLES, "The tasks, in the order in which they are shown.", table=TASK),),
)


def read_tasks(text: Union[str, bytes], path: str) -> Tuple[Task, ...]:
    """Read the tasks of an application.

    Args:
        text: the whole file.
        path: by which problems name the file.

    Returns:
        The tasks, in file order.

    Raises:
        ConfigError: with everything that is wrong, sorted by line.
    """
    problems = Problems(path)
    rows: List[Row] = read_document(parse_yaml(text, path), TASKS_FILE, problems).values["tasks"] or []
    _check_ids(rows, problems)
    _check_predecessors(rows, problems)
    problems.raise_if_any()
    return tuple(task_of(row) for row in rows)


def _check_ids(rows: List[Row], problems: Problems) -> None:
    lines: Dict[str, int] = {}
    for row in rows:
        check_id(row, problems)
        check_layers(row, problems)
        name = id_of(row)
        if name is None:
            continue
        line, element = row.at("id")
        if name in lines:
            problems.add(line, element, f"{name!r} names two tasks; the first one is in line {lines[name]}")
        lines.setdefault(name, line)


def _check_predecessors(rows: List[Row], problems: Problems) -> None:
    before: Dict[str, List[str]] = {}
    where: Dict[str, Row] = {}
    for row in rows:
        name = id_of(row)
        if name is not None:
            before.setdefault(name, [normalise_id(other) for other in row.values["predecessors"] or ()])
            where.setdefault(name, row)
    for name, others in before.items():
        for other in others:
            if other not in before:
                problems.add(
                    *where[name].at("predecessors"),
                    f"names {other!r}, which is no task here; {accepted(other, before)}",
                )
    for cycle in _cycles(before):
        problems.add(
            *where[cycle[0]].at("predecessors"),
            f"go round in a circle: {' after '.join([*cycle, cycle[0]])}; take one of them out",
        )


def _cycles(before: Mapping[str, List[str]]) -> List[List[str]]:
    """Find one cycle for each task from which the search runs into one, without recursion."""
    finished: Dict[str, None] = {}
    cycles = []
    for start in before:
        chain: List[str] = []
        pending = [(start, False)]
        while pending:
            name, leave = pending.pop()
            if leave:
                chain.pop()
                finished[name] = None
            elif name in chain:
                cycles.append(chain[chain.index(name) :])
            elif name in before and name not in finished:
                chain.append(name)
                pending.append((name, True))
                pending.extend((other, False) for other in reversed(before[name]))
    return cycles
