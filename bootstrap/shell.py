"""What is said, what fails, what is started."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Mapping, Optional, Sequence

# Exit code of the mrta command for something missing in the environment.
MISSING = 4

# Variables of the user's that would lead pip or Python past the virtual environment.
_MISLEADING = ("PIP_PREFIX", "PIP_ROOT", "PIP_TARGET", "PYTHONHOME", "PYTHONPATH")


class SetupError(Exception):
    """The set-up cannot go on; the message says what to do."""


def say(text: str) -> None:
    """Print one line of progress on stderr.

    Args:
        text: What happens, without a line break.
    """
    print(f"rqt_mrta_py: {text}", file=sys.stderr, flush=True)


def clean_environment() -> Mapping[str, str]:
    """Give the caller's environment without what would lead pip past the virtual environment.

    Returns:
        Variables for a child process.
    """
    kept = {name: value for name, value in os.environ.items() if name not in _MISLEADING}
    # Said, not left out: a pip.conf with "user = true" would win over silence.
    settled = {"PYTHONNOUSERSITE": "1", "PIP_USER": "0", "PIP_DISABLE_PIP_VERSION_CHECK": "1", "LC_ALL": "C.UTF-8"}
    return {**kept, **settled}


def run(
    command: Sequence[str], folder: Optional[Path] = None, environment: Optional[Mapping[str, str]] = None
) -> subprocess.CompletedProcess[str]:
    """Start a program, wait for it and keep what it printed.

    Args:
        command: Program and arguments.
        folder: Where to run it; the caller's folder when None.
        environment: Its variables; ``clean_environment()`` when None.

    Returns:
        The finished process; stdout and stderr apart, as text. A program that is not there ends with 127.
    """
    variables = clean_environment() if environment is None else environment
    try:
        return subprocess.run(
            list(command),
            cwd=folder,
            env=variables,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
    except FileNotFoundError as error:
        return subprocess.CompletedProcess(list(command), 127, "", str(error))


def tail(process: subprocess.CompletedProcess[str], lines: int = 12) -> str:
    """Give the last lines that a failed program printed.

    Args:
        process: The finished process.
        lines: How many lines at most.

    Returns:
        Lines of stderr, or of stdout where stderr is empty, indented.
    """
    text = process.stderr.strip() or process.stdout.strip()
    return "".join(f"\n    {line}" for line in text.splitlines()[-lines:])
