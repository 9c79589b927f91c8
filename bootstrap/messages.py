"""Python classes of the project's ROS messages, generated into ``.venv`` and put on its path by a ``.pth`` file."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import List

from bootstrap import environment, shell

_FOLDERS = ("msg", "srv", "plugins/*/*/msg", "plugins/*/*/srv")


def provide(checkout: Path) -> None:
    """Generate the classes where ROS's genpy is at hand; without it, leave none behind.

    Args:
        checkout: Its root folder.

    Raises:
        SetupError: A definition cannot be turned into a class.
    """
    python = str(environment.python_of(checkout))
    target, aside = checkout / ".venv" / "messages", checkout / ".venv" / "messages.new"
    for folder in (aside, target):
        if folder.exists() and (folder == aside or not _has_genpy(python)):
            shutil.rmtree(folder)
    if not _has_genpy(python):
        shell.say("ROS 1 for Python is not here; its message classes are left out, all that needs no ROS works")
        return
    generator = Path(__file__).with_name("generate.py")
    files = [str(path) for path in message_files(checkout)]
    made = shell.run([python, "-B", str(generator), str(aside), *files], environment=os.environ)
    if made.returncode:
        raise shell.SetupError(f"message classes could not be generated{shell.tail(made)}")
    if target.exists():
        shutil.rmtree(target)
    aside.mkdir(exist_ok=True)
    aside.rename(target)
    (environment.site_packages(checkout) / "mrta_messages.pth").write_text(f"{target}\n", encoding="utf-8")


def message_files(checkout: Path) -> List[Path]:
    """List the message and service definitions of the main package and of the packages under plugins.

    Args:
        checkout: Its root folder.

    Returns:
        Files, sorted.
    """
    found = (path for folder in _FOLDERS for path in checkout.glob(f"{folder}/*") if path.suffix in (".msg", ".srv"))
    return sorted(found)


def _has_genpy(python: str) -> bool:
    return shell.run([python, "-c", "import genpy.generator"], environment=os.environ).returncode == 0
