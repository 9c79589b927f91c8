"""Review a recorded mission: from a bag to the outputs of a run."""

from __future__ import annotations

from contextlib import ExitStack
from itertools import takewhile
from typing import Callable, Iterable, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.clocks import write_clocks
from rqt_mrta_py.app.outputs.communication import write_communication
from rqt_mrta_py.app.outputs.exports import exporters_for, write_exports
from rqt_mrta_py.app.outputs.figures import figure_makers_for, figures_of, write_figures
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.message_exports import with_news, write_message_exports
from rqt_mrta_py.app.outputs.picture_files import PictureFiles, check_film, open_film
from rqt_mrta_py.app.outputs.report import ReportSource, bag_file, write_report
from rqt_mrta_py.app.outputs.results import MissionResult, Stopwatch, write_results
from rqt_mrta_py.app.review.account import review_account
from rqt_mrta_py.app.review.choice import edges_of, excerpt_of
from rqt_mrta_py.app.review.moments import Moments, picture_period
from rqt_mrta_py.app.review.recordings import Recordings
from rqt_mrta_py.app.review.request import ReviewRequest
from rqt_mrta_py.app.review.skimming import Skimming
from rqt_mrta_py.app.review.subject import subject_of
from rqt_mrta_py.app.review.taking import Taking
from rqt_mrta_py.hooks import Listener, Stamped
from rqt_mrta_py.model import Mission
from rqt_mrta_py.supervisor import recorded_communication

__all__ = ["ReviewRequest", "review_bag"]

_NS = 1_000_000_000


def review_bag(
    host: Host,
    request: ReviewRequest,
    progress: Callable[[float, float], None],
    tell: Callable[[str], None] = lambda line: None,
) -> MissionResult:
    """Review bags of one mission and write what a run would have written of it.

    Args:
        host: registry and plugins.
        request: what the user asks for.
        progress: told the time reviewed and the recording's length [s].
        tell: told what the user should know: why a bag is read as it is, what could not be read; a line each.

    Returns:
        The finished review; one that the user interrupted is complete as far as it went.

    Raises:
        MrtaError: of whatever is wrong. What is wrong with the input is told before anything is written.
    """
    stopwatch = Stopwatch()
    recordings = Recordings((request.bag, *request.more))
    for line in recordings.notes:
        tell(line)
    codec = host.codec()
    subject = subject_of(host, recordings, request.application, request.architecture, codec)
    if subject.why:
        tell(subject.why)
    mission = subject.mission
    period = _period(mission, request)
    excerpt = excerpt_of(recordings, request)
    start_ns, end_ns = edges_of(recordings, excerpt)
    length = (end_ns - start_ns) / _NS
    check_film(request.video, period)
    exporters = exporters_for(mission, request.exports, host.manager)
    makers = figure_makers_for(mission, request.figures, host.manager)
    further: Tuple[Listener, ...] = (*exporters.values(), *makers.values())
    patience = host.manager.patience
    with patience.at_work("the making of the review"):
        observation = Observation(mission, codec, host.manager, subject.duration or length, further)
    with Interrupt() as interrupt, ExitStack() as stack:
        folder = OutputFolder.create(request.out, f"{recordings.name}-review", request.force)
        path = folder.monitor(wanted=period > 0)
        pictures = None
        if path is not None:
            files = PictureFiles(path, open_film(folder, request.video))
            stack.callback(files.close)
            pictures = Moments(host.renderer("monitor"), files, picture_period(mission, period), observation)
        taking = Taking(Skimming(observation), pictures, patience, interrupt)
        taking.take(recordings.blocks(excerpt), start_ns, lambda passed: progress(passed, length))
        if pictures is not None:
            files.finish()
        with patience.at_work("the end of the review"):
            results = write_results(folder, observation, host.renderer("dashboard") if pictures else None)
            write_exports(folder, exporters, results.record)
            figures = figures_of(makers, results.record)
        write_figures(folder, figures)
        heard_ns = start_ns if taking.heard_ns is None else taking.heard_ns
        heard = takewhile(lambda stamped: stamped.receipt_ns <= heard_ns, recordings.messages(excerpt))

        def stream() -> Iterable[Stamped]:
            return with_news(heard, observation.news(), codec, recordings.topics)

        write_message_exports(folder, exporters, results.record, stream, patience)
        write_communication(folder, taking.spans, results.record, picture=pictures is not None)
        timings = taking.timings.table([robot.id for robot in results.record.robots])
        write_clocks(folder, timings)
        bags = tuple(bag_file(bag.path, bag.info.messages) for bag in recordings.bags)
        source = ReportSource("review", bags, recorded_communication(taking.spans), timings)
        write_report(folder, observation, results.record, source)
        folder.write_json("review.json", review_account(recordings, subject, request, taking.spans.messages))
        for line in recordings.losses():
            tell(line)
        return stopwatch.result(folder, results, interrupt)


def _period(mission: Mission, request: ReviewRequest) -> float:
    """Say how often a picture is drawn [s]; 0 for never."""
    if request.pictures is not None:
        return request.pictures
    return 1.0 if mission.scenario is None else mission.scenario.picture_period
