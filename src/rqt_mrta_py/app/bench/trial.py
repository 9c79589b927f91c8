"""One experiment's mission from its first tick to its record."""

from __future__ import annotations

import time
from typing import Set

from rqt_mrta_py.app.bench.message_counts import MessageCounts
from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.observation import interpreter_for, measures_for, pace_for, with_measures
from rqt_mrta_py.app.run.embedded import EmbeddedRun
from rqt_mrta_py.hooks import Experiment, Trial
from rqt_mrta_py.model import Event, Mission, ScenarioEventKind, TaskState
from rqt_mrta_py.supervisor import Supervisor
from rqt_mrta_py.transport import Dispatcher

__all__ = ["carry_out"]

_ENDED = frozenset(state.value for state in (TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN))


def carry_out(host: Host, experiment: Experiment, mission: Mission, duration: float) -> Trial:
    """Simulate a mission, supervised but neither recorded nor drawn, until every task that can end has.

    Nobody who observes missions is told of it, and the supervisor publishes nothing.

    Args:
        host: registry and plugins.
        experiment: that the mission is made of.
        mission: to be simulated.
        duration: of the mission, at most [s].

    Raises:
        MrtaError: the mission cannot be built, or goes wrong.
    """
    begin = time.process_time()
    patience, manager, codec = host.manager.patience, host.manager, host.codec()
    unended = _Unended(mission)
    counts = MessageCounts()
    with patience.at_work("the making of the mission"):
        supervisor = Supervisor(
            mission,
            interpreter=interpreter_for(mission, manager),
            rules=manager.registered("mrta_register_incident_rules"),
            statistics=manager.registered("mrta_register_statistics"),
            on_event=unended.take_in,
            pace=pace_for(mission, manager),
        )
        dispatcher = Dispatcher(codec, supervisor.report)
        dispatcher.watch(supervisor.sighting)
        for subscription, callback in supervisor.listeners():
            dispatcher.subscribe(subscription, callback)
        measures = measures_for(mission, manager)
        for measure in measures.values():
            for subscription in measure.subscriptions():
                dispatcher.subscribe(subscription, measure.hear)
        run = EmbeddedRun(mission, duration, codec, manager, change=experiment.agents)
    try:
        run.bus.tap(counts.take_in)
        run.bus.tap(dispatcher.feed_batch)
        for tick in range(run.last_tick + 1):
            with patience.at_work(f"the mission's tick at {tick / run.clock.rate:g} s"):
                run.step(tick)
            if unended.none_left:
                break
    finally:
        run.close()
    with patience.at_work("the end of the mission"):
        record = with_measures(supervisor.finish(), measures)
    return Trial(experiment, record, counts.by_type(), time.process_time() - begin)


class _Unended:
    """Which tasks have not ended that can, as the supervisor's events tell; tasks that are to appear are among them."""

    def __init__(self, mission: Mission) -> None:
        events = () if mission.scenario is None else mission.scenario.events
        appearing = {event.task for event in events if event.kind is ScenarioEventKind.TASK_APPEARS}
        tasks = (*mission.tasks, *(task for task in mission.later_tasks if task.id in appearing))
        self._ending = frozenset(task.id for task in tasks if not task.perpetual)
        self._left: Set[str] = set(self._ending)

    @property
    def none_left(self) -> bool:
        """True once all have ended; never in a mission whose tasks all are perpetual."""
        return not self._left and bool(self._ending)

    def take_in(self, event: Event) -> None:
        """Take in an event."""
        if event.kind == "task_state" and event.task in self._ending:
            if event.state in _ENDED:
                self._left.discard(event.task)
            else:
                self._left.add(event.task)
