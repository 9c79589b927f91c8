"""The steps of the set-up in their order."""

from __future__ import annotations

from pathlib import Path
from typing import Sequence

from bootstrap import debian, environment, messages, packages, shell


def main(arguments: Sequence[str]) -> int:
    """Set the checkout up; stdout gets one word for the stamp, ``owed`` or ``settled``, when apt was considered.

    Args:
        arguments: The level, ``run`` or ``test``; then what to do: ``messages`` for their classes only, ``all`` for
            every step as far as something is missing, ``remake`` for a new virtual environment as well.

    Returns:
        0 when all is well, 4 when something is missing that cannot be had, 130 when interrupted.
    """
    level, todo = arguments
    checkout = Path(__file__).resolve().parent.parent
    try:
        if todo != "messages":
            apt_owes = debian.provide(level, ros_elsewhere=any(Path("/opt/ros").glob("*/setup.bash")))
            environment.provide(checkout, remake=todo == "remake")
            packages.provide(checkout, level)
            print("owed" if apt_owes else "settled")
        messages.provide(checkout)
    except shell.SetupError as error:
        shell.say(str(error))
        return shell.MISSING
    except KeyboardInterrupt:
        shell.say("interrupted; the next call takes the set-up up again")
        return 130
    return 0
