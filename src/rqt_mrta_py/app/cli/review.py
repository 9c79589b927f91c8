"""Review a recorded mission: what a run writes, from its bags alone."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from rqt_mrta_py.app.cli.common import ProgressLine, add_output_arguments, complain_about, finish, not_negative

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument(
        "bags", metavar="BAG", nargs="+", type=Path, help="ROS 1 bags of one mission, in any order; they merge by time"
    )
    parser.add_argument(
        "--application",
        metavar="A",
        help="what the bags are about (default: what they say, else what their topics fit)",
    )
    parser.add_argument(
        "--architecture",
        metavar="A",
        help="a registered name or an rqt_mrta.xml that says how to read the bags (docs/review.md shows one)",
    )
    parser.add_argument(
        "--from", dest="start", metavar="S", type=not_negative, help="leave out what was received before, in seconds"
    )
    parser.add_argument(
        "--to", dest="end", metavar="S", type=not_negative, help="leave out what was received later, in seconds"
    )
    parser.add_argument(
        "--topics",
        metavar="PATTERN",
        action="append",
        default=[],
        help="read only these topics, with * and ?, for instance '*/alliance/*'; !PATTERN leaves topics out; may be "
        "given several times",
    )
    parser.add_argument(
        "--why",
        metavar="TASK",
        action="append",
        default=[],
        help="explain a task: who could have had it, who took it when, and on what grounds; with * and ? several; may "
        "be given several times",
    )
    add_output_arguments(parser)


def main(options: argparse.Namespace) -> int:
    """Review the bags."""
    from rqt_mrta_py.app.compose import compose
    from rqt_mrta_py.app.live.interest import TopicChoice
    from rqt_mrta_py.app.review.request import ReviewRequest
    from rqt_mrta_py.app.review.review import review_bag

    host = compose()
    complain_about(host.problems)
    first, *more = options.bags
    request = ReviewRequest(
        bag=first,
        application=options.application,
        architecture=options.architecture,
        out=options.out,
        force=options.force,
        pictures=options.pictures,
        video=options.video,
        exports=tuple(options.exports),
        figures=tuple(options.figures),
        more=tuple(more),
        start=options.start,
        end=options.end,
        topics=TopicChoice.of(options.topics),
        why=tuple(options.why),
    )
    with ProgressLine(first.name, options.quiet) as progress:
        result = review_bag(host, request, progress, _tell)
    if all(robot.last_heard is None for robot in result.record.robots):
        reader = result.record.architecture or "the architecture"
        print(
            f"mrta: {first}: no robot was heard as {reader} tells it; is the bag another architecture's?",
            file=sys.stderr,
        )
    return finish(result, options, "review")


def _tell(line: str) -> None:
    print(f"mrta: {line}", file=sys.stderr)
