"""The integer programme of an assembly diagram, layer by layer.

No block spans two concentric layers and faults are between cells of one column, so that layers do not meet: each has a
programme of its own. For every placement that its cells allow there is a variable x, for every cell with another one on
top a variable f:

    each cell is covered by exactly one placement
    f >= A_k + B_k - 1      for k in 2, 3, 5, 6

where A_k says that the lower cell has code k or 4, B_k the same of the upper cell. These four rows hold f at 1 for all
13 pairs of codes that are faults. Minimised is the number of placements and faults, F_rb (Dantas 2017, equation 5.5).
"""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, Sequence, Tuple

from block_construction.diagram.actions import actions_by_cell
from block_construction.diagram.codes import codes_of
from block_construction.errors import ConstructionError
from block_construction.structure.layers import layer_of
from rqt_mrta_py.hooks import BlockPlacement, MissingDependencyError, Structure, Voxel

__all__ = ["LayerOptimum", "Programme", "layer_programmes", "load_solver", "solve"]

_ENDS = (2, 3, 5, 6)
_SINGLE = 4
_ANY_TIME = 1e9


class Programme(NamedTuple):
    """What may lie in one concentric layer.

    Attributes:
        layer: which.
        placements: all that its cells allow.
        cells: its filled cells.
    """

    layer: int
    placements: Tuple[BlockPlacement, ...]
    cells: Tuple[Voxel, ...]


class LayerOptimum(NamedTuple):
    """What was found for one layer, and whether it is proved that nothing costs less."""

    placements: Tuple[BlockPlacement, ...]
    proved: bool


def layer_programmes(structure: Structure, lengths: Sequence[int]) -> Tuple[Programme, ...]:
    """Part a structure's possible placements by concentric layers, from the outermost in.

    Args:
        structure: what shall be built.
        lengths: units of the blocks that there are, growing.
    """
    placements: Dict[int, List[BlockPlacement]] = {}
    cells: Dict[int, List[Voxel]] = {}
    for cell, actions in actions_by_cell(structure, lengths).items():
        layer = layer_of(cell.x, cell.y, structure.columns, structure.rows)
        cells.setdefault(layer, []).append(cell)
        placements.setdefault(layer, []).extend(BlockPlacement(*cell, length) for length in actions)
    return tuple(Programme(layer, tuple(placements[layer]), tuple(cells[layer])) for layer in sorted(cells))


def load_solver() -> Any:
    """Import the solver, which takes a second the first time.

    Raises:
        MissingDependencyError: OR-tools is not installed.
    """
    try:
        from ortools.sat.python import cp_model
    except ImportError as error:
        raise MissingDependencyError(
            "OR-tools is not installed; install ortools, or choose another method than exact"
        ) from error
    return cp_model


def solve(programme: Programme, *, seed: int, time_limit: float) -> LayerOptimum:
    """Find the placements of a layer that cost least.

    Args:
        programme: of the layer.
        seed: of the search; the same has the same answer, unless the time runs out.
        time_limit: of the search [s]; 0: as long as it takes.

    Raises:
        MissingDependencyError: OR-tools is not installed.
        ConstructionError: the time ran out before anything was found.
    """
    cp_model = load_solver()
    model = cp_model.CpModel()
    chosen = [model.new_bool_var("") for _ in programme.placements]
    covering: Dict[Voxel, List[Any]] = {cell: [] for cell in programme.cells}
    coded: Dict[Tuple[Voxel, int], List[Any]] = {}
    for placement, variable in zip(programme.placements, chosen):
        for cell, code in zip(placement.cells(), codes_of(placement.length)):
            covering[cell].append(variable)
            coded.setdefault((cell, code), []).append(variable)
    for variables in covering.values():
        model.add_exactly_one(variables)
    faults = [_fault(model, coded, cell) for cell in programme.cells if cell._replace(z=cell.z + 1) in covering]
    model.minimize(sum(chosen) + sum(faults))
    solver = cp_model.CpSolver()
    # Several workers would race, and another one win each time.
    solver.parameters.num_workers = 1
    solver.parameters.random_seed = seed % 2**31
    solver.parameters.max_time_in_seconds = time_limit or _ANY_TIME
    status = solver.solve(model)
    if status not in (cp_model.OPTIMAL, cp_model.FEASIBLE):
        raise ConstructionError(f"layer {programme.layer}: nothing found within {time_limit:g} s; give it more time")
    taken = tuple(each for each, variable in zip(programme.placements, chosen) if solver.value(variable))
    return LayerOptimum(taken, status == cp_model.OPTIMAL)


def _fault(model: Any, coded: Mapping[Tuple[Voxel, int], Sequence[Any]], cell: Voxel) -> Any:
    """Add the variable of a cell's fault with the one above."""
    fault, above = model.new_bool_var(""), cell._replace(z=cell.z + 1)
    singles = (coded.get((cell, _SINGLE), ()), coded.get((above, _SINGLE), ()))
    for end in _ENDS:
        lower, upper = (*coded.get((cell, end), ()), *singles[0]), (*coded.get((above, end), ()), *singles[1])
        if lower and upper:
            model.add(fault >= sum(lower) + sum(upper) - 1)
    return fault
