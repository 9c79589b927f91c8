"""The tables of Dantas (2017) about assembly diagrams, as data."""

from __future__ import annotations

from typing import Mapping, NamedTuple, Tuple

__all__ = [
    "EXTENSION_RESULTS",
    "MEMORY_RESULTS",
    "MINIMA",
    "PARAMETER_RESULTS",
    "RATE_RESULTS",
    "STRUCTURE_RESULTS",
    "ExtensionResult",
    "MemoryResult",
    "ParameterResult",
    "RateResult",
    "StructureResult",
]


class ParameterResult(NamedTuple):
    """One row of table 3: PLA on the cistern, l1 0.1, J 100, 10 runs of at most 10000 iterations."""

    stiffness: float
    power: int
    bound: float
    iterations: float
    hits: int
    """Of runs that reach the minimum [%]."""


PARAMETER_RESULTS: Tuple[ParameterResult, ...] = (
    ParameterResult(1.0, 1, 5.0, 4315.2, 100),
    ParameterResult(2.0, 3, 10.0, 4315.2, 100),
    ParameterResult(0.5, 1, 5.0, 4315.2, 100),
    ParameterResult(0.5, 3, 10.0, 4315.2, 100),
    ParameterResult(1.0, 2, 1.0, 10000.0, 80),
    ParameterResult(2.0, 3, 1.0, 10000.0, 90),
    ParameterResult(1.0, 1, 1.0, 10000.0, 10),
)


class MemoryResult(NamedTuple):
    """One column of tables 4 (PLA) and 5 (FALA): the cistern, l1 0.1, 10 runs of at most 10000 iterations."""

    memory: int
    iterations: float
    hits: int
    """Of runs that reach the minimum [%]."""


MEMORY_RESULTS: Mapping[str, Tuple[MemoryResult, ...]] = {
    "PLA": (
        MemoryResult(5, 4173.7, 100),
        MemoryResult(10, 4133.6, 100),
        MemoryResult(50, 4275.4, 100),
        MemoryResult(70, 4180.9, 100),
        MemoryResult(100, 4315.2, 100),
        MemoryResult(200, 4540.2, 100),
        MemoryResult(500, 4925.1, 100),
        MemoryResult(1000, 5197.4, 100),
        MemoryResult(2000, 5805.3, 100),
    ),
    "FALA": (
        MemoryResult(5, 1868.8, 80),
        MemoryResult(10, 1201.0, 80),
        MemoryResult(50, 1789.4, 80),
        MemoryResult(70, 1418.6, 80),
        MemoryResult(100, 1402.4, 100),
        MemoryResult(200, 1547.4, 100),
        MemoryResult(500, 1593.6, 100),
        MemoryResult(1000, 1708.8, 100),
    ),
}


class RateResult(NamedTuple):
    """One row of table 6: the cistern, J 100, 100 runs of at most 10000 iterations."""

    rate: float
    iterations: float
    cost: float
    hits: int
    """Of runs that reach the minimum [%]."""


RATE_RESULTS: Mapping[str, Tuple[RateResult, ...]] = {
    "PLA": (
        RateResult(0.005, 10000.0, 55.37, 0),
        RateResult(0.01, 10000.0, 49.78, 0),
        RateResult(0.02, 10000.0, 38.51, 0),
        RateResult(0.03, 10000.0, 32.64, 58),
        RateResult(0.06, 7055.0, 32.0, 100),
        RateResult(0.08, 5349.0, 32.0, 100),
        RateResult(0.1, 4415.1, 32.0, 100),
        RateResult(0.15, 2998.8, 32.0, 100),
        RateResult(0.2, 2333.1, 32.0, 100),
        RateResult(0.25, 2086.3, 32.01, 99),
        RateResult(0.35, 1974.1, 32.04, 98),
        RateResult(0.4, 1766.3, 32.07, 97),
        RateResult(0.45, 1454.6, 32.11, 97),
        RateResult(0.5, 1847.9, 32.22, 94),
        RateResult(0.6, 1845.5, 32.46, 90),
        RateResult(0.7, 2027.3, 32.89, 80),
        RateResult(0.8, 1867.3, 32.91, 78),
        RateResult(0.9, 1624.5, 33.8, 65),
    ),
    "FALA": (
        RateResult(0.005, 10000.0, 43.37, 0),
        RateResult(0.01, 10000.0, 32.11, 93),
        RateResult(0.02, 6333.9, 32.0, 100),
        RateResult(0.03, 4218.3, 32.0, 100),
        RateResult(0.06, 2150.1, 32.0, 100),
        RateResult(0.08, 1905.6, 32.39, 95),
        RateResult(0.1, 1504.2, 32.21, 96),
        RateResult(0.15, 2068.6, 33.14, 76),
        RateResult(0.2, 3343.7, 33.59, 59),
        RateResult(0.25, 3301.2, 34.88, 38),
        RateResult(0.35, 4509.1, 36.39, 22),
        RateResult(0.4, 5489.0, 37.75, 7),
        RateResult(0.45, 5220.1, 38.55, 3),
        RateResult(0.5, 5233.3, 39.89, 2),
        RateResult(0.6, 4346.2, 42.37, 0),
        RateResult(0.7, 5756.9, 43.74, 1),
        RateResult(0.8, 6112.1, 45.18, 0),
        RateResult(0.9, 6736.2, 46.67, 0),
    ),
}


class ExtensionResult(NamedTuple):
    """One row of table 7: 10 runs of at most 75000 iterations; one mean of iterations is above that, as printed."""

    structure: str
    method: str
    pace: str
    rate: float
    memory: int
    cost: float
    least: int
    iterations: float
    minutes: float
    """Of computing, as printed [min]."""
    hits: int
    """Runs that reach the minimum."""

    @property
    def iterations_per_second(self) -> float:
        """How fast the source computed [1/s]."""
        return self.iterations / (60.0 * self.minutes)


EXTENSION_RESULTS: Tuple[ExtensionResult, ...] = (
    ExtensionResult("horizontal_extension", "PLA", "safe", 0.2, 100, 167.3, 160, 36796, 58.0, 4),
    ExtensionResult("horizontal_extension", "PLA", "fast", 0.45, 10, 161.8, 160, 35126, 56.0, 8),
    ExtensionResult("horizontal_extension", "FALA", "safe", 0.06, 100, 168.6, 160, 21232, 27.0, 5),
    ExtensionResult("horizontal_extension", "FALA", "fast", 0.1, 10, 175.8, 160, 16015, 20.0, 3),
    ExtensionResult("vertical_extension", "PLA", "safe", 0.2, 100, 113.4, 112, 24417, 24.0, 3),
    ExtensionResult("vertical_extension", "PLA", "fast", 0.45, 10, 115.0, 112, 36586, 37.0, 1),
    ExtensionResult("vertical_extension", "FALA", "safe", 0.06, 100, 114.8, 112, 92763, 77.0, 4),
    ExtensionResult("vertical_extension", "FALA", "fast", 0.1, 10, 120.9, 116, 41177, 34.0, 0),
)


class StructureResult(NamedTuple):
    """One row of tables 9, 11, 13 and 15: 10 runs of 5000 iterations, l1 0.2, J 100."""

    structure: str
    method: str
    cost: float
    least: int
    convergence: float
    """Mean of the last 100 values."""


STRUCTURE_RESULTS: Tuple[StructureResult, ...] = (
    StructureResult("tower", "FALA", 30.0, 30, 0.9532),
    StructureResult("tower", "PLA", 30.0, 30, 0.9542),
    StructureResult("dam", "FALA", 19.2, 19, 0.9183),
    StructureResult("dam", "PLA", 19.2, 19, 0.9210),
    StructureResult("pyramid", "FALA", 46.2, 46, 0.9545),
    StructureResult("pyramid", "PLA", 46.7, 46, 0.9453),
    StructureResult("station", "FALA", 32.9, 32, 0.9311),
    StructureResult("station", "PLA", 32.5, 32, 0.9232),
)

MINIMA: Mapping[str, int] = {
    "wall": 6,
    "tower": 30,
    "dam": 19,
    "pyramid": 46,
    "station": 32,
    "cistern": 32,
    "horizontal_extension": 160,
    "vertical_extension": 112,
}
"""The least costs that the source knows, which are all proved to be optima."""
