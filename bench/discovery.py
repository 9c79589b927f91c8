"""How long it takes to find what a thousand packages register: this project beside ``rospack plugins``.

Both crawl the same tree in the same run, turn by turn, and the best of several turns counts. rospack answers one
question a process, here for applications that depend on ``rqt_mrta``; ``discover`` answers all questions at once,
within this process, and ``mrta list`` reads every file that it finds besides. No cache helps: rospack's is switched
off, and this project has none. From a checkout: ``python -m bench.discovery``.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence

from rqt_mrta_py.config.discovery.search import discover

__all__ = ["DiscoveryRow", "main", "measure_discovery"]

_TURNS = 3
_GROUP = 50
"""Packages in one folder of the workspace."""

_SHARES = (0.0, 0.1, 1.0)

_APPLICATION = """<rqt_mrta><application><name>{name}</name>
  <robots><robot_0><id>robot1</id><tasks><task_0><id>task1</id></task_0></tasks></robot_0></robots>
</application></rqt_mrta>
"""


class DiscoveryRow(NamedTuple):
    """One comparison.

    Attributes:
        packages: number of them.
        registering: how many register an application.
        ours: ``discover`` within a process [s].
        command: ``mrta list applications``, the interpreter's start and the reading of all files included [s].
        rospack: ``rospack plugins --attrib=application rqt_mrta`` [s]; None if it is not installed.
    """

    packages: int
    registering: int
    ours: float
    command: float
    rospack: Optional[float]

    @property
    def ratio(self) -> Optional[float]:
        """Tell how many times as long as rospack this project takes; None without rospack."""
        return None if self.rospack is None else self.ours / self.rospack


def measure_discovery(packages: int, folder: Path, turns: int = _TURNS) -> List[DiscoveryRow]:
    """Measure trees of which none, every tenth and every package registers an application.

    Args:
        packages: in each tree.
        folder: for the trees, which are removed again.
        turns: of which the best counts.

    Returns:
        One row for each tree.

    Raises:
        RuntimeError: the answers differ, so that a comparison would mean nothing.
    """
    return [
        _measure(packages, round(packages * share), folder / f"tree_{place}", turns)
        for place, share in enumerate(_SHARES)
    ]


def _measure(packages: int, registering: int, tree: Path, turns: int) -> DiscoveryRow:
    _write_tree(packages, registering, tree)
    environment = {
        **os.environ,
        "ROS_PACKAGE_PATH": str(tree),
        "ROS_CACHE_TIMEOUT": "0",
        "ROS_HOME": str(tree / ".ros"),
    }
    listing = [sys.executable, "-m", "rqt_mrta_py", "list", "applications", "-q"]
    asking = ["rospack", "plugins", "--attrib=application", "rqt_mrta"]
    ways: Dict[str, Callable[[], int]] = {
        "ours": lambda: _discovered(environment),
        "command": lambda: _lines(listing, environment, ending=str(tree)),
    }
    if shutil.which(asking[0]) is not None:
        ways["rospack"] = lambda: _lines(asking, environment, ending=str(tree))
    best: Dict[str, float] = {}
    for _ in range(turns):
        for name, way in ways.items():
            start = time.perf_counter()
            found = way()
            best[name] = min(best.get(name, float("inf")), time.perf_counter() - start)
            if found != registering:
                raise RuntimeError(f"{name}: found {found} of {registering} applications")
    shutil.rmtree(str(tree))
    return DiscoveryRow(packages, registering, best["ours"], best["command"], best.get("rospack"))


def _discovered(environment: Mapping[str, str]) -> int:
    registry = discover(environment, prefix="/nowhere", own=(), shares=(), distributions=())
    return len(registry.registrations)


def _lines(command: Sequence[str], environment: Mapping[str, str], ending: str) -> int:
    """Run a command and count the lines that name a place in the tree."""
    done = subprocess.run(command, env=dict(environment), check=True, stdout=subprocess.PIPE, text=True)
    return sum(ending in line for line in done.stdout.splitlines())


def _write_tree(packages: int, registering: int, tree: Path) -> None:
    _write_package(tree / "rqt_mrta", "roscpp", "")
    step = packages // registering if registering else 0
    for number in range(packages):
        package = tree / f"group_{number // _GROUP}" / f"package_{number}"
        if step and number % step == 0 and number // step < registering:
            export = '<rqt_mrta application="${prefix}/rqt_mrta.xml"/>'
            _write_package(package, "rqt_mrta", export)
            (package / "rqt_mrta.xml").write_text(_APPLICATION.format(name=package.name), encoding="utf-8")
        else:
            _write_package(package, "roscpp", '<nodelet plugin="${prefix}/nodelets.xml"/>')


def _write_package(package: Path, dependency: str, export: str) -> None:
    for name in ("src", "launch", "msg"):
        (package / name).mkdir(parents=True)
    (package / "CMakeLists.txt").write_text("project(p)\n", encoding="utf-8")
    (package / "package.xml").write_text(
        f'<?xml version="1.0"?>\n<package format="2">\n  <name>{package.name}</name>\n  <version>1.0.0</version>\n'
        '  <description>One of many.</description>\n  <maintainer email="m@example.org">m</maintainer>\n'
        "  <license>BSD</license>\n  <buildtool_depend>catkin</buildtool_depend>\n"
        f"  <exec_depend>{dependency}</exec_depend>\n  <export>\n    {export}\n  </export>\n</package>\n",
        encoding="utf-8",
    )


def main(argv: Optional[Sequence[str]] = None) -> None:
    """Measure, and print a table.

    Args:
        argv: arguments without the program's name; None for the process's own.
    """
    parser = argparse.ArgumentParser(prog="python -m bench.discovery", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--packages", metavar="N", type=int, default=1000, help="in each tree (default: 1000)")
    parser.add_argument("--turns", metavar="N", type=int, default=_TURNS, help=f"the best counts (default: {_TURNS})")
    options = parser.parse_args(argv)
    if min(options.packages, options.turns) < 1:
        parser.error("--packages and --turns must be at least 1")
    with tempfile.TemporaryDirectory() as folder:
        rows = measure_discovery(options.packages, Path(folder), options.turns)
    print(f"Seconds to find what {options.packages} packages register")
    print(f"{'registering':>11} {'discover':>9} {'rospack':>9} {'ratio':>6} {'mrta list':>9}")
    for row in rows:
        peer = "-" if row.rospack is None else f"{row.rospack:.3f}"
        ratio = "-" if row.ratio is None else f"{row.ratio:.2f}"
        print(f"{row.registering:11} {row.ours:9.3f} {peer:>9} {ratio:>6} {row.command:9.3f}")


if __name__ == "__main__":
    main()
