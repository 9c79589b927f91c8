"""The watching side of a run: everything that only hears the stream, and what it leaves.

The team's side calls it once a tick and never looks at it, so it can stand in the same process or in another one;
both write the same bytes.
"""

from __future__ import annotations

from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from typing import Any, Iterator, Mapping, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.exports import write_exports
from rqt_mrta_py.app.outputs.figures import figures_of, write_figures
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.message_exports import write_message_exports
from rqt_mrta_py.app.outputs.pictures import PICTURE_TOPIC, PictureSchedule
from rqt_mrta_py.app.outputs.report import ReportSource, bag_file, write_report
from rqt_mrta_py.app.outputs.results import Results, write_results
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.hooks import Exporter, FigureMaker, MonitorView, Outgoing, Renderer
from rqt_mrta_py.hooks.patience import Patience
from rqt_mrta_py.render import MARKERS_TOPIC, team_markers
from rqt_mrta_py.supervisor import recorded_communication
from rqt_mrta_py.supervisor.own_topics import OWN_TOPICS
from rqt_mrta_py.transport import BagWriter, Batch, Bus, read_bag

__all__ = ["BAG", "STATE_PERIOD", "SUPERVISOR_TOPICS", "Watch", "WatchPlan", "Watcher", "open_watch"]

BAG = "mission.bag"
"""The name of the recording in the folder of outputs."""

SUPERVISOR_TOPICS = (*(each.name for each in OWN_TOPICS), MARKERS_TOPIC, PICTURE_TOPIC, "/rosout")
"""What the watching side says on a run's bus."""

STATE_PERIOD = 1
"""The team's state and its markers are published once in so many seconds [s]."""

CHECKPOINT_PERIOD = 0.5
"""How much of the stream's time the bag may hold back [s]."""


class Watcher(Protocol):
    """What the team's side of a run tells."""

    def hear(self, batch: Batch) -> None:
        """Take in messages, in bus order, before loss and delay."""
        ...

    def end_tick(self, tick: int) -> None:
        """Take note that everything of a tick has been heard."""
        ...

    def finish(self) -> Results:
        """End the stream and write what is derived from it; to be called once."""
        ...


@dataclass(frozen=True)
class WatchPlan:
    """What the watching side of a run is made from.

    Attributes:
        observation: of the mission; has heard nothing yet.
        folder: for the outputs.
        clock: of the run.
        last_tick: of the run.
        replace: take the place of an earlier bag.
        pictures: draws monitor pictures; None for none.
        dashboard: draws the mission in one picture; None for none.
        exporters: asked for, by name.
        patience: how long plugins may take.
        figures: makers of those asked for, by name.
    """

    observation: Observation
    folder: OutputFolder
    clock: RunClock
    last_tick: int
    replace: bool
    pictures: Optional[PictureSchedule]
    dashboard: Optional[Renderer]
    exporters: Mapping[str, Exporter]
    patience: Patience
    figures: Mapping[str, FigureMaker] = field(default_factory=dict)


class Watch:
    """Supervises, records and draws one run."""

    def __init__(self, plan: WatchPlan, bag: BagWriter, bus: Bus) -> None:
        """Join a bus: what is published on it is heard, and the supervisor speaks on it.

        Args:
            plan: what to watch.
            bag: takes every message.
            bus: of the team, or one that carries nothing but the supervisor's own messages.
        """
        self._plan = plan
        self._bag = bag
        self._tick = -1
        self._node = bus.node("/supervisor")
        bus.tap(self.hear)
        self.abandoned = False

    def timed_parts(self) -> Iterator[Tuple[Any, str, str]]:
        """Name what a benchmark times: object, method, and the part of the work that it is."""
        yield self._bag, "write_batch", "recording"
        yield self._plan.observation, "feed_batch", "supervision"
        yield self._plan.observation, "news", "supervision"
        yield self._plan.observation, "view", "views"
        yield self._plan.observation, "team_state", "views"
        if self._plan.pictures is not None:
            yield self._plan.pictures, "draw", "drawing"

    def abandon(self) -> None:
        """Bring to the file what was heard, and leave the bag open as one whose run never ended."""
        self._bag.checkpoint()
        self.abandoned = True

    def hear(self, batch: Batch) -> None:
        """Take in messages; they are in the bag, whatever a rule makes of them."""
        self._bag.write_batch(batch)
        self._plan.observation.feed_batch(batch)

    def say(self, message: Outgoing, now: float) -> None:
        """Say something that nobody here derived, such as an order of an operator.

        Args:
            message: what is said; it is heard like everything else.
            now: the moment [s]; not before anything that was heard.
        """
        self._node.publish(message, now)

    def end_tick(self, tick: int) -> None:
        """Say what is new, draw what is due."""
        with self._plan.patience.at_work(f"the watching of the tick at {tick / self._plan.clock.rate:g} s"):
            self._end_tick(tick)

    def _end_tick(self, tick: int) -> None:
        plan, observation, pictures = self._plan, self._plan.observation, self._plan.pictures
        now = plan.clock.stamp(tick)
        self._tick = tick
        self._publish(observation.news(), now)
        last = tick == plan.last_tick
        state_is_due = last or self._is_state_due(tick)
        picture_is_due = pictures is not None and pictures.due(tick)
        if state_is_due or picture_is_due:
            view = observation.view(now)
            if state_is_due:
                self._say_state(view, now)
            if pictures is not None and picture_is_due:
                pictures.draw(tick, view)
        if pictures is not None:
            self._publish(pictures.placed_at(tick, last), now)

    def _say_state(self, view: MonitorView, now: float) -> None:
        self._publish([self._plan.observation.team_state(view), team_markers(view, now)], now)

    def _is_state_due(self, tick: int) -> bool:
        return tick % (STATE_PERIOD * self._plan.clock.rate) == 0

    def _end_early(self) -> None:
        """Say after a tick that has become the last what is said at the planned one."""
        tick, pictures, observation = self._tick, self._plan.pictures, self._plan.observation
        now = self._plan.clock.stamp(tick)
        if not self._is_state_due(tick):
            self._say_state(observation.view(now), now)
        if pictures is not None:
            self._publish(pictures.placed_at(tick, True), now)

    def finish(self) -> Results:
        """Close the bag and write the results."""
        plan = self._plan
        if 0 <= self._tick < plan.last_tick:
            self._end_early()
        with plan.patience.at_work("the end of the mission"):
            results = self._finish(plan)
            figures = figures_of(plan.figures, results.record)
        # Drawn by us, however many there are: nobody needs patience for it.
        write_figures(plan.folder, figures)
        bag = plan.folder.path / BAG
        write_message_exports(plan.folder, plan.exporters, results.record, lambda: read_bag(bag), plan.patience)
        return results

    def _finish(self, plan: WatchPlan) -> Results:
        if plan.pictures is not None:
            plan.pictures.finish()
        self._bag.close()
        results = write_results(plan.folder, plan.observation, plan.dashboard)
        write_exports(plan.folder, plan.exporters, results.record)
        spans = self._bag.spans()
        bags = (bag_file(self._bag.path, sum(count for _, count, _, _ in spans)),)
        source = ReportSource("run", bags, recorded_communication(spans))
        write_report(plan.folder, plan.observation, results.record, source)
        return results

    def _publish(self, messages: Sequence[Outgoing], now: float) -> None:
        for message in messages:
            self._node.publish(message, now)


@contextmanager
def open_watch(plan: WatchPlan, bus: Bus) -> Iterator[Watch]:
    """Watch from here; whatever leaves the block, the bag is complete as far as the run went.

    Args:
        plan: what to watch.
        bus: see Watch.
    """
    path = plan.folder.path / BAG
    bag = BagWriter(path, checkpoint_period=CHECKPOINT_PERIOD, replace=plan.replace)
    watch = Watch(plan, bag, bus)
    with ExitStack() as stack:
        if plan.pictures is not None:
            stack.callback(plan.pictures.close)
        stack.push(lambda *exception: None if watch.abandoned else bag.__exit__(*exception))
        yield watch
