"""Copies of the checkout, what is built from them, and environments to install it into."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Dict, Iterable, List, Set

LEFT_BEHIND = shutil.ignore_patterns("__pycache__", "*.egg-info", "build", "dist", "devel", "install", "runs")

# What Debian's metadata of a distribution keep to themselves.
UNSAID = {
    "catkin-pkg": ["docutils", "pyparsing", "python-dateutil"],
    "python-dateutil": ["six"],
    "rospkg": ["catkin-pkg", "distro", "PyYAML"],
}


def copy_checkout(root: Path, target: Path) -> Path:
    """Copy the checkout without what tools and builds left in it."""
    target.mkdir(parents=True)
    for path in sorted(root.iterdir()):
        if path.name in (".ci", "bootstrap") or (not path.name.startswith(".") and path.name not in ("build", "runs")):
            if path.is_dir():
                shutil.copytree(path, target / path.name, ignore=LEFT_BEHIND)
            else:
                shutil.copy(path, target / path.name)
    return target


def build(tree: Path, kind: str, target: Path) -> Path:
    """Build a ``wheel``, ``sdist`` or ``editable`` from a tree as pip would, with this environment's setuptools."""
    target.mkdir(parents=True, exist_ok=True)
    script = f"import sys, setuptools.build_meta as backend; backend.build_{kind}(sys.argv[1])"
    done = subprocess.run(
        [sys.executable, "-c", script, str(target)], cwd=tree, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    (made,) = target.iterdir()
    return made


def clean_environment(**changes: str) -> Dict[str, str]:
    """Give this process's environment without what leads Python, ROS or this project elsewhere, then changed."""
    misleading = re.compile("PYTHON|PIP_|ROS_|RQT_MRTA_PY_|CMAKE_|VIRTUAL_ENV")
    kept = {name: value for name, value in os.environ.items() if not misleading.match(name)}
    return {**kept, "PYTHONNOUSERSITE": "1", "PYTHONDONTWRITEBYTECODE": "1", **changes}


@dataclass(frozen=True)
class Environment:
    """A virtual environment of its own, without the system's packages."""

    folder: Path

    @property
    def python(self) -> Path:
        return self.folder / "bin" / "python"

    def mrta(self, *arguments: str, folder: Path) -> str:
        """Run the installed command to its end; gives what it printed."""
        return run([str(self.folder / "bin" / "mrta"), *arguments], folder)


def make_environment(folder: Path) -> Environment:
    """Make a virtual environment with nothing in it, not even pip."""
    run([sys.executable, "-m", "venv", "--without-pip", str(folder)], folder.parent)
    return Environment(folder)


def run(command: List[str], folder: Path, **changes: str) -> str:
    """Run a program in a clean environment to its end; gives what it printed."""
    done = subprocess.run(
        command, cwd=folder, env=clean_environment(**changes), capture_output=True, text=True, timeout=300, check=False
    )
    assert done.returncode == 0, done.stderr + done.stdout
    return done.stdout


def link_distributions(requirements: Iterable[str], site: Path) -> List[str]:
    """Link what requirements name, and what that requires in turn, from this environment into another.

    Args:
        requirements: As a distribution declares them.
        site: The other environment's folder for packages.

    Returns:
        Requirements that this environment does not meet.
    """
    from packaging.requirements import Requirement

    pending, done, unmet = list(requirements), set(), []
    while pending:
        requirement = Requirement(pending.pop())
        name = requirement.name.lower().replace("_", "-")
        extras = sorted(requirement.extras) or [""]
        if name in done or not (
            requirement.marker is None or any(requirement.marker.evaluate({"extra": extra}) for extra in extras)
        ):
            continue
        done.add(name)
        try:
            distribution = metadata.distribution(requirement.name)
        except metadata.PackageNotFoundError:
            unmet.append(str(requirement))
            continue
        if not requirement.specifier.contains(distribution.version, prereleases=True):
            unmet.append(f"{requirement}, found {distribution.version}")
        pending += [*(distribution.requires or ()), *UNSAID.get(name, ())]
        for entry in _entries(distribution):
            source = Path(str(distribution.locate_file(entry)))
            if source.exists() and not (site / entry).exists():
                (site / entry).symlink_to(source)
    return unmet


def _entries(distribution: metadata.Distribution) -> Set[str]:
    """Name what lies in the folder of packages: from the list of files, else (Debian has none) from the top level."""
    files = [path.parts[0] for path in distribution.files or () if path.parts[0] not in ("..", "__pycache__")]
    top = (distribution.read_text("top_level.txt") or "").split()
    return {*files, *top, *(f"{name}.py" for name in top)}
