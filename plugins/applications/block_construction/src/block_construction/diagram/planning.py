"""From a structure to its diagram, by any planner."""

from __future__ import annotations

import math
import time
from typing import Any, Callable, Dict, Mapping, NamedTuple, Optional, Sequence, Tuple

from block_construction.diagram.diagram import AssemblyDiagram, assembly_diagram
from block_construction.errors import ConstructionError
from rqt_mrta_py.hooks import AssemblyPlanner, AssemblyRequest, Structure

__all__ = ["PlannedDiagram", "plan_diagram", "read_settings"]


class PlannedDiagram(NamedTuple):
    """What a planner came to.

    Attributes:
        diagram: checked.
        proved: whether none costs less.
        costs: of what was tried, in order.
        convergence: of the automata, as many; empty where there are none.
        seconds: of wall time that planning took, without what is done once in a process [s].
    """

    diagram: AssemblyDiagram
    proved: bool
    costs: Tuple[int, ...]
    convergence: Tuple[float, ...]
    seconds: float


def plan_diagram(
    planner: AssemblyPlanner,
    structure: Structure,
    lengths: Tuple[int, ...],
    *,
    seed: int = 0,
    settings: Optional[Mapping[str, Any]] = None,
    on_progress: Callable[[float], None] = lambda _: None,
) -> PlannedDiagram:
    """Let a planner decide which block goes where.

    Args:
        planner: one of those registered.
        structure: what shall be built.
        lengths: units of the blocks that there are, growing.
        seed: of all chance.
        settings: where they differ from the planner's defaults.
        on_progress: is told which part of the work is done, from 0 to 1.

    Raises:
        ConstructionError: the planner's answer covers the structure wrongly.
        MissingDependencyError: the planner needs what is not installed.
    """
    complete = {**planner.defaults, **(settings or {})}
    request = AssemblyRequest(structure, lengths, seed, complete, on_progress)
    planner.prepare(request)
    began = time.perf_counter()
    outcome = planner.plan(request)
    seconds = time.perf_counter() - began
    diagram = assembly_diagram(structure, lengths, outcome.placements)
    return PlannedDiagram(diagram, outcome.proved, tuple(outcome.costs), tuple(outcome.convergence), seconds)


def read_settings(defaults: Mapping[str, Any], given: Sequence[str]) -> Dict[str, Any]:
    """Read settings given as ``key=value``.

    Args:
        defaults: all settings with values of the types that are accepted.
        given: as the user wrote them.

    Returns:
        What was given, of the defaults' types.

    Raises:
        ConstructionError: a setting that there is not, or a value of another type; names what is accepted.
    """
    found: Dict[str, Any] = {}
    for each in given:
        key, equals, text = each.partition("=")
        if not equals or key not in defaults:
            raise ConstructionError(
                f"setting {each!r}: accepted are {', '.join(f'{name}=...' for name in defaults) or 'none'}"
            )
        kind = type(defaults[key])
        try:
            found[key] = _yes(text) if kind is bool else kind(text)
            if kind is float and not math.isfinite(found[key]):
                raise ValueError(text)
        except ValueError as error:
            raise ConstructionError(
                f"setting {key}: {text!r}; accepted is {_KINDS.get(kind, kind.__name__)}"
            ) from error
    return found


def _yes(text: str) -> bool:
    if text not in {"yes", "no"}:
        raise ValueError(text)
    return text == "yes"


_KINDS: Mapping[type, str] = {bool: "yes or no", int: "a whole number", float: "a finite number", str: "a word"}
