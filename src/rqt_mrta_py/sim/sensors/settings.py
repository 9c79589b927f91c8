"""Reads what a scenario sets for a sensor; what is wrong is told all at once."""

from __future__ import annotations

import math
from typing import Any, List, Sequence, Set

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import SensorContext
from rqt_mrta_py.sim.sensing.mount import where_it_is
from rqt_mrta_py.wording import accepted

__all__ = ["SensorSettings"]


class SensorSettings:
    """The parameters of a sensor: asked for one by one, then finished, so that those nobody asked for are found.

    Args:
        contexts: of the sensor, one for each robot that carries it; their setups are equal.
    """

    def __init__(self, contexts: Sequence[SensorContext]) -> None:
        self._contexts = contexts
        self._values = contexts[0].setup.parameters
        self._asked: Set[str] = set()
        self._problems: List[str] = []

    def number(
        self, name: str, default: float, *, least: float = 0.0, most: float = math.inf, above: bool = False
    ) -> float:
        """Read a finite number.

        Args:
            name: of the parameter.
            default: if the scenario does not set it.
            least: lower bound, accepted.
            most: upper bound, accepted.
            above: True if ``least`` itself is not accepted.

        Returns:
            The value, or the default if the value is not acceptable; ``finish`` then raises.
        """
        value = self._ask(name, default)
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
        if is_number and least <= value <= most and not (above and value == least):
            return float(value)
        bounds = f"{'above' if above else 'at least'} {least:g}" + (f", at most {most:g}" if most < math.inf else "")
        return self._refuse(name, value, f"must be a number {bounds}", default)

    def whole(self, name: str, default: int, *, least: int = 1, most: int) -> int:
        """Read a whole number; bounds, default and refusal as of ``number``."""
        value = self._ask(name, default)
        if isinstance(value, int) and not isinstance(value, bool) and least <= value <= most:
            return value
        return int(self._refuse(name, value, f"must be a whole number from {least} to {most}", default))

    def switch(self, name: str, default: bool) -> bool:
        """Read true or false; default and refusal as of ``number``."""
        value = self._ask(name, default)
        if isinstance(value, bool):
            return value
        self.refuse(name, value, "must be true or false")
        return default

    def refuse(self, name: str, value: object, accepted: str) -> None:
        """Note that a value does not go with the others; ``finish`` then raises.

        Args:
            name: of the parameter.
            value: what it is.
            accepted: what it must be, as in ``must be above min_range (0.05)``.
        """
        self._problems.append(f"parameter {name}: {accepted} (got {value!r})")

    def finish(self) -> None:
        """End the reading.

        Raises:
            SimError: a value is not acceptable, or a parameter is unknown; one line for each, and for each robot.
        """
        for name in sorted(set(self._values) - self._asked, key=str):
            known = accepted(str(name), sorted(self._asked))
            self._problems.append(f"parameter {name}: unknown; {known}")
        if self._problems:
            wheres = [where_it_is(context) for context in self._contexts]
            raise SimError("\n".join(f"{where}: {problem}" for where in wheres for problem in self._problems))

    def _ask(self, name: str, default: float) -> Any:
        self._asked.add(name)
        return self._values.get(name, default)

    def _refuse(self, name: str, value: object, accepted: str, default: float) -> float:
        self.refuse(name, value, accepted)
        return default
