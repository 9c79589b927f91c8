"""Everything that is derived from a stream, wired once for runs, reviews and live supervision alike.

Supervisor, scene, panels and measures hear the stream through one dispatcher and know nothing of its source; so
reviewing the bag of a run gives what the run itself reported.
"""

from __future__ import annotations

import dataclasses
import logging
from typing import Callable, Dict, List, Mapping, Optional, Sequence

from rqt_mrta_py.app.guard import GuardedMeasure, GuardedPanel, made
from rqt_mrta_py.app.habit import Habit, is_stamp
from rqt_mrta_py.app.observers import observers_of
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import (
    EVERYTHING,
    AllocationInterpreter,
    AllocationInterpreterFactory,
    AllocationPace,
    AllocationPaceFactory,
    Codec,
    Connection,
    FieldReader,
    InterpreterSetup,
    Listener,
    MeasureFactory,
    MeasureSetup,
    MonitorPanelFactory,
    MonitorView,
    Outgoing,
    PanelSetup,
    RobotModel,
    Stamped,
    Subscription,
)
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import Event, Mission, MissionRecord
from rqt_mrta_py.render import SceneTracker
from rqt_mrta_py.render.report import fine_panel
from rqt_mrta_py.supervisor import Attention, Supervisor, team_news, usual_pace
from rqt_mrta_py.transport import Batch, Dispatcher
from rqt_mrta_py.transport.patterns import TopicPattern
from rqt_mrta_py.wording import accepted

__all__ = [
    "CURVE_WINDOW",
    "Observation",
    "interpreter_for",
    "measures_for",
    "pace_for",
    "with_measures",
]

_log = logging.getLogger("rqt_mrta_py.app")

CURVE_WINDOW = 60.0
"""How much of the past the curves of a monitor picture show [s]."""


class Observation:
    """A mission as its stream shows it.

    Attributes:
        mission: what it is about.
        supervisor: states, allocations, events, incidents.
        wishes: what anybody here wants to hear, each once.
    """

    def __init__(
        self,
        mission: Mission,
        codec: Codec,
        manager: PluginManager,
        duration: Optional[float],
        further: Sequence[Listener] = (),
        *,
        panels: bool = True,
        measures: bool = True,
    ) -> None:
        """Wire supervisor, scene, panels, measures and observers.

        Args:
            mission: as far as it is known.
            codec: reads the stream's messages.
            manager: plugins, loaded.
            duration: planned, of the whole mission [s]; None if unknown.
            further: who else hears the stream.
            panels: whether pictures shall show curves, for which much must be read that nobody else wants.
            measures: whether the finished mission is to be measured; likewise.
        """
        self.mission = mission
        self._codec = codec
        self._duration = duration
        self._manager = manager
        self.supervisor = Supervisor(
            mission,
            interpreter=interpreter_for(mission, manager),
            rules=manager.registered("mrta_register_incident_rules"),
            statistics=manager.registered("mrta_register_statistics"),
            on_event=self._on_event,
            pace=pace_for(mission, manager),
        )
        models: Mapping[str, RobotModel] = manager.registered("mrta_register_robot_models")
        self._scene = SceneTracker(mission, models)
        self._panels = _panels(mission, manager) if panels else []
        self._measures = measures_for(mission, manager) if measures else {}
        self._dispatcher = Dispatcher(codec, self.supervisor.report)
        self._dispatcher.watch(self.supervisor.sighting)
        wishes: List[Subscription] = []
        self._attention: Dict[object, Attention] = {}
        for subscription, callback in self.supervisor.listeners():
            attention = self._attention[callback] = self.supervisor.repeats.attention(callback)
            each = attention not in (Attention.ECHO, Attention.LAST, Attention.TIMED)
            self._dispatcher.subscribe(subscription, callback, each=each)
            wishes.append(subscription)
        self._read = tuple((TopicPattern(wish.topic), wish) for wish in wishes if wish.topic != EVERYTHING)
        heard_by: List[Listener] = [self._scene, *self._panels, *self._measures.values()]
        listeners = [*heard_by, *further, *observers_of(mission, manager)]
        for listener in listeners:
            for subscription in listener.subscriptions():
                self._dispatcher.subscribe(subscription, listener.hear)
                wishes.append(subscription)
        self.wishes: Sequence[Subscription] = tuple(dict.fromkeys(wishes))
        manager.notify("mrta_on_mission_start", mission=mission)

    def feed(self, stamped: Stamped) -> None:
        """Take in the next message of the stream."""
        self._dispatcher.feed(stamped)

    def feed_all(self, messages: Sequence[Stamped]) -> None:
        """Take in the next messages of the stream, whenever each was received; whatever they say may wait for its end.

        Args:
            messages: at least one, none of which says to the supervisor what the one before it did not say.
        """
        self._dispatcher.feed_all(messages, self.supervisor.is_quiet_until, self.supervisor.sight_together)

    def statements(self, connection: Connection) -> Optional[FieldReader]:
        """Give what reads from a connection's messages all that the supervisor looks at but when they were sent.

        A message that says what the one before it said, while nothing has changed, prolongs what is so already, and
        no more.

        Args:
            connection: whose.

        Returns:
            The reader; None where the supervisor looks at nothing, so that only the coming of messages tells anything.

        Raises:
            TransportError: the connection's definition has not what is to be read.
        """
        wishes = [wish for pattern, wish in self._read if pattern.match(connection.topic) is not None]
        if not wishes:
            return None
        paths = dict.fromkeys(path for wish in wishes for path in wish.fields if not is_stamp(path))
        return self._codec.compile(connection, tuple(paths))

    def habit(self, connection: Connection) -> Habit:
        """Say how the messages of a connection are heard.

        Args:
            connection: whose.
        """
        met, wrong = self._dispatcher.wishes_for(connection)
        attentions = [self._attention.get(each.callback, Attention.EACH) for each in met]
        again = [each for each, attention in zip(met, attentions) if attention is Attention.LAST]
        echo = [each for each, attention in zip(met, attentions) if attention is Attention.ECHO]
        paths = dict.fromkeys(path for each in (*echo, *again) for path in each.paths if not is_stamp(path))
        timed = attentions.count(Attention.TIMED)
        return Habit(
            at_once=wrong or Attention.AT_ONCE in attentions or timed > 1,
            each=Attention.EACH in attentions,
            wakes=any(self._attention.get(each.callback) is Attention.EACH for each in met),
            timed=timed == 1,
            said=tuple(paths) if echo or again else None,
            again=tuple(again),
        )

    @property
    def glance(self) -> Callable[[Connection, float, int, bytes], None]:
        """What lets those hear a message who want each, though it says nothing new to the supervisor.

        It takes its connection, its receipt [s], its place among the messages of its topic, where it is not counted,
        and its bytes.
        """
        return self._dispatcher.glance

    def pass_over(self, connection: Connection, messages: int) -> None:
        """Count messages of a connection's topic that are fed in no other way; at least one."""
        self._dispatcher.pass_over(connection, messages)

    def feed_batch(self, batch: Batch) -> None:
        """Take in the next messages of the stream."""
        self._dispatcher.feed_batch(batch)

    def news(self) -> Sequence[Outgoing]:
        """Give what the supervisor has to say since it was last asked."""
        return self.supervisor.news()

    def view(self, now: float) -> MonitorView:
        """Give what a monitor picture of a moment shows: the whole mission so far, the curves' last minute.

        Args:
            now: the moment, on the stream's clock [s]; everything up to it has been fed.
        """
        return self._view(now, self.supervisor.record(now), now - CURVE_WINDOW, whole=False)

    def view_without_panels(self, now: float) -> MonitorView:
        """Give the same without curves, which take longest: enough for the team's state and markers."""
        return self._view(now, self.supervisor.record(now), None, whole=False)

    def team_state(self, view: MonitorView) -> Outgoing:
        """Give the whole team at a view's moment as a message to publish."""
        return team_news(view.record, view.now)

    def finish(self) -> MissionRecord:
        """End the stream and sum up, what measures say among the statistics; to be called once.

        Raises:
            HookError: a rule, statistic or measure raises, or gives what is no plain JSON; names it.
        """
        record = with_measures(self.supervisor.finish(), self._measures)
        self._manager.notify("mrta_on_mission_end", record=record)
        return record

    def dashboard_view(self, record: MissionRecord) -> MonitorView:
        """Give what the picture of a finished mission shows."""
        return self._view(record.end or 0.0, record, record.start or 0.0, whole=True)

    @property
    def scene(self) -> SceneTracker:
        """What is known of places and ways."""
        return self._scene

    def report_view(self, record: MissionRecord) -> MonitorView:
        """Give what the page of a finished mission shows: as for its picture, with finer curves."""
        start, end = record.start or 0.0, record.end or 0.0
        panels = tuple(fine_panel(panel.view, start, end) for panel in self._panels)
        return dataclasses.replace(self._view(end, record, None, whole=True), panels=panels)

    def _view(self, now: float, record: MissionRecord, curves_from: Optional[float], whole: bool) -> MonitorView:
        architecture = self.mission.architecture
        parts = [architecture.name, str(architecture.taxonomy)]
        if self.mission.seed is not None:
            parts.append(f"seed {self.mission.seed}")
        start = record.start if record.start is not None else now
        return MonitorView(
            title=self.mission.application.name,
            subtitle="  ".join(parts),
            now=now,
            record=record,
            scene=self._scene.view(now, whole=whole),
            panels=()
            if curves_from is None
            else tuple(panel.view(max(curves_from, start), now) for panel in self._panels),
            duration=self._duration,
        )

    def _on_event(self, event: Event) -> None:
        self._manager.notify("mrta_on_event", event=event)


def interpreter_for(mission: Mission, manager: PluginManager) -> Optional[AllocationInterpreter]:
    """Make what reads the signs of a mission's architecture; None if no plugin registers it.

    Raises:
        HookError: it cannot be made.
    """
    factories: Dict[str, AllocationInterpreterFactory] = manager.registered("mrta_register_allocation_interpreters")
    package = mission.architecture.package
    if package not in factories:
        return None
    robots = tuple(robot.id for robot in mission.application.robots)
    setup = InterpreterSetup(robots, mission.task_ids)
    interpreter: AllocationInterpreter = made(
        f"allocation interpreter of {package}", factories[package], setup, "subscriptions", "hear"
    )
    return interpreter


def pace_for(mission: Mission, manager: PluginManager) -> AllocationPace:
    """Tell how fast a mission's tasks are shared out when all is well: what its architecture's plugin says, if any.

    Raises:
        HookError: the plugin's part raises or answers something else; names it.
    """
    usual = usual_pace(mission.architecture)
    factories: Dict[str, AllocationPaceFactory] = manager.registered("mrta_register_allocation_paces")
    package = mission.architecture.package
    if package not in factories:
        return usual
    who = f"allocation pace of {package}"
    try:
        pace = factories[package](mission, usual)
    except Exception as error:
        raise HookError(f"{who}: {type(error).__name__}: {error}") from error
    if not isinstance(pace, AllocationPace):
        raise HookError(f"{who}: returned {pace!r}; accepted is AllocationPace")
    return pace


def measures_for(mission: Mission, manager: PluginManager) -> Dict[str, GuardedMeasure]:
    """Make the measures of a mission, by name.

    Raises:
        HookError: one cannot be made; names it.
    """
    factories: Dict[str, MeasureFactory] = manager.registered("mrta_register_measures")
    setup = MeasureSetup(mission)
    needs = ("subscriptions", "hear", "value")
    return {
        name: GuardedMeasure(name, made(f"measure {name}", factories[name], setup, *needs))
        for name in sorted(factories)
    }


def with_measures(record: MissionRecord, measures: Mapping[str, GuardedMeasure]) -> MissionRecord:
    """Put what measures say among the statistics of a finished mission.

    Raises:
        HookError: a measure raises, or gives what is no plain JSON; names it.
    """
    if not measures:
        return record
    statistics = {**record.statistics, **{name: measure.value(record) for name, measure in measures.items()}}
    return dataclasses.replace(record, statistics={name: statistics[name] for name in sorted(statistics)})


def _panels(mission: Mission, manager: PluginManager) -> List[GuardedPanel]:
    factories: Dict[str, MonitorPanelFactory] = manager.registered("mrta_register_monitor_panels")
    names = [name for name in mission.architecture.widgets if name in factories]
    missing = [name for name in mission.architecture.widgets if name not in factories]
    if missing:
        what = f"{', '.join(missing)}; {accepted(missing[0], sorted(factories))}"
        _log.warning("architecture=%s names panels that no plugin registers: %s", mission.architecture.package, what)
    setup = PanelSetup(mission)
    needs = ("subscriptions", "hear", "view")
    return [GuardedPanel(name, made(f"monitor panel {name}", factories[name], setup, *needs)) for name in names]
