"""Two readings of PLA's noise, beside FALA."""

from __future__ import annotations

from typing import Any, Dict, Tuple

from block_construction.experiments.trainings import Case

__all__ = ["READINGS", "READING_NOTE", "reading_of"]

_PRINTED = "PLA, noise sqrt(l1) s"
READINGS: Tuple[Tuple[str, Dict[str, Any]], ...] = (("PLA", {}), ("PLA", {"noise_scale": "root"}), ("FALA", {}))
"""Method and settings that differ from its defaults."""
READING_NOTE = f"PLA adds l1 s to its parameters; {_PRINTED}, is equation 2.6 as it is printed."
"""What tables say of them."""


def reading_of(case: Case) -> str:
    """Name a case's method, with its reading of the noise where that is not the default."""
    return _PRINTED if case.settings.get("noise_scale") == "root" else case.method
