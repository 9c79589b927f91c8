"""The command ``mrta``."""

from __future__ import annotations

import argparse
import errno
import importlib
import sys
from typing import Any, List, Optional, Sequence

from rqt_mrta_py import __version__
from rqt_mrta_py.app.cli.logs import start_logging
from rqt_mrta_py.app.cli.parser import CommandParser, VerbParser, verbosity
from rqt_mrta_py.app.cli.stdout import mute
from rqt_mrta_py.app.cli.terminal import guarded_streams
from rqt_mrta_py.errors import MrtaError, UsageError
from rqt_mrta_py.wording import shown

__all__ = ["main"]

_MOST_LINES = 40
"""So much is said of what is wrong, unless more is asked for: what one robot lacks, ten thousand may lack too."""

VERBS = ("list", "show", "new", "doctor", "configure", "run", "watch", "review", "compare", "salvage", "bench")

_DESCRIPTION = "Supervise teams of robots that share out tasks among themselves (multi-robot task allocation)."
_EPILOG = "Exit status: 0 done, 1 judged bad, 2 wrong usage, 3 bad input, 4 something is missing here, 130 interrupted."


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Run one verb.

    Args:
        argv: arguments without the program's name; None for the process's own.

    Returns:
        The exit status.
    """
    with guarded_streams():
        return _run(argv)


def _run(argv: Optional[Sequence[str]]) -> int:
    """Run one verb; give the exit status."""
    arguments = without_remappings(sys.argv[1:] if argv is None else argv)
    verbose = 0
    try:
        wish = verbosity().parse_known_args(arguments)[0]
        verbose = wish.verbose
        start_logging(verbose, wish.quiet)
        options = _parser(_verb(arguments)).parse_args(arguments)
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
        if isinstance(error, OSError) and error.errno == errno.ENAMETOOLONG:
            _complain(f"{shown(error.filename)}: longer than a file's name can be", verbose)
            return UsageError.exit_code
        _complain(f"internal error: {type(error).__name__}: {error}; -vv shows where", verbose)
        return 70


def without_remappings(arguments: Sequence[str]) -> List[str]:
    """Take ROS's remappings (``name:=value``) off, as rosrun and roslaunch add them."""
    return [argument for argument in arguments if ":=" not in argument]


def _complain(message: str, verbose: int) -> None:
    if verbose >= 2:
        import traceback

        traceback.print_exc()
    lines = message.splitlines()
    told = lines if verbose or len(lines) <= _MOST_LINES else lines[: _MOST_LINES - 1]
    for line in told:
        print(f"mrta: {line}", file=sys.stderr)
    if len(told) < len(lines):
        print(f"mrta: and {len(lines) - len(told)} more; -v tells them", file=sys.stderr)


def _verb(arguments: Sequence[str]) -> Optional[str]:
    """Give the verb that is asked for; None if there is none, for what stands before it asks for something else."""
    return arguments[0] if arguments and not arguments[0].startswith("-") else None


def _parser(verb: Optional[str] = None) -> argparse.ArgumentParser:
    """Make a parser that knows our own verbs and, if it is none of them, the one of a plugin that is asked for."""
    common = verbosity()
    parser = CommandParser(prog="mrta", description=_DESCRIPTION, epilog=_EPILOG)
    parser.appendix = _plugin_verbs
    parser.add_argument("--version", action="version", version=f"rqt_mrta_py {__version__}")
    verbs: Any = parser.add_subparsers(
        title="verbs", metavar="VERB", dest="verb", required=True, parser_class=VerbParser
    )
    for name in VERBS:
        if verb in VERBS and name != verb:
            # Known by name; what it takes is not asked for, and its modules need not be read.
            verbs.add_parser(name)
            continue
        module = importlib.import_module(f"rqt_mrta_py.app.cli.{name}")
        first_line = (module.__doc__ or "").splitlines()[0]
        own = verbs.add_parser(name, parents=[common], help=first_line, description=first_line)
        module.add_arguments(own)
        own.set_defaults(main=module.main)
    if verb is not None and verb not in VERBS:
        from rqt_mrta_py.app.cli.plugin_verbs import add_plugin_verb

        add_plugin_verb(verb, VERBS, verbs, common)
    return parser


def _plugin_verbs() -> str:
    """Write the section of the help page on verbs of plugins."""
    from rqt_mrta_py.app.cli.plugin_verbs import help_on_plugin_verbs

    return help_on_plugin_verbs(VERBS)
