"""The steps of the set-up in their order, and when they are skipped."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import Optional, Sequence

from bootstrap import stamp


def main(arguments: Sequence[str]) -> int:
    """Check or make a set-up.

    Args:
        arguments: ``check LEVEL`` to ask whether anything needs doing, ``LEVEL`` to do it; a level is run or test.

    Returns:
        0 when all is well, 1 when a check found work to do, 4 when something is missing that cannot be had.
    """
    checkout = Path(__file__).resolve().parent.parent
    wanted = stamp.call_for(arguments[-1], checkout)
    found = stamp.read(checkout)
    if found is not None and found.serves(wanted, stamp.apt_allowed()):
        return 0
    if arguments[0] == "check":
        return 1

    # Not at the top: the check above is on the way of every command.
    from bootstrap import shell

    try:
        _set_up(checkout, wanted, found)
    except shell.SetupError as error:
        shell.say(str(error))
        return shell.MISSING
    except KeyboardInterrupt:
        shell.say("interrupted; the next call takes the set-up up again")
        return 130
    return 0


def _set_up(checkout: Path, wanted: stamp.Stamp, found: Optional[stamp.Stamp]) -> None:
    from bootstrap import debian, environment, messages, packages, shell

    stamp.remove(checkout)
    if found is not None and replace(found, messages=wanted.messages).serves(wanted, stamp.apt_allowed()):
        level, apt_owed = found.level, found.apt_owed
    else:
        # What was made ready for the tests stays so.
        level = wanted.level if found is None else max(found.level, wanted.level, key=stamp.LEVELS.index)
        apt_owed = debian.provide(level, ros_elsewhere=any(Path("/opt/ros").glob("*/setup.bash")))
        moved = found is not None and (found.checkout, found.interpreter) != (wanted.checkout, wanted.interpreter)
        environment.provide(checkout, remake=moved)
        packages.provide(checkout, level)
    messages.provide(checkout)
    # The steps may have brought ROS; sources and messages are those of the start, so that no later change is lost.
    stamp.write(replace(wanted, level=level, ros=stamp.ros_presence(), apt_owed=apt_owed))
    shell.say(f"ready: {checkout / '.venv'} on {sys.executable}")
