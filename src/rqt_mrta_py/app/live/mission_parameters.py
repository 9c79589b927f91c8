"""Which mission a node takes part in, by its private parameters; what is of a wrong type is refused."""

from __future__ import annotations

import math
from typing import Any, Callable, List, Mapping, Optional, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.live.served_parameters import ParameterPlaces, served_layers
from rqt_mrta_py.app.live.world_turns import refuse_radio
from rqt_mrta_py.app.run.choice import MissionChoice, chosen_mission
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import MapKnowledge, Mission
from rqt_mrta_py.wording import shown

__all__ = ["StrictReader", "live_mission", "mission_choice"]

_TRUTHS = {"true": True, "1": True, "false": False, "0": False}


class StrictReader:
    """Reads private parameters; an empty text counts as not given, as launch files write it.

    Args:
        parameter: gives a parameter by its resolved name, or a default.
        resolve: gives the resolved name of a private one.
    """

    def __init__(self, parameter: Callable[[str, Any], Any], resolve: Callable[[str], str]) -> None:
        self._parameter = parameter
        self._resolve = resolve
        self._problems: List[Problem] = []

    def text(self, name: str) -> Optional[str]:
        """Read a text; None if it is not given. Numbers are taken as their text, for ``_robot:=1`` means a name."""
        value = self._given(name)
        if value is None or isinstance(value, str):
            return value
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            return str(value)
        self._refuse(name, value, "a text")
        return None

    def texts(self, name: str) -> Tuple[str, ...]:
        """Read texts: a list, or one text with blanks or commas between."""
        value = self._given(name)
        if isinstance(value, str):
            return tuple(value.replace(",", " ").split())
        if value is None or (isinstance(value, list) and all(isinstance(each, str) for each in value)):
            return tuple(value or ())
        self._refuse(name, value, "a text, or a list of texts")
        return ()

    def whole(self, name: str, least: int = 0) -> Optional[int]:
        """Read a whole number; None if it is not given."""
        value = self._given(name)
        if value is None or (isinstance(value, int) and not isinstance(value, bool) and value >= least):
            return value
        self._refuse(name, value, f"a whole number from {least}")
        return None

    def number(self, name: str) -> Optional[float]:
        """Read a number of at least 0; None if it is not given."""
        value = self._given(name)
        if value is None:
            return None
        if isinstance(value, (int, float)) and not isinstance(value, bool) and 0 <= value < math.inf:
            return float(value)
        self._refuse(name, value, "a finite number of at least 0")
        return None

    def truth(self, name: str, default: bool) -> bool:
        """Read true or false."""
        value = self._given(name)
        if value is None or isinstance(value, bool):
            return default if value is None else value
        if str(value).lower() in _TRUTHS:
            return _TRUTHS[str(value).lower()]
        self._refuse(name, value, "true or false")
        return default

    def one_of(self, name: str, accepted: Tuple[str, ...]) -> Optional[str]:
        """Read one of some texts; None if it is not given."""
        value = self._given(name)
        if value is not None and value not in accepted:
            self._refuse(name, value, " or ".join(accepted))
            return None
        return None if value is None else str(value)

    def require(self, name: str, value: Optional[str], what: str) -> str:
        """Insist on a text that was read.

        Args:
            name: of the parameter.
            value: of it.
            what: it is.
        """
        if value is None:
            self._problems.append(Problem("parameter", 0, self._resolve(f"~{name}"), f"is not set; give {what}"))
        return value or ""

    def check(self) -> None:
        """Refuse what was read, if anything of it is wrong.

        Raises:
            ConfigError: with everything that is wrong.
        """
        if self._problems:
            raise ConfigError(self._problems)

    def _given(self, name: str) -> Any:
        value = self._parameter(f"~{name}", None)
        return None if value == "" else value

    def _refuse(self, name: str, value: Any, accepted: str) -> None:
        element = self._resolve(f"~{name}")
        self._problems.append(Problem("parameter", 0, element, f"must be {accepted} (got {shown(value)})"))


def mission_choice(reader: StrictReader, application: str) -> MissionChoice:
    """Read which mission it is.

    Args:
        reader: of the node's private parameters.
        application: of the mission, read already.
    """
    knowledge = reader.one_of("map", tuple(each.value for each in MapKnowledge))
    return MissionChoice(
        application,
        reader.text("architecture"),
        reader.whole("seed") or 0,
        reader.whole("robots", least=1),
        reader.text("world"),
        None if knowledge is None else MapKnowledge(knowledge),
        reader.texts("settings"),
    )


def live_mission(
    get: Callable[[str], Mapping[str, Any]], host: Host, choice: MissionChoice, parameters: Optional[str] = None
) -> Mission:
    """Load a mission, with what the parameter server gives of its robots.

    Args:
        get: gives all parameters of a namespace, nested.
        host: registry and plugins.
        choice: of the mission.
        parameters: namespace of the parameters below each robot's; None: where the architecture has them.

    Raises:
        MrtaError: of whatever is wrong.
    """
    mission, _ = chosen_mission(host, choice)
    robots = [robot.id for robot in mission.application.robots]
    if parameters is None:
        places = ParameterPlaces(host.registry, choice.architecture or mission.architecture.package)
        names = {robot: places.of(robot) for robot in robots}
    else:
        names = {robot: f"/{robot}/{parameters.strip('/')}" for robot in robots}
    found = served_layers(names, get)
    if found:
        mission, _ = chosen_mission(host, choice, served=found)
    refuse_radio(mission)
    return mission
