"""Bags that were recorded on robots: whose clock their receipts are by, and what each of them tells of the others'."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Dict, Iterable, Iterator, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.review.recordings import Recording
from rqt_mrta_py.model.timing import ClockPair, TimingTable
from rqt_mrta_py.supervisor.clocks import Timings, clock_pairs
from rqt_mrta_py.transport import Block

__all__ = ["HostTimings", "host_of"]

_FURTHER = re.compile(r"(?:[_-]\d[\d_-]*)?\Z")
"""What may stand behind a robot's name: the number of a part, the date that ``rosbag record -o`` adds."""


def host_of(stem: str, robots: Iterable[str]) -> Optional[str]:
    """Tell on which robot a bag was recorded, by its name.

    Args:
        stem: of the file's name, such as ``robot1_2026-05-04-10-00-00``.
        robots: ids.

    Returns:
        The longest id that the name is, or that a number or date follows there; None if there is none.
    """
    fitting = [robot for robot in robots if stem.startswith(robot) and _FURTHER.match(stem, len(robot))]
    return max(fitting, key=len, default=None)


class HostTimings:
    """Times each of several bags by itself; keeps little of one bag alone, which has one receiver."""

    def __init__(self) -> None:
        self._timed: List[Tuple[str, Timings]] = []

    def heard(self, bag: Recording, blocks: Iterable[Block]) -> Iterator[Block]:
        """Take in the blocks of a bag on their way."""
        timings = Timings()
        self._timed.append((bag.path.stem, timings))
        for block in blocks:
            timings.take_together(
                block.connections,
                block.numbers,
                block.receipts,
                content=block.content,
                begins=block.begins,
                ends=block.ends,
            )
            yield block

    def table(self, together: Timings, robots: Sequence[str]) -> TimingTable:
        """Sum up, with the clocks of robots that recorded each other.

        Args:
            together: what all bags tell as one stream.
            robots: ids, in order.
        """
        return replace(together.table(robots), pairs=self._pairs(robots))

    def _pairs(self, robots: Sequence[str]) -> Tuple[ClockPair, ...]:
        leads: Dict[str, Dict[str, float]] = {}
        for robot in robots:
            for stem, timings in self._timed:
                if host_of(stem, robots) != robot:
                    continue
                found = leads.setdefault(robot, {})
                for each in timings.table(robots).robots:
                    found[each.robot] = max(each.clock.at_least, found.get(each.robot, each.clock.at_least))
        return clock_pairs(leads)
