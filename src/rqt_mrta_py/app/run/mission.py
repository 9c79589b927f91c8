"""Run one simulated mission from its registration to its outputs."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Optional, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.exports import exporters_for
from rqt_mrta_py.app.outputs.figures import figure_makers_for
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.picture_files import PictureFiles, check_film, open_film
from rqt_mrta_py.app.outputs.pictures import PictureSchedule, period_in_ticks
from rqt_mrta_py.app.outputs.results import MissionResult, Stopwatch
from rqt_mrta_py.app.processes import cores
from rqt_mrta_py.app.run.choice import MissionChoice, chosen_mission
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.app.run.embedded import EmbeddedRun
from rqt_mrta_py.app.run.watch import WatchPlan
from rqt_mrta_py.app.run.watch_process import open_watcher
from rqt_mrta_py.model import MapKnowledge

__all__ = ["RunRequest", "run_mission"]


@dataclass(frozen=True)
class RunRequest:
    """What the user asks for.

    Attributes:
        application: a registered name, or the path of a package or rqt_mrta.xml.
        architecture: a registered name; None for the application's own.
        seed: of every random generator.
        duration: of the mission [s]; None for the scenario's.
        robots: how many of the application's robots; None for all.
        world: where to simulate; None for the scenario's.
        map: whether robots know it from the start; None for what the scenario says of each.
        overrides: ``path=value`` of parameters, each path beginning with a robot's id.
        out: folder for the outputs; None to choose one.
        force: write into a folder that is not empty.
        pictures: seconds of mission time between pictures, 0 for none; None for the scenario's [s].
        video: make a film of the pictures.
        exports: names of exporters whose files are wanted.
        figures: names of makers whose figures are wanted.
        processes: 1 or 2; None: as many as there are cores, 2 at the most.
    """

    application: str
    architecture: Optional[str] = None
    seed: int = 0
    duration: Optional[float] = None
    robots: Optional[int] = None
    world: Optional[str] = None
    map: Optional[MapKnowledge] = None
    overrides: Tuple[str, ...] = ()
    out: Optional[Path] = None
    force: bool = False
    pictures: Optional[float] = None
    video: bool = False
    exports: Tuple[str, ...] = ()
    figures: Tuple[str, ...] = ()
    processes: Optional[int] = None

    @property
    def choice(self) -> MissionChoice:
        """Which mission is asked for."""
        return MissionChoice(
            self.application, self.architecture, self.seed, self.robots, self.world, self.map, self.overrides
        )


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
    mission, scenario = chosen_mission(host, request.choice)
    duration = scenario.duration if request.duration is None else request.duration
    period = scenario.picture_period if request.pictures is None else request.pictures
    check_film(request.video, period)
    codec = host.codec()
    exporters = exporters_for(mission, request.exports, host.manager)
    figures = figure_makers_for(mission, request.figures, host.manager)
    with host.manager.patience.at_work("the making of the mission"):
        observation = Observation(mission, codec, host.manager, duration, (*exporters.values(), *figures.values()))
        run = EmbeddedRun(mission, duration, codec, host.manager)
    try:
        name = f"{mission.application.package}-seed{request.seed}"
        with Interrupt() as interrupt:
            folder = OutputFolder.create(request.out, name, request.force)
            pictures = _pictures(host, folder, period, scenario.control_rate, request.video)
            plan = WatchPlan(
                observation=observation,
                folder=folder,
                clock=run.clock,
                last_tick=run.last_tick,
                replace=request.force,
                pictures=pictures,
                dashboard=host.renderer("dashboard") if pictures else None,
                exporters=exporters,
                patience=host.manager.patience,
                figures=figures,
            )
            processes = 1 if run.team_hears_supervisor else request.processes or min(2, cores())
            with rare_collections(), open_watcher(plan, run.bus, codec, processes) as watcher:
                for tick in range(run.last_tick + 1):
                    with host.manager.patience.at_work(f"the mission's tick at {tick / scenario.control_rate:g} s"):
                        run.step(tick)
                    watcher.end_tick(tick)
                    progress(tick / scenario.control_rate, duration)
                    if interrupt.requested:
                        break
                results = watcher.finish()
            return stopwatch.result(folder, results, interrupt, processes)
    finally:
        run.close()


def _pictures(host: Host, folder: OutputFolder, period: float, rate: int, video: bool) -> Optional[PictureSchedule]:
    period_ticks = period_in_ticks(period, rate)
    path = folder.monitor(wanted=period_ticks is not None)
    if period_ticks is None or path is None:
        return None
    files = PictureFiles(path, open_film(folder, video))
    return PictureSchedule(host.renderer("monitor"), period_ticks, rate, files)
