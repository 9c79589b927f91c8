"""Review a recorded mission: from a bag to the outputs of a run."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import takewhile
from pathlib import Path
from typing import Callable, Optional, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.mission_message import MISSION_TOPIC
from rqt_mrta_py.app.mission_source import named_mission, silent_about_itself, told_mission
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.clocks import write_clocks
from rqt_mrta_py.app.outputs.communication import write_communication
from rqt_mrta_py.app.outputs.exports import exporters_for, write_exports
from rqt_mrta_py.app.outputs.figures import figure_makers_for, figures_of, write_figures
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.message_exports import with_news, write_message_exports
from rqt_mrta_py.app.outputs.picture_files import PictureFiles, check_film, open_film
from rqt_mrta_py.app.outputs.pictures import period_in_ticks
from rqt_mrta_py.app.outputs.report import ReportSource, bag_file, write_report
from rqt_mrta_py.app.outputs.results import MissionResult, Stopwatch, write_results
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Codec, Listener, Renderer
from rqt_mrta_py.model import Mission
from rqt_mrta_py.supervisor import recorded_communication
from rqt_mrta_py.supervisor.clocks import Timings
from rqt_mrta_py.transport import read_bag, read_bag_info

__all__ = ["ReviewRequest", "review_bag"]

_NS = 1_000_000_000


@dataclass(frozen=True)
class ReviewRequest:
    """What the user asks for.

    Attributes:
        bag: to review.
        application: a registered name or path that says what the bag is about; None to ask the bag itself.
        architecture: a registered name or path; None for the application's own.
        out: folder for the outputs; None to choose one.
        force: write into a folder that is not empty.
        pictures: seconds of mission time between pictures, 0 for none; None for the scenario's, else 1 [s].
        video: make a film of the pictures.
        exports: names of exporters whose files are wanted.
        figures: names of makers whose figures are wanted.
    """

    bag: Path
    application: Optional[str] = None
    architecture: Optional[str] = None
    out: Optional[Path] = None
    force: bool = False
    pictures: Optional[float] = None
    video: bool = False
    exports: Tuple[str, ...] = ()
    figures: Tuple[str, ...] = ()


def review_bag(host: Host, request: ReviewRequest, progress: Callable[[float, float], None]) -> MissionResult:
    """Review a bag and write what a run would have written of it.

    Args:
        host: registry and plugins.
        request: what the user asks for.
        progress: told the time reviewed and the bag's length [s].

    Returns:
        The finished review; one that the user interrupted is complete as far as it went.

    Raises:
        MrtaError: of whatever is wrong. What is wrong with the input is told before anything is written.
    """
    stopwatch = Stopwatch()
    info = read_bag_info(request.bag)
    codec = host.codec()
    mission, duration = _mission(host, request, codec)
    period = request.pictures
    if period is None:
        period = 1.0 if mission.scenario is None else mission.scenario.picture_period
    start_ns = info.start_ns or 0
    length = ((info.end_ns or 0) - start_ns) / _NS
    check_film(request.video, period)
    exporters = exporters_for(mission, request.exports, host.manager)
    makers = figure_makers_for(mission, request.figures, host.manager)
    further: Tuple[Listener, ...] = (*exporters.values(), *makers.values())
    patience = host.manager.patience
    with patience.at_work("the making of the review"):
        observation = Observation(mission, codec, host.manager, duration or length, further)
    with Interrupt() as interrupt, ExitStack() as stack:
        folder = OutputFolder.create(request.out, f"{request.bag.stem}-review", request.force)
        path = folder.monitor(wanted=period > 0)
        pictures = None
        if path is not None:
            files = PictureFiles(path, open_film(folder, request.video))
            stack.callback(files.close)
            pictures = _Pictures(host.renderer("monitor"), files, _period_ns(mission, period))
        heard_ns = start_ns
        timings = Timings()
        for stamped in read_bag(request.bag):
            with patience.at_work(f"the review at {(stamped.receipt_ns - start_ns) / _NS:g} s"):
                if pictures is not None:
                    pictures.until(stamped.receipt_ns, observation)
                observation.feed(stamped)
            timings.take(*stamped)
            heard_ns = stamped.receipt_ns
            progress((heard_ns - start_ns) / _NS, length)
            if interrupt.requested:
                break
        if pictures is not None:
            if info.end_ns is not None and not interrupt.requested:
                pictures.until(info.end_ns + 1, observation)
            files.finish()
        with patience.at_work("the end of the review"):
            results = write_results(folder, observation, host.renderer("dashboard") if pictures else None)
            write_exports(folder, exporters, results.record)
            figures = figures_of(makers, results.record)
        write_figures(folder, figures)
        heard = takewhile(lambda stamped: stamped.receipt_ns <= heard_ns, read_bag(request.bag))
        said = observation.news()
        stream = partial(with_news, heard, said, codec, info.topics)
        write_message_exports(folder, exporters, results.record, stream, patience)
        write_communication(folder, info, results.record, picture=pictures is not None)
        table = timings.table([robot.id for robot in results.record.robots])
        write_clocks(folder, table)
        bags = (bag_file(request.bag, info.messages),)
        source = ReportSource("review", bags, recorded_communication(info.spans), table)
        write_report(folder, observation, results.record, source)
        return stopwatch.result(folder, results, interrupt)


class _Pictures:
    """Draws each picture once everything up to its moment has been heard."""

    def __init__(self, renderer: Renderer, files: PictureFiles, period_ns: Fraction) -> None:
        self._renderer = renderer
        self._files = files
        self._period_ns = period_ns
        self._start_ns: Optional[int] = None
        self._number = 0

    def until(self, receipt_ns: int, observation: Observation) -> None:
        """Draw all pictures of moments before a message's receipt [ns]."""
        if self._start_ns is None:
            self._start_ns = receipt_ns
        while True:
            passed_ns = int(self._number * self._period_ns)
            if self._start_ns + passed_ns >= receipt_ns:
                return
            image = self._renderer(observation.view((self._start_ns + passed_ns) / _NS))
            self._files.add(passed_ns / _NS, image)
            self._number += 1


def _period_ns(mission: Mission, period: float) -> Fraction:
    """Give the time between pictures [ns]: of a simulated mission in whole ticks, as its run drew them."""
    ticks = None if mission.scenario is None else period_in_ticks(period, mission.scenario.control_rate)
    if mission.scenario is None or ticks is None:
        return Fraction(max(1, round(period * _NS)))
    return Fraction(ticks * _NS, mission.scenario.control_rate)


def _mission(host: Host, request: ReviewRequest, codec: Codec) -> Tuple[Mission, Optional[float]]:
    """Find out what the bag is about: what the user says, else what the bag itself says."""
    mission = named_mission(host, request.application, request.architecture, request.bag.stem)
    if mission is not None:
        return mission, None
    stamped = next(read_bag(request.bag, topics=[MISSION_TOPIC]), None)
    if stamped is None:
        raise UsageError(silent_about_itself(str(request.bag)))
    return told_mission(stamped, codec, str(request.bag))
