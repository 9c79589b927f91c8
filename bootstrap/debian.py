"""Debian packages: what is missing, what of it apt can give, and what will not work without the rest."""

from __future__ import annotations

import os
import shutil
from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

from bootstrap.shell import run, say, tail


@dataclass(frozen=True)
class Group:
    """Packages that serve one purpose.

    Args:
        purpose: What does not work without them.
        level: From which level on they are wanted.
        ros: True for Debian's ROS packages, which never join a ROS under /opt/ros.
        packages: Their names.
    """

    purpose: str
    level: str
    ros: bool
    packages: Tuple[str, ...]


_MESSAGES = ("std", "geometry", "nav", "sensor", "visualization", "diagnostic", "tf2", "actionlib")

GROUPS = (
    Group(
        "live robots on a ROS master, rosrun, roslaunch and the rosbag tools",
        "run",
        True,
        (
            *(f"python3-{name}" for name in ("rospy", "roslaunch", "rosnode", "rostopic", "rosparam")),
            *(f"python3-{name}" for name in ("rosbag", "rosmsg", "rosservice", "actionlib")),
            "rosbash",
            "rospack-tools",
        ),
    ),
    Group(
        "ROS message classes, their definitions and manifests",
        "run",
        True,
        (
            *(f"python3-{name}-msgs" for name in (*_MESSAGES, "rosgraph")),
            *(f"ros-{name}-msgs" for name in (*_MESSAGES, "rosgraph")),
            # Only these carry the package.xml that rospack and rosmsg look for.
            *(f"lib{name}-msgs-dev" for name in (*_MESSAGES, "ros-rosgraph")),
        ),
    ),
    Group(
        "tests of the catkin build and of live nodes",
        "test",
        True,
        (
            "catkin",
            "catkin-lint",
            "ros-message-generation",
            "ros-message-runtime",
            "python3-rostest",
            "python3-rosunit",
        ),
    ),
    Group("tests of the catkin build", "test", False, ("cmake", "make", "g++")),
    Group("tests of the report in a browser", "test", False, ("chromium",)),
)


def provide(level: str, ros_elsewhere: bool) -> bool:
    """Install by apt what a level lacks, as far as that is allowed and possible, and say what stays missing.

    Args:
        level: ``run`` or ``test``.
        ros_elsewhere: True where a ROS stands under /opt/ros.

    Returns:
        True where packages stay missing only because MRTA_NO_APT forbids apt.
    """
    if shutil.which("dpkg-query") is None or shutil.which("apt-get") is None:
        return False
    wanted = [group for group in GROUPS if group.level in ("run", level)]
    groups = [group for group in wanted if not (group.ros and ros_elsewhere)]
    absent = missing([package for group in groups for package in group.packages])
    if absent and apt_allowed():
        install(absent, [group.packages for group in groups])
        absent = missing(absent)
    for group in groups:
        lacking = [package for package in group.packages if package in absent]
        if lacking:
            reason = "apt did not bring" if apt_allowed() else "MRTA_NO_APT keeps out"
            say(f"{reason} what serves {group.purpose}: {' '.join(lacking)}")
    return bool(absent) and not apt_allowed()


def apt_allowed() -> bool:
    """Tell whether the user left MRTA_NO_APT unset, empty or 0.

    Returns:
        False for any other value.
    """
    return os.environ.get("MRTA_NO_APT", "0") in ("", "0")


def missing(packages: Sequence[str]) -> List[str]:
    """List those packages that are not installed.

    Args:
        packages: Names.

    Returns:
        Names, in the same order.
    """
    answer = run(["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\\n", *packages]).stdout
    installed = {line.split()[0] for line in answer.splitlines() if line.endswith(" installed")}
    return [package for package in packages if package not in installed]


def install(packages: Sequence[str], groups: Sequence[Sequence[str]] = ()) -> None:
    """Install packages by apt; what apt does not know or cannot install is left out.

    Args:
        packages: Names.
        groups: How to divide them when apt refuses them together.
    """
    apt_get = _apt_get()
    if apt_get is None:
        say("apt-get needs root or a sudo that asks for no password; nothing is installed by it")
        return
    updated = run([*apt_get, "-qq", "update"])
    if updated.returncode:
        say(f"apt-get update failed; going on with the package lists as they are{tail(updated, 3)}")
    available = _with_candidate(packages)
    if not available:
        return
    say(f"installing with {' '.join(apt_get)}: {' '.join(available)}")
    failure = _install(apt_get, available)
    if failure and groups:
        say("apt-get refused some of them; trying each group of packages by itself")
        for group in groups:
            failure = _install(apt_get, [package for package in available if package in group])
            if failure:
                say(f"apt-get install failed{failure}")
    elif failure:
        say(f"apt-get install failed{failure}")


def _apt_get() -> Optional[List[str]]:
    if os.geteuid() == 0:
        return ["apt-get"]
    return ["sudo", "-n", "apt-get"] if run(["sudo", "-n", "true"]).returncode == 0 else None


def _with_candidate(packages: Sequence[str]) -> List[str]:
    candidates = {}
    for line in run(["apt-cache", "policy", *packages]).stdout.splitlines():
        if not line.startswith(" "):
            package = line.rstrip(":")
        elif line.startswith("  Candidate:"):
            candidates[package] = line.split()[1]
    return [package for package in packages if candidates.get(package, "(none)") != "(none)"]


def _install(apt_get: Sequence[str], packages: Sequence[str]) -> str:
    if not packages:
        return ""
    program = [*apt_get[:-1], "env", "DEBIAN_FRONTEND=noninteractive", apt_get[-1]]
    options = ["-qq", "-y", "--no-install-recommends", "-o", "DPkg::Lock::Timeout=600", "-o", "Dpkg::Use-Pty=0"]
    process = run([*program, *options, "install", *packages])
    return tail(process) or "\n    no message" if process.returncode else ""
