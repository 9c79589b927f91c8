"""The virtual environment ``.venv``: on the interpreter that runs this, sees the system's packages, has a new pip."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path
from typing import List

from bootstrap import debian, shell

# Older ones, Ubuntu 20.04's for one, do not know the tags of today's wheels.
PIP = "pip>=23.1"


def python_of(checkout: Path) -> Path:
    """Give the environment's interpreter.

    Args:
        checkout: Its root folder.

    Returns:
        Path, whether it exists or not.
    """
    return checkout / ".venv" / "bin" / "python"


def site_packages(checkout: Path) -> Path:
    """Give the folder that pip installs into.

    Args:
        checkout: Its root folder.

    Returns:
        Path inside ``.venv``.
    """
    question = "import sysconfig; print(sysconfig.get_paths()['purelib'])"
    return Path(shell.run([str(python_of(checkout)), "-I", "-c", question]).stdout.strip())


def mark(checkout: Path) -> Path:
    """Give the file that stands while ``.venv`` is being written: left behind, it tells of an interruption.

    Args:
        checkout: Its root folder.

    Returns:
        Path, whether it exists or not.
    """
    return checkout / ".bootstrap.unfinished"


def provide(checkout: Path, remake: bool) -> None:
    """Make the environment unless a sound one is there.

    Args:
        checkout: Its root folder.
        remake: True to start from nothing whatever is there.

    Raises:
        SetupError: Neither ensurepip nor virtualenv is at hand, or what is does not work.
    """
    if not remake and not mark(checkout).exists() and _is_sound(checkout):
        return
    folder = checkout / ".venv"
    maker = _maker()
    shell.say(f"making the virtual environment {folder}")
    mark(checkout).touch()
    made = shell.run([*maker, "--system-site-packages", "--clear", str(folder)])
    if made.returncode:
        raise shell.SetupError(f"the virtual environment could not be made{shell.tail(made)}")
    pip = shell.run([str(python_of(checkout)), "-m", "pip", "install", "-qq", "--no-input", "--upgrade", PIP])
    if pip.returncode:
        raise shell.SetupError(f"pip could not be upgraded; is there a way to a package index?{shell.tail(pip)}")
    mark(checkout).unlink()


def _is_sound(checkout: Path) -> bool:
    folder = checkout / ".venv"
    try:
        sees_system = "include-system-site-packages = true" in (folder / "pyvenv.cfg").read_text(encoding="utf-8")
    except OSError:
        return False
    # The system's pip is in sight too; the environment must have its own.
    question = "import pip, sys; print(pip.__file__.startswith(sys.prefix) and sys.prefix)"
    answer = shell.run([str(python_of(checkout)), "-I", "-c", question])
    return sees_system and answer.returncode == 0 and answer.stdout.strip() == str(folder)


def _maker() -> List[str]:
    if not _imports("ensurepip, venv") and debian.apt_allowed() and shutil.which("apt-get"):
        debian.install(["python3-venv"])
    if _imports("ensurepip, venv"):
        return [sys.executable, "-m", "venv"]
    if _imports("virtualenv"):
        return [sys.executable, "-m", "virtualenv"]
    if shutil.which("virtualenv"):
        return ["virtualenv", "--python", sys.executable]
    raise shell.SetupError(f"{sys.executable} has neither ensurepip nor virtualenv; install the package python3-venv")


def _imports(modules: str) -> bool:
    return shell.run([sys.executable, "-I", "-c", f"import {modules}"]).returncode == 0
