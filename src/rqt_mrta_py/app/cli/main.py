"""The command ``mrta``."""

from __future__ import annotations

import argparse
import importlib
import logging
import sys
import traceback
from typing import List, Optional, Sequence

from rqt_mrta_py import __version__
from rqt_mrta_py.app.cli.log_format import LogFormatter
from rqt_mrta_py.app.cli.parser import CommandParser, VerbParser
from rqt_mrta_py.app.cli.stdout import mute
from rqt_mrta_py.errors import MrtaError

__all__ = ["main"]

VERBS = ("list", "show", "run", "review")

_DESCRIPTION = "Supervise teams of robots that share out tasks among themselves (multi-robot task allocation)."
_EPILOG = "Exit status: 0 done, 1 judged bad, 2 wrong usage, 3 bad input, 4 something is missing here, 130 interrupted."


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Run one verb.

    Args:
        argv: arguments without the program's name; None for the process's own.

    Returns:
        The exit status.
    """
    verbose = 0
    try:
        options = _parser().parse_args(without_remappings(sys.argv[1:] if argv is None else argv))
        verbose = options.verbose
        level = logging.WARNING + 10 * options.quiet - 10 * verbose
        handler = logging.StreamHandler(sys.stderr)
        handler.setFormatter(LogFormatter(tracebacks=verbose >= 2))
        logging.basicConfig(level=max(level, logging.DEBUG), handlers=[handler])
        return int(options.main(options))
    except MrtaError as error:
        _complain(str(error), verbose)
        return error.exit_code
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:
        # Whoever read the help page has gone.
        mute()
        return 0
    except Exception as error:  # noqa: BLE001 - the last border: a defect of ours is told in one line too
        _complain(f"internal error: {type(error).__name__}: {error}; -vv shows where", verbose)
        return 70


def without_remappings(arguments: Sequence[str]) -> List[str]:
    """Take ROS's remappings (``name:=value``) off, as rosrun and roslaunch add them."""
    return [argument for argument in arguments if ":=" not in argument]


def _complain(message: str, verbose: int) -> None:
    if verbose >= 2:
        traceback.print_exc()
    for line in message.splitlines():
        print(f"mrta: {line}", file=sys.stderr)


def _parser() -> argparse.ArgumentParser:
    common = VerbParser(add_help=False)
    common.add_argument("-v", "--verbose", action="count", default=0, help="say more on stderr; -vv with tracebacks")
    common.add_argument("-q", "--quiet", action="count", default=0, help="say less on stderr")
    parser = CommandParser(prog="mrta", description=_DESCRIPTION, epilog=_EPILOG)
    parser.add_argument("--version", action="version", version=f"rqt_mrta_py {__version__}")
    verbs = parser.add_subparsers(title="verbs", metavar="VERB", dest="verb", required=True, parser_class=VerbParser)
    for name in VERBS:
        module = importlib.import_module(f"rqt_mrta_py.app.cli.{name}")
        first_line = (module.__doc__ or "").splitlines()[0]
        verb = verbs.add_parser(name, parents=[common], help=first_line, description=first_line)
        module.add_arguments(verb)
        verb.set_defaults(main=module.main)
    return parser
