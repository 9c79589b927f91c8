"""A checkout in miniature whose set-up runs against programs that only write down how they were called."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Dict, List, Optional

import pytest

ROOT = Path(__file__).resolve().parents[2]


class Miniature:
    """A copy of the commands and their shell, with a set-up of a few lines in the place of the real one."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.calls = folder / "calls.txt"
        (folder / "msg").mkdir(parents=True)
        shutil.copytree(ROOT / "bootstrap", folder / "bootstrap", ignore=shutil.ignore_patterns("*.py", "__pycache__"))
        for command in ("run", "test"):
            shutil.copy(ROOT / command, folder / command)
        (folder / "setup.py").write_text("# dependencies\n", encoding="utf-8")
        (folder / "scripts").mkdir()
        (folder / "scripts" / "mrta").write_text(
            "import os, sys\n"
            "print(os.getcwd(), *(f'<{word}>' for word in sys.argv[1:]), sep='\\n')\n"
            "sys.exit(int(os.environ.get('MRTA_TEST_EXIT', 0)))\n",
            encoding="utf-8",
        )
        self.fake_set_up("echo settled")

    def fake_set_up(self, script: str) -> None:
        """Let the set-up note its arguments, make a .venv that serves, then do what a line of shell says."""
        (self.folder / "bootstrap" / "__main__.py").write_text(
            "import pathlib, subprocess, sys\n"
            "root = pathlib.Path(__file__).resolve().parent.parent\n"
            "(root / '.venv/bin').mkdir(parents=True, exist_ok=True)\n"
            "python = root / '.venv/bin/python'\n"
            "python.is_symlink() and python.unlink()\n"
            "python.symlink_to('/usr/bin/python3')\n"
            "with (root / 'calls.txt').open('a') as calls:\n"
            "    print(*sys.argv[1:], file=calls)\n"
            f"sys.exit(subprocess.call(['sh', '-c', {script!r}], cwd=root))\n",
            encoding="utf-8",
        )

    def environment(self, **changes: str) -> Dict[str, str]:
        """Give this process's environment without what concerns the bootstrap, then changed."""
        kept = {name: value for name, value in os.environ.items() if not name.startswith(("MRTA_", "ROS_", "CMAKE_"))}
        return {**kept, **changes}

    def run(self, *arguments: str, folder: Optional[Path] = None, **changes: str) -> subprocess.CompletedProcess[str]:
        """Call ./run."""
        return self.call(str(self.folder / "run"), *arguments, folder=folder, **changes)

    def shell(self, script: str, **changes: str) -> subprocess.CompletedProcess[str]:
        """Run a script with the functions of bootstrap.sh at hand."""
        head = f"set -euo pipefail\ncheckout='{self.folder}'\nsource '{self.folder}/bootstrap/bootstrap.sh'\n"
        return self.call("bash", "-c", head + script, **changes)

    def call(self, *command: str, folder: Optional[Path] = None, **changes: str) -> subprocess.CompletedProcess[str]:
        """Run a program to its end."""
        return subprocess.run(
            command,
            cwd=folder,
            env=self.environment(**changes),
            capture_output=True,
            text=True,
            check=False,
            timeout=60,
        )

    def set_ups(self) -> List[str]:
        """List the arguments of every set-up so far."""
        return self.calls.read_text(encoding="utf-8").splitlines() if self.calls.exists() else []


@pytest.fixture
def miniature(tmp_path: Path) -> Miniature:
    """Give a checkout whose path has a blank."""
    if not Path("/usr/bin/python3").exists():
        pytest.skip("/usr/bin/python3 is not on this machine")
    return Miniature(tmp_path.resolve() / "a checkout")


def program(folder: Path, name: str, script: str) -> Path:
    """Write an executable shell script."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / name
    path.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
    path.chmod(0o755)
    return path
