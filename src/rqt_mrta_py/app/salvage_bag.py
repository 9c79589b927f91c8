"""Salvage a damaged bag: what can be read of it goes into a whole one."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.errors import TransportError, UsageError
from rqt_mrta_py.transport import BagFault, BagWriter, ChunkWalk, Compression

__all__ = ["SalvageReport", "SalvageRequest", "SalvagedTopic", "salvage_bag"]

_NS = 1e9
_MB = 1e6


@dataclass(frozen=True)
class SalvageRequest:
    """What the user asks for.

    Attributes:
        bag: to read, a bag or an ``.active`` file.
        out: the bag to write; None for ``<name>-salvaged.bag`` beside the damaged one.
        force: replace a bag that is there.
    """

    bag: Path
    out: Optional[Path] = None
    force: bool = False


@dataclass(frozen=True)
class SalvagedTopic:
    """What was saved of a topic, and what was not.

    Attributes:
        topic: its name.
        type: ``pkg/Msg``, of its first message.
        messages: number of those saved.
        bytes: sum of their lengths.
        lost: number of messages that the bag's indexes tell of and that were not saved; None if they tell nothing of
            the topic. Where the bag's own index is damaged there may have been more.
    """

    topic: str
    type: str
    messages: int
    bytes: int
    lost: Optional[int]


@dataclass(frozen=True)
class SalvageReport:
    """What was saved, and what was not.

    Attributes:
        bag: that was read.
        out: that was written; None if the user interrupted, for then nothing stays.
        messages: number of those saved.
        bytes: sum of their lengths.
        start: receipt of the earliest message saved [s].
        end: receipt of the latest [s].
        topics: by name.
        faults: the places that could not be read, as found; of very many the first.
        untold: number of further such places.
        lost: what was passed over: bytes of the file, or of the contents of compressed chunks.
        missing: what the file is known to lack [bytes].
        counted: whether the bag's own index stands, so that the messages lost are all counted.
    """

    bag: Path
    out: Optional[Path]
    messages: int
    bytes: int
    start: float
    end: float
    topics: Tuple[SalvagedTopic, ...]
    faults: Tuple[BagFault, ...]
    untold: int
    lost: int
    missing: int
    counted: bool

    def as_json(self) -> Dict[str, Any]:
        """Give the report as plain values, keys in a fixed order."""
        return {
            "bag": str(self.bag),
            "file": None if self.out is None else str(self.out),
            "messages": self.messages,
            "bytes": self.bytes,
            "time": {"start": self.start, "end": self.end},
            "topics": [dataclasses.asdict(topic) for topic in self.topics],
            "lost": self.lost,
            "missing": self.missing,
            "counted": self.counted,
            "faults": [
                {"byte": fault.position, "text": fault.reason, "lost": fault.lost, "missing": fault.missing}
                for fault in self.faults
            ],
            "untold_faults": self.untold,
        }


def salvage_bag(request: SalvageRequest, progress: Callable[[float, float], None]) -> SalvageReport:
    """Read what can be read of a bag, and write it as a whole one.

    Connections keep all that is known of them; chunks are compressed as the first one of the damaged bag, else by LZ4.
    The damaged bag is left as it is. Whatever ends the work early, an interrupt too, leaves no file behind and the bag
    to be replaced as it was: half of what could be saved must not pass for all of it, and the work can be repeated.

    Args:
        request: what the user asks for.
        progress: told how much of the file has been read, and its size [MB].

    Returns:
        What was saved.

    Raises:
        UsageError: the new bag may not be written where it is wished.
        TransportError: the file is no bag, nothing can be saved, or the new bag cannot be written.
        MissingDependencyError: the library for a compression is not installed.
    """
    walk = ChunkWalk(request.bag)
    out = _target(request)
    counts: Dict[str, List[int]] = {}
    types: Dict[str, str] = {}
    start_ns = end_ns = 0
    writer: Optional[BagWriter] = None
    whole = False
    with Interrupt() as interrupt:
        try:
            for stamped in walk:
                if interrupt.requested:
                    break
                if writer is None:
                    writer = BagWriter(out, walk.compression or Compression.LZ4, replace=request.force)
                    start_ns = end_ns = stamped.receipt_ns
                writer.write(stamped)
                topic = stamped.connection.topic
                count = counts.setdefault(topic, [0, 0])
                count[0] += 1
                count[1] += len(stamped.raw)
                types.setdefault(topic, stamped.connection.type)
                start_ns, end_ns = min(start_ns, stamped.receipt_ns), max(end_ns, stamped.receipt_ns)
                progress(walk.position / _MB, walk.size / _MB)
            if writer is not None and not interrupt.requested:
                _complete(writer)
                whole = True
        finally:
            if writer is not None:
                writer.discard()
    if writer is None and not interrupt.requested:
        reason = walk.faults[0] if walk.faults else "it holds no messages"
        raise TransportError(f"{request.bag}: nothing can be saved: {reason}")
    faults = walk.all_faults
    return SalvageReport(
        bag=request.bag,
        out=out if whole else None,
        messages=sum(messages for messages, _ in counts.values()),
        bytes=sum(size for _, size in counts.values()),
        start=start_ns / _NS,
        end=end_ns / _NS,
        topics=_topics(counts, types, walk.promised()),
        faults=tuple(faults.told),
        untold=faults.untold,
        lost=faults.lost,
        missing=faults.missing,
        counted=walk.index_is_whole,
    )


def _topics(
    counts: Mapping[str, Sequence[int]], types: Mapping[str, str], promised: Mapping[str, Tuple[str, int]]
) -> Tuple[SalvagedTopic, ...]:
    """Hold what was read against what the indexes tell of, topic by topic."""
    found = []
    for topic in sorted({*counts, *promised}):
        messages, size = counts.get(topic, (0, 0))
        type_name, told = promised.get(topic, ("", None))
        lost = None if told is None else max(0, told - messages)
        found.append(SalvagedTopic(topic, types.get(topic, type_name), messages, size, lost))
    return tuple(found)


def _complete(writer: BagWriter) -> None:
    try:
        writer.close()
    except TransportError as error:
        # The writer speaks of a recording, which is worth to be kept and salvaged; this bag is worth neither.
        reason: BaseException = error
        while reason.__cause__ is not None:
            reason = reason.__cause__
        raise TransportError(f"{writer.path}: cannot be completed: {reason}; give another --out") from error


def _target(request: SalvageRequest) -> Path:
    """Choose the new bag's path, so that neither the damaged one nor any other recording is written over."""
    out = request.out
    if out is None:
        name = request.bag.name
        for ending in (".active", ".bag"):
            name = name[: -len(ending)] if name.endswith(ending) else name
        out = request.bag.with_name(f"{name}-salvaged.bag")
    active = out.with_name(out.name + ".active")
    if out.is_dir():
        raise UsageError(f"--out {out}: is a folder; give a file")
    if out.exists() and out.samefile(request.bag):
        raise UsageError(f"--out {out}: is the bag to be salvaged; give another file")
    if active.exists():
        reason = "is the bag to be salvaged" if active.samefile(request.bag) else "exists and may hold a recording"
        raise UsageError(f"--out {out}: would be written as {active} until it is whole, which {reason}; give another")
    if out.exists() and not request.force:
        raise UsageError(f"--out {out}: exists already; give another file, or --force to replace it")
    return out
