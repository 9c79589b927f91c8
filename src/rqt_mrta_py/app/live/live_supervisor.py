"""A supervisor on a ROS 1 graph: hears the stream, says what is new at once, records, draws.

Everything behind the stream is that of runs and reviews. Messages are taken in under the node's lock, in rospy's
threads; time passes without messages by a thread that looks at the clock; what takes long is done elsewhere.
"""

from __future__ import annotations

import logging
import threading
import time
from dataclasses import replace
from pathlib import Path
from typing import Any, List, Mapping, Optional, Set, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.live.drawing import Drawing
from rqt_mrta_py.app.live.health import Counts
from rqt_mrta_py.app.live.health_report import HealthReport
from rqt_mrta_py.app.live.intake import Intake
from rqt_mrta_py.app.live.interest import Interest
from rqt_mrta_py.app.live.live_pictures import LivePictures
from rqt_mrta_py.app.live.open_incidents import OpenIncidents
from rqt_mrta_py.app.live.options import LiveOptions
from rqt_mrta_py.app.live.recording import Recording, free_bag, free_folder
from rqt_mrta_py.app.live.ring_buffer import RingBuffer
from rqt_mrta_py.app.live.snapshots import Snapshots
from rqt_mrta_py.app.live.stream_clock import StreamClock
from rqt_mrta_py.app.live.tally import with_messages_kept, with_pictures
from rqt_mrta_py.app.live.voice import Voice
from rqt_mrta_py.app.live.ways import foreseen_topics, overhear
from rqt_mrta_py.app.mission_message import mission_message
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.report import ReportSource, bag_file, write_report
from rqt_mrta_py.app.outputs.results import MissionResult, Stopwatch, write_results
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import MonitorView, Outgoing, Stamped
from rqt_mrta_py.model import Mission, MissionRecord
from rqt_mrta_py.render import MARKERS_TOPIC, team_markers
from rqt_mrta_py.render.report import BagFile
from rqt_mrta_py.supervisor import team_news
from rqt_mrta_py.supervisor.own_topics import INCIDENT
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["LiveSupervisor"]

_log = logging.getLogger("rqt_mrta_py.app")

_NS = 1_000_000_000
_TICK = 0.05
"""How often what falls due without a message is looked for, on the wall [s]."""
_CATCH_UP = 4
"""With each so manieth look what waits is taken in, though nothing is due."""
_STATE_PERIOD = 1.0
"""How often team, markers and health are told, on the wall [s]."""


class LiveSupervisor:
    """Supervises one mission on a ROS 1 graph.

    Attributes:
        node: that hears and speaks.
        lock: of the node.
        observation: of the mission; None until ``begin``.
        failure: what went wrong in the thread that looks at the clock; None if nothing did.

    Args:
        node: see above.
        host: plugins, renderers.
        options: how to supervise; who is supervised is told to ``begin``.
        wrong_parameters: how many of the node's parameters were not used.
    """

    def __init__(self, node: RosNode, host: Host, options: LiveOptions, wrong_parameters: int = 0) -> None:
        self.node = node
        self.lock = node.lock
        self.observation: Optional[Observation] = None
        self.failure: Optional[Exception] = None
        self._host = host
        self._options = options
        self._clock = StreamClock(node.now)
        self._interest: Optional[Interest] = None
        self._intake: Optional[Intake] = None
        self._ring: Optional[RingBuffer] = None
        if options.snapshot_seconds > 0 and options.snapshot_bytes > 0:
            self._ring = RingBuffer(options.snapshot_seconds, options.snapshot_bytes)
        self._snapshots = Snapshots(options.snapshots)
        self._recording: Optional[Recording] = None
        self._drawing = Drawing()
        self._pictures = LivePictures(self._drawing, options.pictures, node.lock, self._say)
        self._folder: Optional[OutputFolder] = None
        self._stopwatch = Stopwatch()
        self._voice = Voice(node)
        self._open_incidents = OpenIncidents()
        self._robots: Set[str] = set()
        self._topics: Set[str] = set()
        self._health = HealthReport(node, wrong_parameters)
        self._ticks = 0
        self._closed = False
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="supervising", daemon=True)

    @property
    def mission(self) -> Mission:
        """What is supervised.

        Raises:
            UsageError: nobody has said it yet.
        """
        return self._present.mission

    def record(self) -> MissionRecord:
        """Give everything known of the mission so far; under the node's lock.

        Raises:
            UsageError: nobody has said yet what the mission is.
        """
        return self._present.supervisor.record(self.now)

    @property
    def _present(self) -> Observation:
        if self.observation is None:
            raise UsageError("nobody has said yet what the mission is; it is waited for on /mrta/mission")
        return self.observation

    @property
    def now(self) -> float:
        """The present time of the stream [s], with all taken in that came before; under the node's lock."""
        self._catch_up()
        return self._clock.receipt() / _NS

    @property
    def heard(self) -> int:
        """How many messages were taken in."""
        return 0 if self._intake is None else self._intake.heard

    @property
    def recorded_path(self) -> Optional[Path]:
        """The bag that is written; None if none is."""
        return None if self._recording is None else self._recording.path

    @property
    def drawing(self) -> Drawing:
        """Draws pictures."""
        return self._drawing

    @property
    def incidents(self) -> List[Mapping[str, Any]]:
        """The incidents that last, as fields of their messages, by start; under the node's lock."""
        return self._open_incidents.listed()

    def open(self) -> None:
        """Tell the graph what will be published, and let time pass."""
        self._voice.open()
        self.node.on_time_jump(self.jumped)
        self._health.open()
        self.node.on_shutdown(self._end_stream)
        self._thread.start()

    def begin(
        self, mission: Mission, duration: Optional[float], *, announce: bool = False, first: Optional[Stamped] = None
    ) -> None:
        """Supervise a mission from now on; to be called once, without the node's lock.

        Args:
            mission: as far as it is known.
            duration: planned [s]; None if unknown.
            announce: whether to tell everybody what the mission is, for nobody else does.
            first: the message that told it, unless it will be heard again.

        Raises:
            MrtaError: bag or folder cannot be made, or a plugin fails.
        """
        options = self._options
        observation = Observation(
            mission,
            self.node.codec,
            self._host.manager,
            duration,
            panels=options.pictures > 0,
            measures=options.out is not None,
        )
        name = mission.application.package or mission.architecture.package
        if options.out is not None:
            self._folder = OutputFolder.create(free_folder(options.out), name, force=False)
        if options.record is not None:
            self._recording = Recording(free_bag(options.record, name))
            _log.info("recording=%s", self._recording.path)
        if options.pictures > 0:
            self._drawing.start()
        with self.node.lock:
            self.observation = observation
            self._interest = Interest(observation.wishes, options.topics)
            self._robots = set(observation.supervisor.robots)
            ring = () if self._ring is None else (self._ring.extend,)
            recording = () if self._recording is None else (self._recording.take,)
            self._intake = Intake(self.node.name, self._clock, observation, (*ring, *recording), self._tell_news)
            if announce:
                self._say(mission_message(mission, self.now, duration))
            if first is not None:
                self._intake.take(first._replace(receipt_ns=self._clock.receipt()))
        for topic in foreseen_topics(mission, observation.wishes):
            if self._interest.wants(topic, "", self._robots):
                self.node.hear_topic(topic, overhear)
        self.node.hear(self._wanted, self._intake.hear)

    def say(self, outgoing: Outgoing) -> None:
        """Publish a message and take it in like one that was heard; under the node's lock."""
        self._say(outgoing)
        self._tell_news()

    def last_messages(self, seconds: float) -> List[Stamped]:
        """Give what was heard in the last seconds; under the node's lock.

        Args:
            seconds: how far back; 0: all that is kept [s].

        Raises:
            UsageError: nothing is kept.
        """
        self._catch_up()
        if self._ring is None:
            raise UsageError("nothing is kept for snapshots; set ~snapshot_seconds above 0")
        return self._ring.last(seconds or None)

    def view(self) -> MonitorView:
        """Give what a picture of this moment shows; under the node's lock.

        Raises:
            UsageError: nobody has said yet what the mission is.
        """
        return self._present.view(self.now)

    def finish(self) -> Optional[MissionResult]:
        """End the stream, complete the bag, write the outputs; to be called once, without the node's lock.

        Returns:
            What is known of the mission; None if no outputs were asked for, or nothing began.
        """
        self._end_stream()
        if self._thread.is_alive():
            self._thread.join()
        self._drawing.close()
        self._snapshots.close()
        bags: Tuple[BagFile, ...] = ()
        if self._recording is not None and self._recording.close() is not None:
            _log.info("recording=%s messages=%d", self._recording.path, self._recording.messages)
            bags = (bag_file(self._recording.path, self._recording.messages),)
        if self._folder is None or self.observation is None:
            return None
        dashboard = self._host.renderer("dashboard") if self._options.pictures > 0 else None
        results = write_results(self._folder, self.observation, dashboard)
        write_report(self._folder, self.observation, results.record, ReportSource("live supervision", bags))
        return self._stopwatch.result(self._folder, results, Interrupt())

    def _wanted(self, topic: str, type_name: str) -> bool:
        wanted = self._interest is not None and self._interest.wants(topic, type_name, self._robots)
        (self._topics.add if wanted else self._topics.discard)(topic)
        return wanted

    def _catch_up(self) -> None:
        if self._intake is not None:
            self._intake.catch_up()

    def _tell_news(self) -> None:
        """Say what is new. What becomes new by that is said the next time, so that this ends."""
        observation = self.observation
        if observation is None:
            return
        observation.supervisor.settle()
        if not observation.supervisor.has_news:
            return
        for message in observation.news():
            self._say(message)
        error = self._open_incidents.take_error()
        if error and self._ring is not None and self._snapshots.due(self.now):
            self._snapshots.write(self._ring.last(), f"{error}-{self.now:.3f}")

    def _say(self, outgoing: Outgoing) -> None:
        """Publish, and take in what was published as it stands in a bag."""
        if self._intake is None or self._closed:
            return
        self._intake.catch_up()
        stamped = self._voice.say(outgoing, self._clock.receipt())
        if stamped is None:
            return
        if outgoing.topic == INCIDENT.name:
            self._open_incidents.note(outgoing.fields)
        self._intake.take(stamped)

    def _run(self) -> None:
        due = time.monotonic()
        fresh = False
        while not self._ended.is_set():
            # Not by waiting for the end, which takes several times as long.
            time.sleep(_TICK)
            try:
                began = time.monotonic()
                with self.node.lock:
                    if self._closed:
                        return
                    now = time.monotonic()
                    self._health.waited(now - began)
                    self.look_at_clock()
                    if now >= due:
                        fresh = self._tell_again(now)
                        due = max(due + _STATE_PERIOD, now)
                if fresh:
                    fresh = False
                    self.node.ask_again()
            except Exception as error:  # noqa: BLE001 - as in a callback: it ends the node, and is told by it
                self.failure = error
                self.node.shut_down(f"supervision failed: {error}")
                return

    def look_at_clock(self) -> None:
        """Let happen what fell due without a message; under the node's lock."""
        self._ticks += 1
        observation = self.observation
        if observation is None:
            return
        now_ns = self._clock.look()
        picture_is_due = self._pictures.due(now_ns)
        if observation.supervisor.next_due < now_ns / _NS or picture_is_due or self._ticks % _CATCH_UP == 0:
            now = self.now
            if now:
                observation.supervisor.let_pass(now)
                self._tell_news()
                if picture_is_due:
                    self._pictures.draw(now_ns, observation.view)

    def _tell_again(self, wall: float) -> bool:
        """Say what is said again and again; tell whether there are robots that were not known before."""
        self._catch_up()
        receipt, observation = self._clock.receipt(), self.observation
        if observation is not None and receipt:
            self._tell_team(observation, receipt / _NS)
        self._health.tell(self._counts(), wall, receipt / _NS)
        robots = set() if observation is None else set(observation.supervisor.robots)
        fresh = robots != self._robots
        self._robots = robots
        return fresh

    def _tell_team(self, observation: Observation, now: float) -> None:
        if self._recording is None and not self._voice.is_heard(MARKERS_TOPIC):
            self._say(team_news(observation.supervisor.record(now), now))
            return
        view = observation.view_without_panels(now)
        self._say(observation.team_state(view))
        self._say(team_markers(view, now))

    def _counts(self) -> Counts:
        observation = self.observation
        counts = Counts(heard=self.heard, topics=len(self._topics), jumps=self._clock.jumps)
        if observation is not None:
            mission, unreadable = _named(observation.mission), observation.supervisor.unreadable
            counts = replace(counts, mission=mission, unreadable=unreadable)
            if self._options.pictures > 0:
                counts = with_pictures(counts, self._drawing, self._pictures)
        return with_messages_kept(counts, self._recording, self._ring)

    def _end_stream(self) -> None:
        """Say how things stand at the end, and take in nothing more."""
        self._ended.set()
        with self.node.lock:
            if self._closed:
                return
            self._catch_up()
            observation, receipt = self.observation, self._clock.receipt()
            if observation is not None and receipt and self.failure is None:
                observation.supervisor.let_pass(receipt / _NS)
                self._tell_news()
                # The last message: what has passed until now has passed in the bag too.
                self._say(observation.team_state(observation.view_without_panels(receipt / _NS)))
            self._closed = True
            if self._intake is not None:
                self._intake.close()

    def jumped(self, before: float, after: float) -> None:
        """Take note that ROS time went back, from a time to another [s]; under the node's lock."""
        self._catch_up()
        self._clock.jump(after)
        _log.warning(
            "time went back from %.3f s to %.3f s; receipts go on from %.3f s",
            before,
            after,
            self._clock.newest / _NS,
        )


def _named(mission: Mission) -> str:
    return mission.application.package or mission.architecture.package
