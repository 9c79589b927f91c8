"""From the text of a tasks.yaml to tasks."""

from __future__ import annotations

from typing import Dict, List, Mapping, Tuple, Union

from rqt_mrta_py.config.places import PLACE, pose_of
from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.schema import Key, Row, Table, ValueType, read_document
from rqt_mrta_py.config.wording import accepted, shown
from rqt_mrta_py.config.yaml_text import parse_yaml
from rqt_mrta_py.model import Task, normalise_id

__all__ = ["TASK", "TASKS_FILE", "read_tasks"]

TASK = Table(
    "task",
    "One piece of work that robots share out among themselves.",
    (
        Key("id", ValueType.TEXT, "Name of the task, unique in the file."),
        Key("kind", ValueType.TEXT, "Name of the behaviour that carries it out."),
        Key("place", ValueType.TABLE, "Where it is done; anywhere if not given.", default=None, table=PLACE),
        Key("capabilities", ValueType.TEXTS, "What a robot must be able to do.", default=()),
        Key("predecessors", ValueType.TEXTS, "Ids of tasks that must be done before.", default=()),
        Key("resources", ValueType.TEXTS, "What the task occupies while it is carried out.", default=()),
        Key("robots", ValueType.WHOLE, "How many robots it needs.", default=1, minimum=1),
        Key("expected_duration", ValueType.NUMBER, "How long one robot is expected to take.", "s", None, above=0),
        Key("perpetual", ValueType.SWITCH, "Whether it never ends by itself.", default=False),
        Key("data", ValueType.FREE, "Whatever its behaviour wants to know besides.", default={}),
    ),
)

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
    return tuple(_task(row) for row in rows)


def _task(row: Row) -> Task:
    values = row.values
    return Task(
        id=normalise_id(values["id"]),
        kind=values["kind"],
        place=pose_of(values["place"]),
        capabilities=values["capabilities"],
        predecessors=tuple(normalise_id(other) for other in values["predecessors"]),
        resources=values["resources"],
        robots=values["robots"],
        expected_duration=values["expected_duration"],
        perpetual=values["perpetual"],
        data=dict(values["data"]),
    )


def _check_ids(rows: List[Row], problems: Problems) -> None:
    lines: Dict[str, int] = {}
    for row in rows:
        name = _id(row)
        line, element = row.at("id")
        if name is None:
            continue
        if any(character.isspace() for character in name) or not name:
            problems.add(line, element, f"must be a name without spaces (got {shown(row.values['id'])})")
        elif name in lines:
            problems.add(line, element, f"{name!r} names two tasks; the first one is in line {lines[name]}")
        lines.setdefault(name, line)


def _check_predecessors(rows: List[Row], problems: Problems) -> None:
    before: Dict[str, List[str]] = {}
    where: Dict[str, Row] = {}
    for row in rows:
        name = _id(row)
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


def _id(row: Row) -> Union[str, None]:
    value = row.values["id"]
    return normalise_id(value) if isinstance(value, str) else None
