"""From the text of a file of tolerances to tolerances."""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Tuple, Union

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.yaml.rows import Row, read_document
from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.config.yaml.text import parse_yaml
from rqt_mrta_py.model import Tolerance, Worse

__all__ = ["TOLERANCES_FILE", "ToleranceLine", "read_tolerances"]

_TOLERANCE = Table(
    "tolerance",
    "What is allowed of some figures; the greater of the two allowances counts.",
    (
        Key("figure", ValueType.TEXT, "Name of a figure; `*` stands for any characters, so `tasks.*` are several."),
        Key(
            "worse",
            ValueType.TEXT,
            "Which way these figures get worse; `never`: they are shown and not judged.",
            choices=tuple(way.value for way in Worse),
        ),
        Key("relative", ValueType.NUMBER, "Allowed change, as a share of the first mission's.", "", 0.0, 0.0),
        Key("absolute", ValueType.NUMBER, "Allowed change, in the figure's own unit.", "", 0.0, 0.0),
    ),
)

TOLERANCES_FILE = Table(
    "tolerances.yaml",
    "How much worse a mission may be than another: `mrta compare A B --tolerances FILE`, under any name.",
    (
        Key(
            "tolerances",
            ValueType.TABLES,
            "The first that matches a figure counts; after the last one those that `mrta compare` has by itself.",
            table=_TOLERANCE,
        ),
    ),
)


class ToleranceLine(NamedTuple):
    """A tolerance of a file, and the line in which its figure is named."""

    line: int
    tolerance: Tolerance


def read_tolerances(text: Union[str, bytes], path: str) -> Tuple[ToleranceLine, ...]:
    """Read a file of tolerances.

    Args:
        text: the whole file.
        path: by which problems name the file.

    Returns:
        The tolerances, in file order.

    Raises:
        ConfigError: with everything that is wrong, sorted by line.
    """
    problems = Problems(path)
    rows: List[Row] = read_document(parse_yaml(text, path), TOLERANCES_FILE, problems).values["tolerances"] or []
    lines: Dict[str, int] = {}
    for row in rows:
        figure = row.values["figure"]
        line, element = row.at("figure")
        if figure in lines:
            problems.add(line, element, f"{figure!r} stands twice; the first one is in line {lines[figure]}")
        elif figure is not None:
            lines[figure] = line
    problems.raise_if_any()
    return tuple(ToleranceLine(row.at("figure")[0], _tolerance(row)) for row in rows)


def _tolerance(row: Row) -> Tolerance:
    values = row.values
    return Tolerance(values["figure"], Worse(values["worse"]), values["relative"], values["absolute"])
