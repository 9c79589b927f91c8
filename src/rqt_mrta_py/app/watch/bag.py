"""Watch a recorded team: a complete bag to its end, one that still grows for as long as it does."""

from __future__ import annotations

import time
from contextlib import closing
from pathlib import Path
from typing import Iterable, List, Optional

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.mission_message import MISSION_TOPIC
from rqt_mrta_py.app.mission_source import named_mission, silent_about_itself, told_mission
from rqt_mrta_py.app.watch.team_watch import TeamWatch
from rqt_mrta_py.app.watch.view import Display, WatchRequest, WatchView
from rqt_mrta_py.errors import TransportError, UsageError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import BagTail, read_bag

__all__ = ["watch_bag"]

_LOOK = 0.1
"""How long to wait until the bag is looked at again [s]."""

_BEGUN = 13
"""A file that is shorter has no line yet that says what it is [bytes]."""


def watch_bag(host: Host, request: WatchRequest, bag: Path, display: Display, interrupt: Interrupt) -> List[str]:
    """Watch a bag.

    Args:
        host: registry and plugins.
        request: what the user asks for.
        bag: to follow; where it is not there yet, the ``.active`` file of its recording.
        display: shows it.
        interrupt: asks to end.

    Returns:
        What could not be read, a line each.

    Raises:
        MrtaError: of whatever is wrong.
    """
    follower = _Follower(host, request, bag, display, interrupt)
    path = follower.begun()
    if path is None:
        return []
    with closing(BagTail(path)) as tail:
        if tail.indexed and not request.follow:
            follower.take(read_bag(path))
            follower.end()
            return []
        while True:
            length = follower.messages
            follower.take(tail.read())
            if tail.complete or interrupt.requested or request.follow is False:
                break
            if not follower.patient(follower.messages > length):
                break
            time.sleep(_LOOK)
        follower.end()
        return [f"{path}: {fault}" for fault in tail.faults]


class _Follower:
    """Feeds a bag's messages to a watch, once it is known what the bag is about."""

    def __init__(self, host: Host, request: WatchRequest, bag: Path, display: Display, interrupt: Interrupt) -> None:
        self._host = host
        self._request = request
        self._bag = bag
        self._display = display
        self._interrupt = interrupt
        self._codec = host.codec()
        self._watch: Optional[TeamWatch] = None
        self._heard_at = self._shown_at = time.monotonic()
        mission = named_mission(host, request.application, request.architecture, bag.name.partition(".")[0])
        if mission is not None:
            self._begin(TeamWatch(mission, self._codec, host.manager))

    @property
    def messages(self) -> int:
        return self._watch.messages if self._watch is not None else 0

    def begun(self) -> Optional[Path]:
        """Find the file, waiting for it if it is to be followed; None if the user ends before it is there."""
        while not self._interrupt.requested:
            for path in (self._bag, self._bag.with_name(f"{self._bag.name}.active")):
                if path.exists() and (path.is_dir() or path.stat().st_size >= _BEGUN):
                    return path
            if not self._request.follow or not self.patient(False):
                if self._bag.exists():
                    return self._bag
                raise TransportError(f"{self._bag}: no such file; give the path of a bag, or --follow to wait for it")
            time.sleep(_LOOK)
        return None

    def patient(self, heard: bool) -> bool:
        """Tell whether to wait on."""
        now = time.monotonic()
        if heard:
            self._heard_at = now
        return self._request.timeout is None or now - self._heard_at < self._request.timeout

    def take(self, messages: Iterable[Stamped]) -> None:
        """Take in what is there."""
        waiting: List[Stamped] = []
        for stamped in messages:
            if self._watch is None:
                waiting.append(stamped)
                if stamped.connection.topic == MISSION_TOPIC:
                    mission, _ = told_mission(stamped, self._codec, str(self._bag))
                    self._begin(TeamWatch(mission, self._codec, self._host.manager))
                    self._feed(waiting)
            else:
                self._feed((stamped,))
            if self._interrupt.requested:
                return
        if self._watch is None and waiting:
            raise UsageError(silent_about_itself(str(self._bag)))
        self._show(self._watch)

    def end(self) -> None:
        """Show the end."""
        if self._watch is None:
            if not self._interrupt.requested:
                raise UsageError(silent_about_itself(str(self._bag)))
            return
        self._watch.finish()
        self._watch.tell(self._display)
        self._display.end(self._view(self._watch))

    def _begin(self, watch: TeamWatch) -> None:
        self._watch = watch
        self._display.begin(watch.mission, str(self._bag))

    def _feed(self, messages: Iterable[Stamped]) -> None:
        watch = self._watch
        if watch is None:
            return
        for stamped in messages:
            watch.feed(stamped)
        watch.tell(self._display)
        if watch.messages % 1000 == 0:
            self._show(watch)

    def _show(self, watch: Optional[TeamWatch]) -> None:
        """Show everything, if it is time for that."""
        period, now = self._display.period, time.monotonic()
        if watch is not None and period is not None and now - self._shown_at >= period:
            self._shown_at = now
            self._display.show(self._view(watch))

    def _view(self, watch: TeamWatch) -> WatchView:
        graph = watch.traffic.recorded().restricted(self._request.topics.keeps) if self._request.graph else None
        return watch.view(None, graph)
