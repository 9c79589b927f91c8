"""An integer programme that grows: solved, cut, and solved again until nothing is violated."""

from __future__ import annotations

from typing import TYPE_CHECKING, Callable, List, NamedTuple, Optional, Sequence

import numpy as np

from rqt_mrta_py.hooks import MissingDependencyError, MrtaError

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Programme", "Row", "UnsolvedError"]

_WHOLE = 1e-6
"""What lies so near to a whole number counts as one."""


class UnsolvedError(MrtaError):
    """A programme was not solved to the end, for want of time."""


class Row(NamedTuple):
    """A bound on the sum of some variables.

    Attributes:
        variables: their numbers.
        low, high: the sum's bounds.
    """

    variables: NDArray[np.intp]
    low: float
    high: float


class Programme:
    """Minimises a linear cost over variables of 0 or 1.

    Attributes:
        cuts: how many rows were added because a solution violated them.

    Args:
        costs: of the variables.
    """

    def __init__(self, costs: NDArray[np.float64]) -> None:
        self._costs = costs
        self._rows: List[Row] = []
        self.cuts = 0

    def add(self, row: Row) -> None:
        """Bound one sum more."""
        self._rows.append(row)

    def solve_with_cuts(
        self, violated: Callable[[NDArray[np.float64]], Sequence[Row]], time_limit: Optional[float] = None
    ) -> NDArray[np.float64]:
        """Find the whole solution of the least cost that violates nothing.

        Args:
            violated: finds rows that a solution, whole or not, should have kept to.
            time_limit: for each programme that is solved [s]; None for none.

        Returns:
            The variables.

        Raises:
            UnsolvedError: a programme was not solved within its limit.
            MissingDependencyError: SciPy is not installed.
        """
        whole = False
        while True:
            values = self._solve(whole, time_limit)
            rows = violated(values)
            if rows:
                self.cuts += len(rows)
                self._rows.extend(rows)
            elif whole or np.abs(values - np.rint(values)).max(initial=0.0) < _WHOLE:
                return values
            else:
                whole = True

    def _solve(self, whole: bool, time_limit: Optional[float]) -> NDArray[np.float64]:
        try:
            from scipy.optimize import Bounds, LinearConstraint, milp
            from scipy.sparse import csr_array
        except ImportError as error:
            raise MissingDependencyError("proved optimum: SciPy is not installed; install scipy") from error
        ends = np.cumsum([0, *(len(row.variables) for row in self._rows)])
        columns = np.concatenate([row.variables for row in self._rows])
        matrix = csr_array((np.ones(len(columns)), columns, ends), shape=(len(self._rows), len(self._costs)))
        limits = [np.array([getattr(row, end) for row in self._rows]) for end in ("low", "high")]
        options = {"mip_rel_gap": 0.0, **({} if time_limit is None else {"time_limit": time_limit})}
        found = milp(
            self._costs,
            integrality=np.full(len(self._costs), int(whole)),
            bounds=Bounds(0.0, 1.0),
            constraints=LinearConstraint(matrix, *limits),
            options=options,
        )
        if found.status != 0:
            raise UnsolvedError(f"a programme of {len(self._costs)} variables was not solved: {found.message}")
        values: NDArray[np.float64] = found.x
        return values
