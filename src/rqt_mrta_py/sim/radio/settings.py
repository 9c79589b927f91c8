"""Reads what a scenario sets for a link; what is wrong is told all at once."""

from __future__ import annotations

from typing import Any, Dict, Mapping

from rqt_mrta_py.config.yaml.plain_values import read_plain
from rqt_mrta_py.config.yaml.schema import Table
from rqt_mrta_py.errors import SimError

__all__ = ["read_settings"]


def read_settings(parameters: Mapping[str, Any], table: Table) -> Dict[str, Any]:
    """Check parameters by a table.

    Args:
        parameters: as the scenario sets them.
        table: which there are.

    Returns:
        Values by name, defaults where nothing is set.

    Raises:
        SimError: a value is not acceptable, or a parameter is unknown; one line for each.
    """
    row, problems = read_plain(parameters, table)
    if problems:
        raise SimError("\n".join(f"{problem.element}: {problem.message}" for problem in problems))
    return row.values
