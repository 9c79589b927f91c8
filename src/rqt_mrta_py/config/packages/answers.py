"""Answers, and where each was given: a line of an answers file, a flag, a prompt."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.packages.answers_form import ANSWERS, OPTIONAL
from rqt_mrta_py.config.packages.entries import (
    ParameterEntry,
    RobotEntry,
    TaskEntry,
    TopicEntry,
    ValueEntry,
    parameter_entry,
    robot_entry,
    task_entry,
    topic_entry,
    value_entries,
)
from rqt_mrta_py.config.packages.origin import Origin
from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.yaml.rows import Row, read_document
from rqt_mrta_py.config.yaml.text import parse_yaml
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import Arena

__all__ = ["Answer", "Answers", "entries_of_text", "flag_of", "read_answers"]


@dataclass(frozen=True)
class Answer:
    """One answer.

    Attributes:
        value: in the type of its question; a table as the entry made of it.
        place: where it was given.
    """

    value: Any
    place: Origin


class Answers:
    """What is known of a package that shall be made.

    Args:
        kind: ARCHITECTURE or APPLICATION.
        given: by question.
        problems: what is wrong with further answers, by question.
    """

    def __init__(
        self,
        kind: RegistrationKind,
        given: Mapping[str, Answer],
        problems: Optional[Mapping[str, Sequence[Problem]]] = None,
    ) -> None:
        self.kind = kind
        self._given = dict(given)
        self._problems = dict(problems or {})

    def __contains__(self, key: str) -> bool:
        return key in self._given

    @property
    def refused(self) -> Mapping[str, Sequence[Problem]]:
        """What is wrong, by question, with answers that cannot be read; by an empty name, with none in particular."""
        return self._problems

    def value(self, key: str, otherwise: Any = None) -> Any:
        """Give an answer; ``otherwise`` where there is none."""
        return self._given[key].value if key in self._given else otherwise

    def text(self, key: str) -> str:
        """Give an answer as text without blanks around it; empty where there is none."""
        return str(self.value(key, "")).strip()

    def place(self, key: str) -> Origin:
        """Tell where a question is, or else would be, answered."""
        return self._given[key].place if key in self._given else Origin(flag_of(key), 0, "")

    def covered(self, others: Mapping[str, Answer]) -> Answers:
        """Give these answers, others covering them."""
        refused = {key: problems for key, problems in self._problems.items() if key not in others}
        return Answers(self.kind, {**self._given, **others}, refused)

    def problem(self, key: str, message: str) -> Problem:
        """Say what is wrong with an answer, or with its absence."""
        return self.place(key).problem(message)

    @property
    def robots(self) -> Sequence[RobotEntry]:
        """The team."""
        return tuple(self.value("robots", ()))

    @property
    def tasks(self) -> Sequence[TaskEntry]:
        """What there is to do."""
        return tuple(self.value("tasks", ()))

    @property
    def topics(self) -> Sequence[TopicEntry]:
        """Monitored topics of an architecture."""
        return tuple(self.value("topics", ()))

    @property
    def templates(self) -> Sequence[ParameterEntry]:
        """Parameters that an architecture declares."""
        return tuple(self.value("parameters", ()))

    @property
    def values(self) -> Sequence[ValueEntry]:
        """Parameters that an application sets."""
        return tuple(self.value("parameters", ()))


def flag_of(key: str) -> str:
    """Name the flag of the command line that answers a question."""
    named = {
        "package": "NAME",
        "parameters": "--set",
        "robots": "--robot",
        "run_depends": "--run-depend",
        "tasks": "--task",
        "topics": "--topic",
    }
    return named.get(key, f"--{key.replace('_', '-')}")


def read_answers(path: Path, kind: RegistrationKind) -> Answers:
    """Read a file of answers.

    Args:
        path: of the file, YAML by the table in ``answers_form``.
        kind: ARCHITECTURE or APPLICATION.

    Returns:
        What it answers, which need not be everything; what is wrong by its table is told there.

    Raises:
        ConfigError: it cannot be read, or is not YAML.
    """
    problems = Problems(str(path))
    row = read_document(parse_yaml(read_file(path, any_kind=True), str(path)), OPTIONAL[kind], problems)
    refused: Dict[str, List[Problem]] = {}
    for problem in problems.found:
        key = re.split(r"[/\[]", problem.element)[0]
        refused.setdefault(key if key in row.values else "", []).append(problem)
    given: Dict[str, Answer] = {}
    for key in row.given:
        if key in refused:
            continue
        place = Origin(str(path), *row.at(key))
        try:
            given[key] = Answer(_converted(kind, key, row.values[key], place), place)
        except ConfigError as error:
            refused[key] = list(error.problems)
    return Answers(kind, given, refused)


def entries_of_text(key: str, text: str, flag: str) -> Tuple[Any, ...]:
    """Read one topic or parameter of an architecture from a flag.

    Args:
        key: ``topics`` or ``parameters``.
        text: a mapping as YAML has it, braces left out.
        flag: that problems name.

    Raises:
        ConfigError: with everything that is wrong.
    """
    problems = Problems(flag)
    table = next(each.table for each in ANSWERS[RegistrationKind.ARCHITECTURE].keys if each.name == key)
    if table is None:
        raise ValueError(key)
    inner = text.strip()
    try:
        row = read_document(parse_yaml(inner if inner.startswith("{") else f"{{{inner}}}", flag), table, problems)
        problems.raise_if_any()
    except ConfigError as error:
        # A flag has no lines.
        raise ConfigError(Problem(flag, 0, each.element, each.message) for each in error.problems) from error
    maker = topic_entry if key == "topics" else parameter_entry
    return (replace(maker(row, flag, 1), place=Origin(flag)),)


def _converted(kind: RegistrationKind, key: str, value: Any, place: Origin) -> Any:
    """Turn rows of a file into what they stand for."""
    if key == "parameters" and kind is RegistrationKind.APPLICATION:
        return value_entries(value, place)
    if key == "arena":
        return Arena(**value.values)
    makers = {"robots": robot_entry, "tasks": task_entry, "topics": topic_entry, "parameters": parameter_entry}
    if key not in makers:
        return value
    rows: Tuple[Row, ...] = tuple(value)
    return tuple(makers[key](row, place.path, number) for number, row in enumerate(rows, start=1))
