"""Review a recorded mission: from a bag to the outputs of a run."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import replace
from itertools import takewhile
from typing import Callable, Iterable, Iterator, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.interrupt import Interrupt
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.clocks import write_clocks
from rqt_mrta_py.app.outputs.communication import write_communication
from rqt_mrta_py.app.outputs.explanations import write_explanations
from rqt_mrta_py.app.outputs.exports import exporters_for, write_exports
from rqt_mrta_py.app.outputs.figures import figure_makers_for, figures_of, write_figures
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.message_exports import with_news, write_message_exports
from rqt_mrta_py.app.outputs.picture_files import PictureFiles, check_film, open_film
from rqt_mrta_py.app.outputs.report import ReportSource, bag_file, write_report
from rqt_mrta_py.app.outputs.results import MissionResult, Stopwatch, write_results
from rqt_mrta_py.app.review.account import review_account
from rqt_mrta_py.app.review.choice import edges_of, excerpt_of
from rqt_mrta_py.app.review.hosts import HostTimings
from rqt_mrta_py.app.review.moments import Moments, picture_period
from rqt_mrta_py.app.review.recordings import Recordings
from rqt_mrta_py.app.review.request import ReviewRequest
from rqt_mrta_py.app.review.skimming import Skimming
from rqt_mrta_py.app.review.subject import Subject, subject_of
from rqt_mrta_py.app.review.taking import Taking
from rqt_mrta_py.app.review.why import Why
from rqt_mrta_py.hooks import Codec, Listener, Stamped
from rqt_mrta_py.model import Explanation, Mission, MissionRecord
from rqt_mrta_py.render.report import BagFile
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
        MrtaError: of whatever is wrong. What is wrong with the input is told before anything is written; that there is
            no task of a name to be explained, once all else is.
    """
    stopwatch = Stopwatch()
    recordings = Recordings((request.bag, *request.more))
    codec = host.codec()
    subject = _subject(host, request, recordings, codec, tell)
    mission = subject.mission
    period = _period(mission, request)
    excerpt = excerpt_of(recordings, request)
    start_ns, end_ns = edges_of(recordings, excerpt)
    length = (end_ns - start_ns) / _NS
    check_film(request.video, period)
    exporters = exporters_for(mission, request.exports, host.manager)
    makers = figure_makers_for(mission, request.figures, host.manager)
    why = Why(mission, request.why, host.manager)
    further: Tuple[Listener, ...] = (*exporters.values(), *makers.values(), *why.listeners)
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
        hosts = HostTimings()
        taking = Taking(Skimming(observation), pictures, patience, interrupt)
        taking.take(recordings.blocks(excerpt, hosts.heard), start_ns, lambda passed: progress(passed, length))
        if pictures is not None:
            files.finish()
        with patience.at_work("the end of the review"):
            results = write_results(folder, observation, host.renderer("dashboard") if pictures else None)
            write_exports(folder, exporters, results.record)
            figures = figures_of(makers, results.record)
        write_figures(folder, figures)
        heard = _heard(recordings.messages(excerpt), start_ns if taking.heard_ns is None else taking.heard_ns)

        def stream() -> Iterable[Stamped]:
            return with_news(heard, observation.news(), codec, recordings.topics)

        write_message_exports(folder, exporters, results.record, stream, patience)
        write_communication(folder, taking.spans, results.record, picture=pictures is not None)
        timings = hosts.table(taking.timings, [robot.id for robot in results.record.robots])
        write_clocks(folder, timings)
        explanations = _explained(why, results.record, folder)
        source = ReportSource("review", _files(recordings), recorded_communication(taking.spans), timings, explanations)
        write_report(folder, observation, results.record, source)
        folder.write_json("review.json", review_account(recordings, subject, request, taking.spans.messages))
        for line in (*recordings.losses(), *why.failures):
            tell(line)
        why.check(results.record, folder.path)
        return replace(stopwatch.result(folder, results, interrupt), explanations=explanations)


def _subject(
    host: Host, request: ReviewRequest, recordings: Recordings, codec: Codec, tell: Callable[[str], None]
) -> Subject:
    """Find out what the bags are about, and tell the user what he should know of that."""
    for line in recordings.notes:
        tell(line)
    subject = subject_of(host, recordings, request.application, request.architecture, codec)
    if subject.why:
        tell(subject.why)
    return subject


def _explained(why: Why, record: MissionRecord, folder: OutputFolder) -> Tuple[Explanation, ...]:
    """Explain the tasks that the user asks about, if any, and write that down."""
    explanations = why.explain(record)
    if why.is_asked:
        write_explanations(folder, explanations)
    return explanations


def _heard(messages: Iterable[Stamped], until_ns: int) -> Iterator[Stamped]:
    """Give the messages up to the last one that was taken in."""
    return takewhile(lambda stamped: stamped.receipt_ns <= until_ns, messages)


def _files(recordings: Recordings) -> Tuple[BagFile, ...]:
    return tuple(bag_file(bag.path, bag.info.messages) for bag in recordings.bags)


def _period(mission: Mission, request: ReviewRequest) -> float:
    """Say how often a picture is drawn [s]; 0 for never."""
    if request.pictures is not None:
        return request.pictures
    return 1.0 if mission.scenario is None else mission.scenario.picture_period
