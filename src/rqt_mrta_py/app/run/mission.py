"""Run one simulated mission from its registration to its outputs."""

from __future__ import annotations

from typing import Callable

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.outputs.results import MissionResult, Stopwatch
from rqt_mrta_py.app.processes import cores
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.app.run.embedded import EmbeddedRun
from rqt_mrta_py.app.run.preparation import Preparation
from rqt_mrta_py.app.run.request import RunRequest
from rqt_mrta_py.app.run.watch_process import open_watcher

__all__ = ["RunRequest", "run_mission"]


def run_mission(host: Host, request: RunRequest, progress: Callable[[float, float], None]) -> MissionResult:
    """Run a mission and write its outputs.

    Args:
        host: registry and plugins.
        request: what the user asks for.
        progress: told the mission time that has passed and the planned one, at every tick [s].

    Returns:
        The finished run; one that the user interrupted is complete as far as it went.

    Raises:
        MrtaError: of whatever is wrong. What is wrong with the input is told before anything is written.
    """
    stopwatch = Stopwatch()
    prepared = Preparation(host, request)
    codec, rate, duration = prepared.codec, prepared.scenario.control_rate, prepared.duration
    with host.manager.patience.at_work("the making of the mission"):
        observation = prepared.observe()
        run = EmbeddedRun(prepared.mission, request.duration, codec, host.manager)
    try:
        with Interrupt() as interrupt:
            plan = prepared.plan(observation, run.clock, run.last_tick)
            processes = 1 if run.team_hears_supervisor else request.processes or min(2, cores())
            with rare_collections(), open_watcher(plan, run.bus, codec, processes) as watcher:
                for tick in range(run.last_tick + 1):
                    with host.manager.patience.at_work(f"the mission's tick at {tick / rate:g} s"):
                        run.step(tick)
                    watcher.end_tick(tick)
                    progress(tick / rate, duration)
                    if interrupt.requested or run.is_over(tick):
                        break
                results = watcher.finish()
            return stopwatch.result(plan.folder, results, interrupt, processes)
    finally:
        run.close()
