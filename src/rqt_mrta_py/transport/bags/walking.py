"""Bags without an index, read in blocks: what a walk over them finds, nearly by time.

A recorder writes messages as it receives them, so the order of the file is that of time, but for neighbours that it
received at nearly the same moment: these are put in order.
"""

from __future__ import annotations

from itertools import islice
from pathlib import Path
from typing import Callable, Dict, Iterator, List, Optional, Tuple

from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.bags.blocks import Block, ConnectionList
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk
from rqt_mrta_py.transport.bags.faults import BagFaults
from rqt_mrta_py.transport.bags.reader import BagInfo, Excerpt

__all__ = ["walk_info", "walked_blocks"]

_TOGETHER = 8192
"""How many messages are put in order at a time; half of them wait for those that follow."""


def walk_info(path: Path, each: Optional[Callable[[Stamped], None]] = None) -> Tuple[BagInfo, BagFaults]:
    """Walk over a bag to know what it holds.

    Args:
        path: of the bag.
        each: is told of every message; None: nobody is.

    Returns:
        What it holds, and what cannot be read.

    Raises:
        TransportError: the file cannot be read or is no ROS 1 bag.
    """
    walk = ChunkWalk(path)
    counts: Dict[Connection, int] = {}
    start_ns: Optional[int] = None
    end_ns: Optional[int] = None
    for stamped in walk:
        counts[stamped.connection] = counts.get(stamped.connection, 0) + 1
        start_ns = stamped.receipt_ns if start_ns is None else min(start_ns, stamped.receipt_ns)
        end_ns = stamped.receipt_ns if end_ns is None else max(end_ns, stamped.receipt_ns)
        if each is not None:
            each(stamped)
    return BagInfo(path, start_ns, end_ns, tuple(counts.items())), walk.all_faults


def walked_blocks(path: Path, connections: ConnectionList, excerpt: Optional[Excerpt] = None) -> Iterator[Block]:
    """Read a bag by walking over it.

    Args:
        path: of the bag.
        connections: of the blocks; those of the bag are added as they are met.
        excerpt: what to read; None: all.

    Yields:
        The messages, each block by time of receipt.

    Raises:
        TransportError: the file cannot be read or is no ROS 1 bag.
    """
    excerpt = excerpt or Excerpt()
    messages = (stamped for stamped in ChunkWalk(path) if _belongs(stamped, excerpt))
    waiting: List[Stamped] = []
    while True:
        more = list(islice(messages, _TOGETHER // 2))
        waiting = sorted([*waiting, *more], key=lambda stamped: stamped.receipt_ns)
        upto = len(waiting) if not more else max(0, len(waiting) - _TOGETHER // 2)
        if upto:
            yield Block.of(connections, waiting[:upto])
        if not more:
            return
        waiting = waiting[upto:]


def _belongs(stamped: Stamped, excerpt: Excerpt) -> bool:
    if not excerpt.wants(stamped.connection):
        return False
    receipt_ns = stamped.receipt_ns
    early = excerpt.start_ns is not None and receipt_ns < excerpt.start_ns
    return not early and (excerpt.end_ns is None or receipt_ns <= excerpt.end_ns)
