"""The node ``recorder``: records topics as they are into a bag that survives whatever happens to it."""

from __future__ import annotations

import logging
import time
from pathlib import Path
from typing import Optional, Sequence

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.live.interest import TopicChoice
from rqt_mrta_py.app.live.options import ParameterReader
from rqt_mrta_py.app.live.recording import Recording, free_bag
from rqt_mrta_py.app.live.stream_clock import StreamClock
from rqt_mrta_py.app.nodes.frame import Ending, node_main
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["main"]

_log = logging.getLogger("rqt_mrta_py.app")


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Run the node.

    Args:
        argv: arguments without the program's name; None for the process's own.

    Returns:
        The exit status.
    """
    return node_main("recorder", _work, argv)


def _work(node: RosNode, _host: Host, ending: Ending) -> None:
    reader = ParameterReader(node.parameter)
    path = reader.path("record") or Path.cwd()
    choice = TopicChoice.of(reader.texts("topics") or ("*",))
    duration = reader.number("duration", 0.0)
    for problem in reader.problems:
        _log.error("%s", problem)
    recording = Recording(free_bag(path, time.strftime("%Y-%m-%d-%H-%M-%S")))
    _log.info("recording=%s", recording.path)
    clock = StreamClock(node.now)
    node.on_time_jump(lambda _before, after: clock.jump(after))

    def wanted(topic: str, _type: str) -> bool:
        return choice.names(topic) and not choice.leaves_out(topic)

    def take(stamped: Stamped) -> None:
        if not ending.requested:
            recording.take((stamped,))

    node.hear(wanted, take, receipts=clock.receipt)
    try:
        ending.wait(duration or None)
    finally:
        with node.lock:
            ending.requested = True
        recording.close()
    if recording.failure:
        raise TransportError(recording.failure)
    _log.info("recording=%s messages=%d", recording.path, recording.messages)
