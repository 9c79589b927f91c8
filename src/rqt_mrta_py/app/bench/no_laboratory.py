"""The laboratory of benchmarks that simulate no missions."""

from __future__ import annotations

from typing import Iterator, Sequence

from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Experiment, Trial

__all__ = ["NoLaboratory"]


class NoLaboratory:
    """Carries out no experiment."""

    def trials(self, experiments: Sequence[Experiment]) -> Iterator[Trial]:
        """Give nothing for no experiments.

        Raises:
            UsageError: there are experiments.
        """
        if experiments:
            raise UsageError(f"{experiments[0].application}: no laboratory is at hand to simulate missions in")
        return iter(())
