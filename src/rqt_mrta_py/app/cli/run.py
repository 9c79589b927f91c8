"""Run a simulated team on its tasks and leave a bag, a summary and pictures."""

from __future__ import annotations

import argparse

from rqt_mrta_py.app.cli.common import (
    ProgressLine,
    add_output_arguments,
    complain_about,
    finish,
    not_negative,
    positive,
)

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument(
        "application", metavar="APPLICATION", help="a registered name, or the path of a package or rqt_mrta.xml"
    )
    parser.add_argument("--architecture", metavar="A", help="how tasks are shared out (default: the application's own)")
    parser.add_argument("--seed", metavar="N", type=_seed, default=0, help="of every random generator (default: 0)")
    parser.add_argument("--duration", metavar="S", type=positive, help="mission seconds (default: the scenario's)")
    parser.add_argument(
        "--robots",
        metavar="N",
        type=_count,
        help="only the first N of the application's robots (default: all, or as many as its mission is made for)",
    )
    parser.add_argument("--world", metavar="W", help="where to simulate (default: the scenario's)")
    parser.add_argument(
        "--map",
        choices=("known", "unknown"),
        help="whether robots know the obstacles from the start, or map what they see (default: the scenario's)",
    )
    parser.add_argument(
        "--set",
        metavar="PATH=VALUE",
        dest="overrides",
        action="append",
        default=[],
        help="set a parameter, for instance robot2/spin_rate=10, or a setting of the application, for instance "
        "structure=tower (mrta show APPLICATION lists them); may be given several times",
    )
    parser.add_argument(
        "--processes",
        metavar="N",
        type=int,
        choices=(1, 2),
        help="1: do everything in one; 2: supervise, record and draw in another (default: 2 where there are two cores)",
    )
    parser.add_argument(
        "--ros",
        action="store_true",
        help="world and robots as nodes of a ROS graph, with /supervisor as a node too; a master is started where "
        "ROS_MASTER_URI names this machine and none answers; a scenario whose radio is not perfect is refused",
    )
    parser.add_argument(
        "--lock-step",
        action="store_true",
        help="with --ros: every tick waits for all nodes, so that they do exactly what they do without --ros",
    )
    parser.add_argument(
        "--factor",
        metavar="F",
        type=not_negative,
        help="with --ros: how many times as fast as the wall clock, 0 for as fast as it goes "
        "(default: 1, in lock step 0)",
    )
    add_output_arguments(parser)


def main(options: argparse.Namespace) -> int:
    """Run the mission."""
    from rqt_mrta_py.app.compose import compose
    from rqt_mrta_py.app.run.mission import RunRequest, run_mission
    from rqt_mrta_py.errors import UsageError
    from rqt_mrta_py.model import MapKnowledge

    if not options.ros and (options.lock_step or options.factor is not None):
        raise UsageError("--lock-step and --factor are about nodes; give --ros too")
    if options.ros and options.processes is not None:
        raise UsageError("--processes and --ros: each node is a process; leave --processes out")
    host = compose()
    complain_about(host.problems)
    request = RunRequest(
        application=options.application,
        architecture=options.architecture,
        seed=options.seed,
        duration=options.duration,
        robots=options.robots,
        world=options.world,
        map=None if options.map is None else MapKnowledge(options.map),
        overrides=tuple(options.overrides),
        out=options.out,
        force=options.force,
        pictures=options.pictures,
        video=options.video,
        exports=tuple(options.exports),
        figures=tuple(options.figures),
        processes=options.processes,
    )
    with ProgressLine(options.application, options.quiet) as progress:
        if options.ros:
            from rqt_mrta_py.app.live.live_run import LiveWay, run_live_mission

            result = run_live_mission(host, request, LiveWay(options.lock_step, options.factor), progress)
        else:
            result = run_mission(host, request, progress)
    return finish(result, options, "run")


def _seed(text: str) -> int:
    seed = _whole(text)
    if not 0 <= seed < 2**63:
        raise argparse.ArgumentTypeError(f"{text!r}: a whole number from 0 to 2^63 - 1 is expected")
    return seed


def _count(text: str) -> int:
    count = _whole(text)
    if count < 1:
        raise argparse.ArgumentTypeError(f"{text!r}: a whole number from 1 is expected")
    return count


def _whole(text: str) -> int:
    """Read a whole number; -1 for whatever is none."""
    try:
        return int(text)
    except ValueError:
        return -1
