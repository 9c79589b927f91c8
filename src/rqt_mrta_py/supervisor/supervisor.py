"""The supervisor: hears the stream, drives team, rules and journal, and says what it knows."""

from __future__ import annotations

import dataclasses
from functools import partial
from typing import Callable, List, Mapping, Optional, Sequence, Set, Tuple

from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import (
    AllocationEnded,
    AllocationInterpreter,
    AllocationPace,
    AllocationStarted,
    Connection,
    Fact,
    Heard,
    IncidentRule,
    IncidentRuleFactory,
    Outgoing,
    RobotStateChanged,
    RuleSetup,
    Sighting,
    Stamped,
    Statistic,
    Subscription,
    TaskStateChanged,
)
from rqt_mrta_py.hooks.answers import json_breach
from rqt_mrta_py.model import Event, Incident, Mission, MissionRecord
from rqt_mrta_py.supervisor.clocks import Timekeeper
from rqt_mrta_py.supervisor.desk import Desk
from rqt_mrta_py.supervisor.ears import Callback, Ears
from rqt_mrta_py.supervisor.failures import checked, failure
from rqt_mrta_py.supervisor.journal import event_of_fact, event_of_incident, event_of_unreadable
from rqt_mrta_py.supervisor.message_key import MessageKey, key_of
from rqt_mrta_py.supervisor.news import event_news, fact_news, incident_news
from rqt_mrta_py.supervisor.repeats import Repeats
from rqt_mrta_py.supervisor.standing import Standing, assume
from rqt_mrta_py.supervisor.team import Team, TeamSetup
from rqt_mrta_py.supervisor.topics import Topics, usual_pace

__all__ = ["Supervisor"]

_NEWS = (RobotStateChanged, TaskStateChanged, AllocationStarted, AllocationEnded)


class Supervisor:
    """Watches one mission through its stream, live or from a bag; has no clock and does no input or output.

    Time is the newest time of receipt; a message received earlier than one before it counts as received with that
    one. What falls due before a message happens before it and is dated when it fell due; a message received exactly
    then comes first.

    Attributes:
        repeats: tells which messages need not be heard one by one.

    Args:
        mission: as far as it is known; where it lists no robots or no tasks, they are admitted by first sight.
        interpreter: reads the architecture's own signs; None if it has none.
        rules: factories of incident rules by name.
        statistics: functions of the finished record by name.
        on_event: takes each event when it is noticed.
        pace: how fast the architecture shares out tasks when all is well, for rules; None: as its topics tell.

    Raises:
        HookError: a rule cannot be made; names it.
    """

    def __init__(
        self,
        mission: Mission,
        interpreter: Optional[AllocationInterpreter],
        rules: Mapping[str, IncidentRuleFactory],
        statistics: Mapping[str, Statistic],
        on_event: Callable[[Event], None],
        *,
        pace: Optional[AllocationPace] = None,
    ) -> None:
        self._mission = mission
        self._interpreter = interpreter
        self._statistics = statistics
        self._on_event = on_event
        topics = self._topics = Topics(mission.architecture)
        setup = RuleSetup(mission, usual_pace(mission.architecture) if pace is None else pace)
        self._rules = {name: _made(name, factory, setup) for name, factory in sorted(rules.items())}
        self._desk = Desk(self._rules, self._on_opened, self._on_closed)
        robots = tuple(robot.id for robot in mission.application.robots)
        self._team = Team(TeamSetup(robots, mission.tasks, topics.silence, mission.later_tasks), self._on_fact)
        self._ears = Ears(topics, self._team, self._enter, self.report)
        self._timekeeper = Timekeeper(topics, self._team, self._on_timing)
        self.repeats = Repeats(
            topics, self._team, self._ears, self._timekeeper, next_due=lambda: self.next_due, enter=self._enter
        )
        self._start: Optional[float] = None
        self._message: MessageKey = ("", 0.0, -1)
        self._time_of_fact = 0.0
        self._events: List[Event] = []
        # Built only if somebody asks: a review publishes nothing.
        self._news: List[Callable[[], Tuple[Outgoing, ...]]] = []
        self._changes = 0
        self._assuming = False
        self._unreadable: Set[Tuple[str, str]] = set()
        self._finished: Optional[MissionRecord] = None

    def sighting(self, connections: Sequence[Connection]) -> Sighting:
        """Give whom to tell first of all messages of connections, before anybody hears them."""
        return self._ears.sighting(connections)

    def listeners(self) -> Sequence[Tuple[Subscription, Callback]]:
        """Say what to hear, and who hears it; to be subscribed once, in this order.

        Raises:
            HookError: the interpreter or a rule raises; names it. So do the callbacks.
        """
        ears, timing = self._ears.listeners(), self._timekeeper.listeners()
        interpreter = self._ears.listeners_for(self._interpreter, self._mission.architecture.package)
        self.repeats.sort(ears, interpreter, timing, self._ears.last_matters)
        pairs = [*ears, *interpreter, *timing]
        for name, rule in self._rules.items():
            pairs += [(wish, self._hears_rule(name)) for wish in _wishes(name, rule)]
        return pairs

    def report(self, heard: Heard, reason: str) -> None:
        """Note, once for each topic and type, that messages cannot be read.

        Args:
            heard: what is known of the message.
            reason: why it cannot be read.
        """
        self._enter(key_of(heard))
        if (heard.topic, heard.type) not in self._unreadable:
            self._unreadable.add((heard.topic, heard.type))
            self._note(event_of_unreadable(heard, reason, self._team.now), self._team.now)

    def record(self, now: Optional[float] = None) -> MissionRecord:
        """Give everything known of the mission so far; changes nothing.

        Args:
            now: the moment to show [s]; not before the newest message, whose time it is by default. States and
                allocations that fall due before it are shown as expired, in the events too; rules look again only
                when the stream itself gets there.
        """
        if self._finished is not None:
            return self._finished
        if self._start is None:
            return self._describe(self._team, None, ())
        end = self._team.now if now is None else max(now, self._team.now)
        team, events = self._team, self._events
        if team.book.unsettled or team.agenda.next < end:
            events = list(events)
            team = team.fork(_collector(events))
            team.settle()
            while team.agenda.next < end:
                team.expire()
        return self._describe(team, end, events)

    @property
    def changes(self) -> int:
        """How often anything has changed that is derived here."""
        return self._changes

    @property
    def has_news(self) -> bool:
        """Whether there is something to say since ``news`` was last asked."""
        return bool(self._news)

    @property
    def unreadable(self) -> int:
        """How many topics, each with a type, brought what could not be read."""
        return len(self._unreadable)

    @property
    def robots(self) -> Sequence[str]:
        """Ids of the robots that are watched, in order; more may be admitted by first sight."""
        return tuple(self._team.robots) or tuple(robot.id for robot in self._mission.application.robots)

    def is_quiet_until(self, until: float) -> bool:
        """Tell whether up to a time [s] nothing follows from hearing robots but that they were heard."""
        if self._start is None or self.next_due < until:
            return False
        book = self._team.book
        return not (book.unsettled or book.expired or any(robot.silent for robot in self._team.robots.values()))

    def sight_together(self, messages: Sequence[Stamped], ordinals: Sequence[int]) -> None:
        """Take in that messages came, as sightings do one by one; only while it is quiet until the last of them.

        Args:
            messages: in order, their connections as told to ``sighting``.
            ordinals: of each.
        """
        self._ears.sight_together(messages, ordinals)
        connection, receipt_ns, _ = messages[-1]
        receipt = receipt_ns / 1_000_000_000
        self._message = (connection.topic, receipt, ordinals[-1])
        if receipt > self._team.now:
            self._team.now = self._time_of_fact = receipt

    @property
    def next_due(self) -> float:
        """When something happens without a message [s]; infinity if nothing will, before the stream has begun too."""
        return min(self._team.agenda.next, self._timekeeper.next_due, self._desk.next_wake)

    def settle(self) -> None:
        """Draw now, rather than with the next message, what conclusions everybody's hearing of a message allows."""
        if self._team.book.unsettled and self._finished is None:
            self._team.settle()

    def let_pass(self, until: float) -> None:
        """Let time pass though no message came: what falls due before a time happens.

        A stream that goes on at that time or later gives the same events whether this is called or not; those that
        nothing follows are told only because it is.

        Args:
            until: no message will be received before it [s].
        """
        if self._start is None or self._finished is not None:
            return
        self.settle()
        if until > self._team.now:
            self._pass(until)

    def assume(self, told: Standing, heard: Heard) -> Standing:
        """Take over from another supervisor what is not known here; rules are told of it, but nothing happens by it.

        Args:
            told: how the team stands.
            heard: the message that says so.

        Returns:
            What was taken over.
        """
        self._enter(key_of(heard))
        self._assuming = True
        try:
            return assume(self._team, told, heard, self._topics.silence, self._topics.hold)
        finally:
            self._assuming = False

    def finish(self) -> MissionRecord:
        """End the stream and sum the mission up; whatever lasts ends with the newest message.

        Returns:
            The record with statistics; the same again when asked again.

        Raises:
            HookError: a rule or a statistic raises, or a statistic is no plain JSON; names it.
        """
        if self._finished is None:
            if self._start is not None:
                self._team.settle()
                self._timekeeper.finish()
                self._desk.finish(self._team.now)
            record = self.record()
            statistics = {name: _computed(name, self._statistics[name], record) for name in sorted(self._statistics)}
            self._finished = dataclasses.replace(record, statistics=statistics)
        return self._finished

    def news(self) -> Sequence[Outgoing]:
        """Give what changed since this was last asked, as messages to publish, in the order in which it was noticed."""
        unbuilt, self._news = self._news, []
        return [message for build in unbuilt for message in build()]

    def _enter(self, message: MessageKey) -> None:
        """Come to a message: once for each, whoever hears it first."""
        if message == self._message:
            return
        self._message = message
        team, receipt = self._team, message[1]
        if self._start is None:
            self._start = self._time_of_fact = receipt
            team.begin(receipt)
            self._desk.begin(receipt)
        if team.book.unsettled:
            team.settle()
        if receipt > team.now:
            self._pass(receipt)

    def _pass(self, until: float) -> None:
        agenda, timekeeper, desk, team = self._team.agenda, self._timekeeper, self._desk, self._team
        while True:
            due = min(agenda.next, timekeeper.next_due, desk.next_wake)
            if due >= until:
                break
            self._time_of_fact = due
            if agenda.next == due:
                team.expire()
            elif timekeeper.next_due == due:
                timekeeper.expire()
            else:
                desk.wake_next()
        team.now = self._time_of_fact = until

    def _hears_rule(self, name: str) -> Callback:
        def hear(heard: Heard) -> None:
            self._enter(key_of(heard))
            self._desk.hear(name, heard)

        return hear

    def _on_fact(self, fact: Fact, why: str) -> None:
        self._changes += 1
        self.repeats.note(fact)
        if self._assuming:
            self._desk.notice(fact)
            return
        if not isinstance(fact, _NEWS):
            self._desk.notice(fact)
            return
        robot = self._team.robots.get(getattr(fact, "robot", ""))
        last_heard = robot.last_heard if isinstance(fact, RobotStateChanged) and robot is not None else None
        holders = self._team.book.holders(fact.task) if isinstance(fact, TaskStateChanged) else ()
        self._news.append(partial(fact_news, fact, last_heard, holders))
        event = event_of_fact(fact, why)
        if event is not None:
            self._note(event, getattr(fact, "started", fact.time))
        self._desk.notice(fact)

    def _on_timing(self, fact: Fact) -> None:
        self._changes += 1
        self.repeats.note(fact)
        self._desk.notice(fact)

    def _on_opened(self, incident: Incident) -> None:
        self._note(event_of_incident(incident, self._time_of_fact), self._time_of_fact)
        self._news.append(partial(incident_news, incident, self._time_of_fact, ended=False))

    def _on_closed(self, incident: Incident) -> None:
        self._news.append(partial(incident_news, incident, self._time_of_fact, ended=True))

    def _note(self, event: Event, started: float) -> None:
        self._events.append(event)
        self._news.append(partial(event_news, event, started))
        self._on_event(event)

    def _describe(self, team: Team, end: Optional[float], events: Sequence[Event]) -> MissionRecord:
        known = end is not None
        until = 0.0 if end is None else end
        return MissionRecord(
            application=self._mission.application.package or None,
            architecture=self._mission.architecture.package or None,
            taxonomy=self._mission.architecture.taxonomy,
            seed=self._mission.seed,
            start=self._start,
            end=end,
            robots=team.robot_records(until) if known else (),
            tasks=team.task_records(until) if known else (),
            allocations=team.allocation_records(until),
            incidents=self._desk.incidents(until),
            events=tuple(events),
        )


def _collector(events: List[Event]) -> Callable[[Fact, str], None]:
    def collect(fact: Fact, why: str) -> None:
        event = event_of_fact(fact, why)
        if event is not None:
            events.append(event)

    return collect


def _made(name: str, factory: IncidentRuleFactory, setup: RuleSetup) -> IncidentRule:
    try:
        return factory(setup)
    except Exception as error:
        raise failure(f"incident rule {name}", error, "being made") from error


def _wishes(name: str, rule: IncidentRule) -> Sequence[Subscription]:
    try:
        return tuple(checked("a wish", wish, Subscription) for wish in rule.subscriptions())
    except Exception as error:
        raise failure(f"incident rule {name}", error, "subscribing") from error


def _computed(name: str, statistic: Statistic, record: MissionRecord) -> object:
    try:
        value = statistic(record)
    except Exception as error:
        raise failure(f"statistic {name}", error) from error
    breach = json_breach(value)
    if breach is not None:
        raise HookError(f"statistic {name}: {breach}")
    return value
