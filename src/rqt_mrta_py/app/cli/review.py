"""Review a recorded mission: what a run writes, from its bag alone."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from rqt_mrta_py.app.cli.common import ProgressLine, add_output_arguments, complain_about, finish

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument("bag", metavar="BAG", type=Path, help="a ROS 1 bag")
    parser.add_argument("--application", metavar="A", help="what the bag is about (default: what it says itself)")
    parser.add_argument(
        "--architecture", metavar="A", help="a registered name or an rqt_mrta.xml that says how to read the bag"
    )
    add_output_arguments(parser)


def main(options: argparse.Namespace) -> int:
    """Review the bag."""
    from rqt_mrta_py.app.compose import compose
    from rqt_mrta_py.app.review.review import ReviewRequest, review_bag

    host = compose()
    complain_about(host.problems)
    request = ReviewRequest(
        bag=options.bag,
        application=options.application,
        architecture=options.architecture,
        out=options.out,
        force=options.force,
        pictures=options.pictures,
        video=options.video,
        exports=tuple(options.exports),
        figures=tuple(options.figures),
    )
    with ProgressLine(options.bag.name, options.quiet) as progress:
        result = review_bag(host, request, progress)
    if all(robot.last_heard is None for robot in result.record.robots):
        reader = result.record.architecture or "the architecture"
        print(
            f"mrta: {options.bag}: no robot was heard as {reader} tells it; is the bag another architecture's?",
            file=sys.stderr,
        )
    return finish(result, options, "review")
