"""The corpus: sound packages, and what is put into one of them to break it in one way."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Dict, List, Tuple

from rqt_mrta_py.app.doctor import examine, find_subjects

PLACES: Dict[str, Tuple[str, str]] = {
    "application": ("yard", "rqt_mrta.xml"),
    "architecture": ("market", "rqt_mrta.xml"),
    "band": ("orchestra", "tasks.yaml"),
    "cmake": ("yard", "CMakeLists.txt"),
    "launch": ("yard", "launch/team.launch"),
    "manifest": ("yard", "package.xml"),
    "parameters": ("yard", "config/robot1_nearest_robot_params.yaml"),
    "saved": ("wizard_application", "rqt_mrta.xml"),
    "scenario": ("yard", "scenario.yaml"),
    "tasks": ("yard", "tasks.yaml"),
    "topic": ("market", "rqt_mrta.xml"),
}
"""Which file of which sound package a bad file takes the place of, by the first word of its name."""


def broken(bad: Path, sound: Path, workspace: Path) -> Path:
    """Make a workspace of sound packages but for one, which is wrong in one way.

    Args:
        bad: of the corpus: a file to be put into a sound package, a folder with such files, or a whole package.
        sound: folder of the sound packages.
        workspace: where to make it; is not there yet.

    Returns:
        The folder of the package.
    """
    shutil.copytree(str(sound), str(workspace))
    if (bad / "package.xml").is_file():
        shutil.copytree(str(bad), str(workspace / bad.name))
        return workspace / bad.name
    package, place = PLACES[bad.name.partition("_")[0]]
    files = {path.relative_to(bad): path for path in bad.rglob("*") if path.is_file()} if bad.is_dir() else {place: bad}
    for name, path in files.items():
        target = workspace / package / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(str(path), str(target))
    return workspace / package


def told(package: Path) -> List[str]:
    """Examine a package among those beside it.

    Args:
        package: its folder.

    Returns:
        A line for each problem, files named from the package.
    """
    found = find_subjects([str(package)], {"ROS_PACKAGE_PATH": str(package.parent)})
    problems = sorted({*found.problems, *examine(found.subjects)})
    return [str(problem).replace(f"{package}/", "") for problem in problems]
