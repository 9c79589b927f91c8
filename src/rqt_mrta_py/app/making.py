"""From what the user sets to an application's tasks and scenario, by the maker that its package registers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.guard import guarded
from rqt_mrta_py.app.selection import check_number
from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.discovery.source import find_source
from rqt_mrta_py.config.loading import MissionFiles, Rewriting
from rqt_mrta_py.errors import ConfigError, HookError, Problem
from rqt_mrta_py.hooks import MadeMission, MissionMaker, MissionRequest
from rqt_mrta_py.model import ApplicationSpec
from rqt_mrta_py.wording import nearest, shown

__all__ = ["HOOK", "Making", "making_of", "part_settings", "refuse_unknown"]

HOOK = "mrta_register_mission_makers"


@dataclass(frozen=True)
class Making:
    """What becomes of an application's files.

    Attributes:
        overrides: of parameters; what was left of what the user sets.
        robots: how many take part; None for all.
        rewrite: makes tasks and scenario; None: files are read as they are.
    """

    overrides: Tuple[str, ...]
    robots: Optional[int]
    rewrite: Optional[Rewriting] = None


class Parted(NamedTuple):
    """What the user sets: settings of the maker by name, in the order in which they were given, and all else."""

    given: Dict[str, str]
    rest: List[str]


def part_settings(maker: Optional[MissionMaker], settings: Sequence[str]) -> Parted:
    """Part settings of a maker from what is set besides.

    Args:
        maker: None if the application has none.
        settings: each ``name=value``; of one name the last counts.
    """
    names = () if maker is None else tuple(setting.name for setting in maker.settings)
    parted = Parted({}, [])
    for each in settings:
        name, equals, value = each.partition("=")
        if equals and name.strip() in names:
            parted.given[name.strip()] = value.strip()
        else:
            parted.rest.append(each)
    return parted


def refuse_unknown(maker: Optional[MissionMaker], application: str, rest: Sequence[str]) -> None:
    """Refuse what is neither a setting of the maker nor has the form of a robot's parameter.

    Args:
        maker: None if the application has none; then nothing is refused here.
        application: its package.
        rest: what is no setting.

    Raises:
        ConfigError: names each, and what is accepted.
    """
    problems = []
    for each in rest if maker is not None else ():
        name = each.partition("=")[0].strip()
        if maker is not None and "/" not in name:
            names = [setting.name for setting in maker.settings]
            near = nearest(name, names)
            meant = "" if near is None or near == name else f"nearest is {near!r}; "
            message = (
                f"is no setting of {application}; {meant}accepted are {', '.join(f'{known}=...' for known in names)} "
                "and <robot>/<parameter>=<value>"
            )
            problems.append(Problem("--set", 0, each, message))
    if problems:
        raise ConfigError(problems)


def making_of(
    host: Host, application: str, settings: Sequence[str], robots: Optional[int], strict: bool = True
) -> Making:
    """Find out whether an application's files are read as they are.

    Args:
        host: registry and plugins.
        application: a registered name, or the path of a package or rqt_mrta.xml.
        settings: what the user sets: settings of the application's maker, and parameters.
        robots: how many shall take part; None if nobody says.
        strict: refuse what is neither a setting nor has the form of a robot's parameter.

    Raises:
        DiscoveryError: there is no such application.
        ConfigError: it cannot be told what the application is, or there is no such setting.
        HookError: a plugin failed when it was asked for its makers.
    """
    makers = host.manager.registered(HOOK)
    package = find_source(host.registry, application, RegistrationKind.APPLICATION).package
    maker: Optional[MissionMaker] = makers.get(package)
    given, rest = part_settings(maker, settings)
    if maker is None:
        return Making(tuple(rest), robots)
    if strict:
        refuse_unknown(maker, package, rest)
    if not given and robots in (None, maker.robots):
        return Making(tuple(rest), maker.robots)
    if not given and maker.robots is None:
        return Making(tuple(rest), robots)
    wanted = maker.robots if robots is None else robots
    return Making(tuple(rest), wanted, _rewriting(host, maker, given, wanted))


def _rewriting(host: Host, maker: MissionMaker, given: Dict[str, str], robots: Optional[int]) -> Rewriting:
    # What follows from --robots alone is named by that.
    parts = [f"{name}={value}" for name, value in given.items()] or [f"--robots {robots}"]
    label = f"made of {', '.join(parts)}"

    def rewrite(spec: ApplicationSpec, files: MissionFiles) -> MissionFiles:
        check_number(spec, robots)
        request = MissionRequest(
            settings={setting.name: given.get(setting.name, setting.default) for setting in maker.settings},
            given=frozenset(given),
            robots=tuple(robot.id for robot in spec.robots),
            team=tuple(robot.id for robot in spec.robots[:robots]),
            tasks_yaml=files.tasks or "",
            scenario_yaml=files.scenario or "",
            registered=host.manager.registered,
        )
        made = _made(host, maker, spec.package, request)
        return MissionFiles(made.tasks_yaml, made.scenario_yaml, f"tasks.yaml {label}", f"scenario.yaml {label}")

    return rewrite


def _made(host: Host, maker: MissionMaker, package: str, request: MissionRequest) -> MadeMission:
    """Ask the maker, once in each command: planning may take long, and a mission is loaded more than once."""
    key = (package, tuple(request.settings.items()), request.team, request.tasks_yaml, request.scenario_yaml)
    if key not in host.made:
        who = f"mission maker {package}"
        with host.manager.patience.limit(who):
            made = guarded(who, maker.make, request)
        texts = tuple(made) if isinstance(made, MadeMission) else ()
        if not texts or not all(isinstance(text, str) for text in texts):
            raise HookError(f"{who}: made {shown(made)}; a MadeMission of two texts is needed")
        host.made[key] = made
    return host.made[key]
