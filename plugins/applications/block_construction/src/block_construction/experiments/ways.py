"""Ways of training that differ from the source's, and how samples of them are shown."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Tuple

from team_measures.statistics.tables import estimate_text

from block_construction.experiments.trainings import Sample

__all__ = ["LOCAL", "REOPENED", "SAMPLE_COLUMNS", "WAYS", "WAY_NOTES", "sample_row"]

LOCAL, REOPENED = "local credit", "local credit, begun anew"
WAYS: Mapping[str, Mapping[str, Dict[str, Any]]] = {
    LOCAL: {
        "FALA": {"rate": 0.01, "credit": "local", "converged": 0.995},
        "PLA": {"rate": 0.05, "credit": "local", "converged": 0.995},
    },
    REOPENED: {
        "FALA": {"rate": 0.03, "credit": "local", "converged": 0.98, "reopen": "yes"},
        "PLA": {"rate": 0.1, "credit": "local", "converged": 0.96, "reopen": "yes", "leg": 1500},
    },
}
"""Settings by way and method."""
WAY_NOTES = (
    "Local credit: each automaton is told the cost of its own block. Begun anew: whenever training has come to rest, "
    "levels beside a row of faults forget what they learned, and what they come to is taken unless it costs more; "
    "training ends at a cost that no diagram is below.",
)
"""What tables say of them."""
SAMPLE_COLUMNS = ("cost", "least", "hits", "iterations")
"""What ``sample_row`` gives."""


def sample_row(sample: Sample) -> Tuple[Any, ...]:
    """Give the cells of a sample: cost, least cost, hits, iterations."""
    hits = f"{sample.hits} of {len(sample.costs)}"
    return estimate_text(sample.cost, 1), min(sample.costs), hits, estimate_text(sample.mean_iterations, 0)
