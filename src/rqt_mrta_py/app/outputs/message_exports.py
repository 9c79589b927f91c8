"""Files that hold a mission's messages, as exporters of messages write them once everything is known."""

from __future__ import annotations

from heapq import merge
from itertools import islice
from operator import attrgetter
from typing import Callable, Collection, Dict, Iterable, Iterator, List, Mapping, Sequence

from rqt_mrta_py.app.guard import GuardedMessageExporter
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.hooks import Codec, Connection, Exporter, Outgoing, Stamped
from rqt_mrta_py.hooks.patience import Patience
from rqt_mrta_py.model import MissionRecord

__all__ = ["with_news", "write_message_exports"]

_TOGETHER = 1000
"""So many messages are handed over before patience begins anew."""

_NODE = "/supervisor"
_NS = 1_000_000_000


def write_message_exports(
    folder: OutputFolder,
    exporters: Mapping[str, Exporter],
    record: MissionRecord,
    messages: Callable[[], Iterable[Stamped]],
    patience: Patience,
) -> None:
    """Hand a finished stream to every exporter of messages, in one pass.

    Args:
        folder: of the outputs; files go to ``export/<name of the exporter>/``.
        exporters: by name; those of other kinds are passed over.
        record: everything known of the mission.
        messages: begins to read the stream, in its order; not called if nobody wants it.
        patience: how long exporters may take for some messages.

    Raises:
        HookError: an exporter raises; names it. No file of any of them is left.
        OutputError: a file cannot be written; likewise.
    """
    chosen = [exporter for exporter in exporters.values() if isinstance(exporter, GuardedMessageExporter)]
    if not chosen:
        return
    try:
        with patience.at_work("the beginning of exports"):
            for exporter in chosen:
                exporter.begin(record, folder)
        stream = iter(messages())
        while True:
            together = list(islice(stream, _TOGETHER))
            if not together:
                break
            with patience.at_work("the export of messages"):
                for exporter in chosen:
                    for stamped in together:
                        exporter.take(stamped)
        with patience.at_work("the end of exports"):
            for exporter in chosen:
                exporter.end()
        for exporter in chosen:
            exporter.keep()
    finally:
        for exporter in chosen:
            exporter.discard()


def with_news(
    messages: Iterable[Stamped], news: Sequence[Outgoing], codec: Codec, known: Collection[str]
) -> Iterator[Stamped]:
    """Put among recorded messages what a supervisor would have said.

    Args:
        messages: in the order of the stream.
        news: of the whole mission; each is placed at the time of which it speaks, behind what was recorded then.
        codec: writes them.
        known: topics that the stream has itself; of those it keeps its own messages and gets no others.

    Returns:
        The messages of both, by time.
    """
    connections: Dict[str, Connection] = {}
    said: List[Stamped] = []
    for each in news:
        if each.topic not in known:
            if each.topic not in connections:
                connections[each.topic] = codec.connection(each.topic, each.type, _NODE, each.latched)
            stamp_ns = max(round(float(each.fields["header"]["stamp"]) * _NS), 0)
            said.append(Stamped(connections[each.topic], stamp_ns, codec.encode(each.type, each.fields)))
    said.sort(key=attrgetter("receipt_ns"))
    return merge(messages, said, key=attrgetter("receipt_ns"))
