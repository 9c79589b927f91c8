"""The bags of one mission as one stream by time of receipt, whole or not."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Dict, Iterator, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.mission_message import MISSION_TOPIC
from rqt_mrta_py.errors import TransportError, UsageError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport import (
    BagFaults,
    BagInfo,
    Block,
    ConnectionList,
    Excerpt,
    UnindexedBagError,
    merged,
    read_bag,
    read_bag_info,
    read_blocks,
    walk_info,
    walked_blocks,
)

__all__ = ["Recording", "Recordings"]

_SPLIT = re.compile(r"(?P<name>.+)_\d+\.bag")
_MOST_TOLD = 3


@dataclass(frozen=True)
class Recording:
    """One bag.

    Attributes:
        info: what it holds.
        indexed: False if it has no index, or a damaged one, and is walked over.
        faults: what cannot be read, as far as it has been read.
        told: the first message in it that says what the mission is; None if none does.
    """

    info: BagInfo
    indexed: bool
    faults: BagFaults
    told: Optional[Stamped] = None

    @property
    def path(self) -> Path:
        """Say where it is."""
        return self.info.path

    def blocks(self, connections: ConnectionList, excerpt: Excerpt) -> Iterator[Block]:
        """Read it, or a part of it."""
        if self.indexed:
            return read_blocks(self.path, connections, excerpt, self.faults)
        return walked_blocks(self.path, connections, excerpt)

    def losses(self) -> List[str]:
        """Say what could not be read, a line each, the first ones only."""
        faults = self.faults
        lines = [f"{self.path}: {fault}" for fault in faults.told[:_MOST_TOLD]]
        rest = len(faults.told) + faults.untold - len(lines)
        if rest > 0:
            lines.append(f"{self.path}: and {rest} more such places; 'mrta salvage' lists them")
        if faults.lost or faults.missing:
            lines.append(f"{self.path}: {faults.lost} bytes could not be read, {faults.missing} are missing")
        return lines


_Heard = Callable[[Recording, Iterator[Block]], Iterator[Block]]


class Recordings:
    """Bags of one mission.

    Attributes:
        bags: in the order given.
        notes: what the user should know of them, a line each.

    Args:
        paths: of the bags, at least one.

    Raises:
        UsageError: a bag is given twice, or one does not exist where parts of it do.
        TransportError: a file is no bag.
    """

    def __init__(self, paths: Sequence[Path]) -> None:
        _check_names(paths)
        self.notes: List[str] = []
        self.bags = tuple(self._opened(path) for path in paths)
        given = {path.resolve() for path in paths}
        for path in paths:
            others = [each.name for each in _parts_of(path) if each.resolve() not in given]
            if others:
                self.notes.append(f"{path}: there are more parts of this recording: {', '.join(others)}; give them too")

    @property
    def name(self) -> str:
        """Name what was recorded: the first bag, without the number of its part where all are parts."""
        parts = [_SPLIT.fullmatch(each.path.name) for each in self.bags]
        names = {part.group("name") for part in parts if part is not None}
        return names.pop() if len(parts) > 1 and all(parts) and len(names) == 1 else self.bags[0].path.stem

    @property
    def where(self) -> str:
        """Name the bags for a message."""
        more = len(self.bags) - 1
        return f"{self.bags[0].path}{f' and {more} more' if more else ''}"

    @property
    def start_ns(self) -> Optional[int]:
        """Receipt of the first message [ns]; None if there is none."""
        return min((each.info.start_ns for each in self.bags if each.info.start_ns is not None), default=None)

    @property
    def end_ns(self) -> Optional[int]:
        """Receipt of the last message [ns]; None if there is none."""
        return max((each.info.end_ns for each in self.bags if each.info.end_ns is not None), default=None)

    @property
    def connections(self) -> Dict[Connection, int]:
        """Number of messages by connection, in the order of the bags."""
        counts: Dict[Connection, int] = {}
        for bag in self.bags:
            for connection, count in bag.info.connections:
                counts[connection] = counts.get(connection, 0) + count
        return counts

    @property
    def topics(self) -> Dict[str, int]:
        """Number of messages by topic, sorted by name."""
        counts: Dict[str, int] = {}
        for connection, count in sorted(self.connections.items(), key=lambda pair: pair[0].topic):
            counts[connection.topic] = counts.get(connection.topic, 0) + count
        return counts

    def told(self) -> Optional[Stamped]:
        """Give the earliest message that says what the mission is; None if none does."""
        told = [each.told for each in self.bags if each.told is not None]
        return min(told, key=lambda stamped: stamped.receipt_ns, default=None)

    def blocks(self, excerpt: Excerpt, heard: Optional[_Heard] = None) -> Iterator[Block]:
        """Read all bags, or a part of them, by time of receipt; equal times keep the order of the bags.

        Args:
            excerpt: which part.
            heard: takes in the blocks of each of several bags on their way; None if nobody does.
        """
        connections = ConnectionList()
        if len(self.bags) == 1:
            return self.bags[0].blocks(connections, excerpt)
        streams = [(bag, bag.blocks(connections, excerpt)) for bag in self.bags]
        return merged(blocks if heard is None else heard(bag, blocks) for bag, blocks in streams)

    def messages(self, excerpt: Excerpt) -> Iterator[Stamped]:
        """Read the same one by one."""
        for block in self.blocks(excerpt):
            yield from block

    def losses(self) -> List[str]:
        """Say what could not be read, a line each."""
        return [line for bag in self.bags for line in bag.losses()]

    def _opened(self, path: Path) -> Recording:
        try:
            info = read_bag_info(path)
            try:
                told = next(read_bag(path, topics=[MISSION_TOPIC]), None)
            except TransportError:
                # Of a damaged chunk, which the reading tells of when it comes there.
                told = _first_told(path)
            return Recording(info, True, BagFaults(), told)
        except UnindexedBagError as error:
            found: List[Stamped] = []
            info, faults = walk_info(path, _keeper(found))
            if not info.messages:
                raise TransportError(f"{path}: holds no messages that can be read: {error}") from error
            self.notes.append(f"{path}: has no index that can be read, so its records are walked over")
            return Recording(info, False, faults, found[0] if found else None)


def _first_told(path: Path) -> Optional[Stamped]:
    blocks = read_blocks(path, ConnectionList(), Excerpt([MISSION_TOPIC]), BagFaults())
    return next((stamped for block in blocks for stamped in block), None)


def _keeper(found: List[Stamped]) -> Callable[[Stamped], None]:
    def keep(stamped: Stamped) -> None:
        if not found and stamped.connection.topic == MISSION_TOPIC:
            found.append(stamped)

    return keep


def _check_names(paths: Sequence[Path]) -> None:
    seen: Dict[Path, Path] = {}
    for path in paths:
        other = seen.setdefault(path.resolve(), path)
        if other is not path:
            raise UsageError(f"{path}: is given twice; give each bag once")
        parts = [] if path.exists() else _numbered(path.parent, path.name[: -len(".bag")])
        if parts:
            names = " ".join(str(part) for part in parts)
            raise UsageError(f"{path}: no such file, but it was recorded in parts; give {names}")


def _parts_of(path: Path) -> Tuple[Path, ...]:
    """List the parts of a split recording that lie beside one of them; none if it is none."""
    found = _SPLIT.fullmatch(path.name)
    parts = () if found is None else _numbered(path.parent, found.group("name"))
    return parts if len(parts) > 1 else ()


def _numbered(folder: Path, name: str) -> Tuple[Path, ...]:
    pattern = re.compile(re.escape(name) + r"_(\d+)\.bag")
    found = [
        (int(match.group(1)), path)
        for path in folder.glob("*.bag")
        if (match := pattern.fullmatch(path.name)) is not None
    ]
    return tuple(path for _, path in sorted(found))
