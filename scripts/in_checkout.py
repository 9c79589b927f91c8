"""What the rosrun stubs share: find an interpreter that can run this project, then call a function of it.

A checkout has its libraries in ``.venv``, a wheel in the virtual environment that it was installed into; roslaunch and
rosrun start nodes with the system's Python, which may have none of them.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys
from pathlib import Path
from typing import Optional

# What the project imports sooner or later, by name; looking for them imports nothing.
NEEDED = ("rqt_mrta_py", "cv2", "lxml", "numpy", "pluggy", "pybullet", "rosbags", "yaml")


def call(module: str, function: str, script: str) -> None:
    """Leave the process with what a function returns, from the stub's own environment where this lacks a library.

    Args:
        module: Where the function lives.
        function: Its name; it takes no arguments and returns an exit code.
        script: The stub's own path.
    """
    lacking = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    python = environment_above(Path(script).resolve()) if lacking else None
    if python is not None and Path(sys.prefix).resolve() != python.parents[1]:
        os.execv(str(python), [str(python), script, *sys.argv[1:]])
    try:
        entry = getattr(importlib.import_module(module), function)
    except ImportError as error:
        advice = "install rqt_mrta_py[all], or call ./run in a checkout"
        sys.stderr.write(f"rqt_mrta_py: {sys.executable}: {error}; {advice}\n")
        sys.exit(4)
    except KeyboardInterrupt:
        # Nothing has begun yet.
        sys.exit(130)
    sys.exit(entry())


def environment_above(script: Path) -> Optional[Path]:
    """Find the interpreter of the checkout or of the virtual environment that a script belongs to.

    Args:
        script: Its resolved path.

    Returns:
        The ``.venv/bin/python`` of a checkout that was set up, the ``bin/python`` of a virtual environment, or None
        outside of both.
    """
    for folder in script.parents:
        if (folder / ".venv" / "set-up").exists():
            return folder / ".venv" / "bin" / "python"
        if (folder / "pyvenv.cfg").exists():
            return folder / "bin" / "python"
    return None
