"""The timekeeper: holds stamps of monitored topics against receipts, and notices who falls silent on one."""

from __future__ import annotations

import math
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import ClockOff, ClockRight, Fact, Heard, Subscription, TopicHeard, TopicSilent
from rqt_mrta_py.supervisor.clocks.leads import LeadWatch, Verdict, tolerance_of
from rqt_mrta_py.supervisor.clocks.pulses import Pulse
from rqt_mrta_py.supervisor.message_key import evidence
from rqt_mrta_py.supervisor.readers import TopicReader
from rqt_mrta_py.supervisor.team import Team
from rqt_mrta_py.supervisor.topics import Topics

__all__ = ["Timekeeper", "Voice"]

_STAMP = "header/stamp"

_TopicKey = Tuple[str, str]
"""Name and type of a monitored topic."""


class Voice(NamedTuple):
    """One robot on one monitored topic.

    Attributes:
        robot: its id.
        topic: as the architecture declares it.
        watch: judges its stamps.
        pulse: how it speaks, on a topic that says that it is idle.
        busy: how it speaks elsewhere, on a topic that says that it is busy; may grow.
        timeout: how long a message of it counts [s].
    """

    robot: str
    topic: str
    watch: LeadWatch
    pulse: Optional[Pulse]
    busy: Sequence[Pulse]
    timeout: float

    @property
    def is_steady(self) -> bool:
        """Whether nothing follows from its next messages but when they came, if they are stamped as they should be."""
        if not self.watch.calm or any(pulse.silent and not pulse.says_both for pulse in self.busy):
            return False
        return self.pulse is None or self.pulse.is_steady


class Timekeeper:
    """Hears what robots say on monitored topics, after the team has taken it in.

    Args:
        topics: of the architecture.
        team: knows the robots and the time.
        emit: takes each fact.

    Attributes:
        next_due: when somebody is missed if nothing comes until then [s]; infinity if nobody is.
        latest: whose message came last, of those that tell a robot; None if of no robot of the team.
    """

    def __init__(self, topics: Topics, team: Team, emit: Callable[[Fact], None]) -> None:
        self.next_due = math.inf
        self.latest: Optional[Voice] = None
        self._topics = topics
        self._team = team
        self._emit = emit
        self._voices: Dict[Tuple[str, _TopicKey], Voice] = {}
        self._pulses: Dict[str, List[Pulse]] = {}

    def listeners(self) -> List[Tuple[Subscription, Callable[[Heard], None]]]:
        """Say what to hear, and who hears it: each monitored topic whose messages tell a robot, once."""
        topics = self._topics
        readers: Dict[_TopicKey, TopicReader] = {}
        for group in (topics.busy, topics.idle, topics.allocated, topics.completed, topics.failed):
            for reader in group:
                if reader.tells_robot:
                    readers.setdefault(_key(reader), reader)
        return [(_wish(reader), self._hears(reader)) for reader in readers.values()]

    def look_again(self) -> None:
        """Look when somebody is truly missed: what was heard since has put it off."""
        self.next_due = min((pulse.due for pulses in self._pulses.values() for pulse in pulses), default=math.inf)

    def expire(self) -> None:
        """Let happen what falls due first."""
        due = self.next_due
        missed = [pulse for pulses in self._pulses.values() for pulse in pulses if pulse.due <= due]
        for pulse in missed:
            fact = TopicSilent(pulse.due, pulse.robot, pulse.topic, evidence(pulse.last), pulse.period)
            pulse.silent = True
            self._emit(fact)
        self.look_again()

    def finish(self) -> None:
        """Tell the latest of clocks that are off, when the stream has ended."""
        for voice in self._voices.values():
            if voice.watch.is_news:
                self._tell_off(voice)

    def _hears(self, reader: TopicReader) -> Callable[[Heard], None]:
        team, path, timeout = self._team, reader.robot_path, reader.timeout
        # By the text that names the robot, whatever that is in a stranger's message.
        voices: Dict[Any, Voice] = {}

        # Comes with each message of the team's robots: for all but a few it is a look at the stamp.
        def hear(heard: Heard) -> None:
            fields = heard.fields
            try:
                voice = voices[(fields[path] if path else "") or heard.robot]
            except (KeyError, TypeError):
                met = self._meet(reader, heard)
                if met is None:
                    self.latest = None
                    return
                voice = met
                if not path or isinstance(fields[path], str):
                    voices[(fields[path] if path else "") or heard.robot] = voice
            self.latest = voice
            stamp = fields.get(_STAMP)
            if stamp and isinstance(stamp, float):
                watch = voice.watch
                lead = stamp - heard.receipt
                if not watch.calm or not -watch.tolerance <= lead <= watch.tolerance:
                    self._judge(voice, lead, heard)
            if voice.pulse is not None and voice.pulse.hear(team.now, heard):
                self._note(voice.pulse, heard)
            for pulse in voice.busy:
                if pulse.hear_busy(team.now, team.now + timeout, heard):
                    self._note(pulse, heard)

        return hear

    def _meet(self, reader: TopicReader, heard: Heard) -> Optional[Voice]:
        """Find out whose message it is; None if of no robot of the team."""
        robot = reader.robot_of(heard)
        if robot not in self._team.robots:
            return None
        key = _key(reader)
        voice = self._voices.get((robot, key))
        if voice is None:
            is_busy = key in {_key(each) for each in self._topics.busy}
            is_idle = not is_busy and key in {_key(each) for each in self._topics.idle}
            pulses = self._pulses.setdefault(robot, [])
            pulse = Pulse(robot, reader.topic.name, reader.timeout) if is_idle else None
            if pulse is not None:
                pulses.append(pulse)
            watch = LeadWatch(tolerance_of(reader.timeout))
            voice = Voice(robot, reader.topic.name, watch, pulse, pulses if is_busy else (), reader.timeout)
            self._voices[robot, key] = voice
        return voice

    def _judge(self, voice: Voice, lead: float, heard: Heard) -> None:
        verdict = voice.watch.judge(self._team.now, lead, heard)
        if verdict is Verdict.OFF:
            self._tell_off(voice)
        elif verdict is Verdict.RIGHT:
            message = evidence(voice.watch.right)
            self._emit(ClockRight(message.stamp, voice.robot, voice.topic, message))

    def _tell_off(self, voice: Voice) -> None:
        watch = voice.watch
        messages = evidence(watch.first), evidence(watch.newest)
        self._emit(ClockOff(self._team.now, voice.robot, voice.topic, watch.tell(), watch.tolerance, *messages))

    def _note(self, pulse: Pulse, heard: Heard) -> None:
        """Take note that a topic is heard regularly, or again."""
        if pulse.silent:
            pulse.silent = False
            self._emit(TopicHeard(self._team.now, pulse.robot, pulse.topic, evidence(heard)))
        self.next_due = min(self.next_due, pulse.due)


def _key(reader: TopicReader) -> _TopicKey:
    return reader.topic.name, reader.topic.type


def _wish(reader: TopicReader) -> Subscription:
    """Ask for what others ask for already, so that it is read once, and for the stamp if there is one."""
    wish = reader.subscription()
    return wish._replace(fields=tuple(path for path in wish.fields if path != _STAMP), optional=(_STAMP,))
