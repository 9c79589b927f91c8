"""What a run needs on its watching side before anything happens; what is wrong with the input is told here."""

from __future__ import annotations

from typing import Optional, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.exports import exporters_for
from rqt_mrta_py.app.outputs.figures import figure_makers_for
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.picture_files import PictureFiles, check_film, open_film
from rqt_mrta_py.app.outputs.pictures import PictureSchedule, period_in_ticks
from rqt_mrta_py.app.run.choice import chosen_mission
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.app.run.request import RunRequest
from rqt_mrta_py.app.run.watch import WatchPlan
from rqt_mrta_py.hooks import Listener

__all__ = ["Preparation"]


class Preparation:
    """A run that has been asked for, with everything loaded.

    Attributes:
        mission: to be run.
        scenario: of the mission.
        duration: of the mission, at most [s].
        codec: reads and writes messages.

    Args:
        host: registry and plugins.
        request: what the user asks for.

    Raises:
        MrtaError: of whatever is wrong; nothing has been written.
    """

    def __init__(self, host: Host, request: RunRequest) -> None:
        self._host = host
        self._request = request
        self.mission, self.scenario = chosen_mission(host, request.choice)
        self.duration = self.scenario.duration if request.duration is None else request.duration
        self._period = self.scenario.picture_period if request.pictures is None else request.pictures
        check_film(request.video, self._period)
        self.codec = host.codec()
        self._exporters = exporters_for(self.mission, request.exports, host.manager)
        self._figures = figure_makers_for(self.mission, request.figures, host.manager)

    def observe(self) -> Observation:
        """Make what is derived from the stream; to be called once."""
        further: Tuple[Listener, ...] = (*self._exporters.values(), *self._figures.values())
        planned = self.scenario.planned_duration(self._request.duration)
        return Observation(self.mission, self.codec, self._host.manager, planned, further)

    def plan(self, observation: Observation, clock: RunClock, last_tick: int) -> WatchPlan:
        """Make the folder for the outputs, and say how to watch.

        Args:
            observation: of the mission; has heard nothing yet.
            clock: of the run.
            last_tick: of the run.
        """
        request = self._request
        name = f"{self.mission.application.package}-seed{request.seed}"
        folder = OutputFolder.create(request.out, name, request.force)
        pictures = self._pictures(folder)
        return WatchPlan(
            observation=observation,
            folder=folder,
            clock=clock,
            last_tick=last_tick,
            replace=request.force,
            pictures=pictures,
            dashboard=self._host.renderer("dashboard") if pictures else None,
            exporters=self._exporters,
            patience=self._host.manager.patience,
            figures=self._figures,
        )

    def _pictures(self, folder: OutputFolder) -> Optional[PictureSchedule]:
        rate = self.scenario.control_rate
        period_ticks = period_in_ticks(self._period, rate)
        path = folder.monitor(wanted=period_ticks is not None)
        if period_ticks is None or path is None:
            return None
        files = PictureFiles(path, open_film(folder, self._request.video))
        return PictureSchedule(self._host.renderer("monitor"), period_ticks, rate, files)
