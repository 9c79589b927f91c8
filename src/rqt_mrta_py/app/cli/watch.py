"""Watch a team: through a ROS 1 master, or as its bag grows."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from rqt_mrta_py.app.cli.common import complain_about, positive
from rqt_mrta_py.app.cli.stdout import standard_output

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument(
        "bag", nargs="?", metavar="BAG", type=Path, help="a bag, complete or growing (default: the ROS master)"
    )
    parser.add_argument("--application", metavar="A", help="what is watched (default: what /mrta/mission says)")
    parser.add_argument(
        "--architecture", metavar="A", help="a registered name or an rqt_mrta.xml that says how to read the messages"
    )
    following = parser.add_mutually_exclusive_group()
    following.add_argument(
        "--follow", action="store_true", default=None, help="wait for BAG, and for more of it, until it is complete"
    )
    following.add_argument(
        "--no-follow", dest="follow", action="store_false", help="end with what BAG holds, though it may still grow"
    )
    parser.add_argument("--timeout", metavar="S", type=positive, help="end when nothing has been heard for S seconds")
    parser.add_argument("--graph", action="store_true", help="show nodes and topics with types and rates too")
    parser.add_argument(
        "--picture", metavar="FILE", type=Path, help="draw nodes and topics to FILE (PNG) at the end; implies --graph"
    )
    parser.add_argument(
        "--topics",
        metavar="PATTERN",
        action="append",
        default=[],
        help="of nodes and topics show only these, with * and ?, for instance '*/alliance/*'; !PATTERN leaves topics "
        "out; may be given several times; implies --graph",
    )
    parser.add_argument("--json", action="store_true", help="print as JSON, one document a line")


def main(options: argparse.Namespace) -> int:
    """Watch to the end of the bag, or until the user has seen enough."""
    from rqt_mrta_py.app.cli.watch_display import display_for
    from rqt_mrta_py.app.compose import compose
    from rqt_mrta_py.app.interrupt import Interrupt
    from rqt_mrta_py.app.live.interest import TopicChoice
    from rqt_mrta_py.app.watch.bag import watch_bag
    from rqt_mrta_py.app.watch.view import WatchRequest

    host = compose()
    complain_about(host.problems)
    request = WatchRequest(
        bag=options.bag,
        application=options.application,
        architecture=options.architecture,
        follow=options.follow,
        timeout=options.timeout,
        graph=options.graph or options.picture is not None or bool(options.topics),
        topics=TopicChoice.of(options.topics),
        arguments=tuple(argument for argument in sys.argv[1:] if ":=" in argument),
    )
    with standard_output(), Interrupt() as interrupt, display_for(options) as display:
        if request.bag is not None:
            complain_about(watch_bag(host, request, request.bag, display, interrupt))
        else:
            from rqt_mrta_py.app.watch.master import watch_master

            watch_master(host, request, display, interrupt)
        return 130 if interrupt.requested else 0
