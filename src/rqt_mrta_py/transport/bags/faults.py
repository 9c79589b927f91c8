"""What is wrong with a bag, told place by place."""

from __future__ import annotations

from typing import Dict, List, NamedTuple

__all__ = ["BagFault", "BagFaults"]

_MOST_TOLD = 1000


class BagFault(NamedTuple):
    """One place of a bag that cannot be read.

    Attributes:
        position: of the record in the file, or of the chunk that holds it [bytes].
        reason: what is wrong.
        lost: what was passed over: bytes of the file, or of the content of a compressed chunk.
        missing: what the file lacks [bytes].
    """

    position: int
    reason: str
    lost: int = 0
    missing: int = 0

    def __str__(self) -> str:
        return f"byte {self.position}: {self.reason}"


class BagFaults:
    """All faults of a bag; of a bag with very many only the first are kept, the others are counted.

    Attributes:
        told: the faults, as they were found.
        untold: number of those that are not kept.
        lost: sum over all faults [bytes].
        missing: sum over all faults [bytes].
    """

    def __init__(self) -> None:
        self.told: List[BagFault] = []
        self.untold = self.lost = self.missing = 0
        self._places: Dict[str, int] = {}
        self._end = -1

    def tell(self, fault: BagFault, once: bool = False, joined: bool = False) -> None:
        """Take in a fault.

        Args:
            fault: to be told.
            once: add to an earlier fault of the same reason, wherever it is.
            joined: add to the fault before, if this one begins where that one ends.
        """
        self.lost += fault.lost
        self.missing += fault.missing
        place = self._places.get(fault.reason) if once else None
        if joined and fault.position == self._end:
            place = len(self.told) - 1
        self._end = fault.position + fault.lost if joined else -1
        if place is not None:
            known = self.told[place]
            self.told[place] = known._replace(lost=known.lost + fault.lost)
        elif len(self.told) < _MOST_TOLD:
            if once:
                self._places[fault.reason] = len(self.told)
            self.told.append(fault)
        else:
            self.untold += 1
