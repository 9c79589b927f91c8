"""Two ways to give out tasks when all costs are known: greedily, and at the least total cost.

Both give single-robot tasks to single-task robots for now (ST-SR-IA in the taxonomy of B. P. Gerkey and M. J. Mataric,
A formal analysis and taxonomy of task allocation in multi-robot systems, IJRR 23(9), 2004): the optimal
assignment problem. A task that needs several robots gets all of them or none, which neither method solves exactly:
as long as a task is short of robots, the last such task in the problem's order is left out and all is done again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Callable, Dict, List, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import AllocationProblem, MissingDependencyError

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["allocate_nearest", "allocate_optimally"]

_Pairs = List[Tuple[int, int]]


def allocate_nearest(problem: AllocationProblem) -> Sequence[Tuple[str, str]]:
    """Give out the cheapest pair of a free robot and an open task, and so on until none is left.

    With costs c_rt, robots R still free and tasks T still short of robots, each step takes

        (r*, t*) = arg min c_rt  over r in R, t in T, c_rt < infinity

    and removes r* from R, and t* from T once it has all its robots. Of equal costs the task that comes first in the
    problem wins, then the robot that does. Of total utility such greed reaches at least half of the
    best (Gerkey and Mataric 2004); of total cost no such bound holds.

    Args:
        problem: see there.

    Returns:
        Pairs of task and robot, in the problem's order of tasks, then of robots.
    """
    return _whole_teams(problem, _cheapest_first)


def allocate_optimally(problem: AllocationProblem) -> Sequence[Tuple[str, str]]:
    """Give tasks to as many robots as can be, at the least total cost.

    With x_rt in {0, 1}, and n_t the robots that task t needs, maximise first the number of pairs, then

        minimise  sum c_rt x_rt   subject to  sum_t x_rt <= 1,  sum_r x_rt <= n_t,  x_rt = 0 where c_rt = infinity

    by the linear assignment of H. W. Kuhn (The Hungarian method for the assignment problem, Naval Research Logistics
    Quarterly 2, 1955), as SciPy solves it; a task that needs n robots stands in n columns.

    Args:
        problem: see there.

    Returns:
        Pairs of task and robot, in the problem's order of tasks, then of robots.

    Raises:
        MissingDependencyError: SciPy is not installed.
    """
    return _whole_teams(problem, _least_total)


def _whole_teams(
    problem: AllocationProblem, assign: Callable[[NDArray[np.float64], List[int]], _Pairs]
) -> Sequence[Tuple[str, str]]:
    costs = np.asarray(problem.costs, dtype=np.float64).reshape(len(problem.robots), len(problem.tasks))
    able = np.isfinite(costs).sum(axis=0)
    tasks = [index for index, task in enumerate(problem.tasks) if 0 < task.robots <= able[index]]
    while True:
        needed = [problem.tasks[index].robots for index in tasks]
        pairs = [(tasks[column], row) for row, column in assign(costs[:, tasks], needed)]
        given: Dict[int, int] = {}
        for index, _ in pairs:
            given[index] = given.get(index, 0) + 1
        short = [index for index in tasks if 0 < given.get(index, 0) < problem.tasks[index].robots]
        if not short:
            return [(problem.tasks[index].id, problem.robots[row]) for index, row in sorted(pairs)]
        tasks.remove(short[-1])


def _cheapest_first(costs: NDArray[np.float64], needed: List[int]) -> _Pairs:
    """Choose pairs of row and column by rising cost; each row once, each column as often as needed."""
    robots = costs.shape[0]
    open_places = list(needed)
    free = [True] * robots
    by_task = costs.T.ravel()
    order = np.argsort(by_task, kind="stable")[: int(np.isfinite(by_task).sum())]
    pairs: _Pairs = []
    for position in order.tolist():
        column, row = divmod(position, robots)
        if free[row] and open_places[column]:
            free[row] = False
            open_places[column] -= 1
            pairs.append((row, column))
    return pairs


def _least_total(costs: NDArray[np.float64], needed: List[int]) -> _Pairs:
    """Choose pairs of row and column of the least total cost among the most pairs."""
    finite = np.isfinite(costs)
    if not finite.any():
        return []
    try:
        from scipy.optimize import linear_sum_assignment
    except ImportError as error:
        raise MissingDependencyError(
            "allocator nearest_robot/optimal: SciPy is not installed; install scipy, or choose nearest_robot/nearest"
        ) from error
    low, high = costs[finite].min(), costs[finite].max()
    places = np.repeat(np.arange(costs.shape[1]), needed)
    # Dearer than any number of possible pairs, so that an impossible one is chosen only where nothing else is left.
    impossible = (high - low + 1.0) * (min(costs.shape[0], len(places)) + 1)
    filled = np.where(finite, costs - low, impossible)[:, places]
    rows, columns = linear_sum_assignment(filled)
    chosen = zip(rows.tolist(), places[columns].tolist())
    return [(row, column) for row, column in chosen if finite[row, column]]
