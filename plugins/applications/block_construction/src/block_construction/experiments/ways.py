"""Ways of training, the source's and those that differ, and how samples of them are shown."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Tuple

from team_measures.statistics.tables import estimate_text

from block_construction.experiments.trainings import Sample
from block_construction.learning.settings import FALA_TUNED, PLA_TUNED

__all__ = ["LITERAL", "LOCAL", "SAMPLE_COLUMNS", "TUNED", "WAYS", "WAY_NOTES", "sample_row"]

LITERAL, LOCAL, TUNED = "literal", "local", "tuned"
WAYS: Mapping[str, Mapping[str, Dict[str, Any]]] = {
    LITERAL: {"FALA": {"rate": 0.06}, "PLA": {"rate": 0.2}},
    LOCAL: {
        "FALA": {"rate": 0.01, "credit": "local", "converged": 0.995, "reopen": "no"},
        "PLA": {"rate": 0.05, "credit": "local", "converged": 0.995, "reopen": "no"},
    },
    TUNED: {
        method: {name: tuned[name] for name in ("rate", "credit", "converged", "leg")}
        for method, tuned in (("FALA", FALA_TUNED), ("PLA", PLA_TUNED))
    },
}
"""Settings by way and method; iterations are the measurement's."""
WAY_NOTES = (
    "Literal: the source's method with its safe rates. Local: each automaton is told the cost of its own block.",
    "Tuned, as the planners fala-tuned and pla-tuned: local credit, and whenever training has come to rest, levels "
    "beside a row of faults forget what they learned, and what they come to is taken unless it costs more; training "
    "ends at a cost that no diagram is below.",
)
"""What tables say of them."""
SAMPLE_COLUMNS = ("cost", "least", "hits", "iterations")
"""What ``sample_row`` gives."""


def sample_row(sample: Sample) -> Tuple[Any, ...]:
    """Give the cells of a sample: cost, least cost, hits, iterations."""
    hits = f"{sample.hits} of {len(sample.costs)}"
    return estimate_text(sample.cost, 1), min(sample.costs), hits, estimate_text(sample.mean_iterations, 0)
