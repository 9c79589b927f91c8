"""What an application declares in its rqt_mrta.xml."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Tuple

from rqt_mrta_py.model.architecture import LaunchTemplate
from rqt_mrta_py.model.parameters import ConfigTemplate

__all__ = ["ApplicationRobot", "ApplicationSpec"]


@dataclass(frozen=True)
class ApplicationRobot:
    """A robot of the team and the tasks it may carry out.

    Attributes:
        id: normalised, without a leading slash.
        tasks: ids of its tasks, in file order.
    """

    id: str
    tasks: Tuple[str, ...] = ()


@dataclass(frozen=True)
class ApplicationSpec:
    """A team with its tasks, as registered.

    Attributes:
        package: the ROS package that registers it; its name for the command line.
        name: its name for people.
        architecture: package of its architecture; None if the file names none and the caller must.
        robots: the team, in file order.
        configs: the parameters filled in, one config per robot and global ones, in file order.
        launches: launch files, in file order.
    """

    package: str
    name: str
    architecture: Optional[str] = None
    robots: Tuple[ApplicationRobot, ...] = ()
    configs: Tuple[ConfigTemplate, ...] = ()
    launches: Tuple[LaunchTemplate, ...] = ()
