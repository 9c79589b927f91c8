"""The radio that nobody has."""

from __future__ import annotations

from typing import Sequence

from rqt_mrta_py.config.yaml.schema import Table
from rqt_mrta_py.hooks import LinkSetup
from rqt_mrta_py.sim.radio.settings import read_settings

__all__ = ["PERFECT", "PerfectLink"]

PERFECT = Table("perfect", "Every message arrives once and at once.", ())

_AT_ONCE = (0.0,)


class PerfectLink:
    """Every message arrives once and at once."""

    @classmethod
    def of(cls, setup: LinkSetup) -> PerfectLink:
        """Make one as a scenario sets it up.

        Raises:
            SimError: it sets parameters; there are none.
        """
        read_settings(setup.parameters, PERFECT)
        return cls()

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        """Answer one copy without delay, whoever talks to whom."""
        return _AT_ONCE
