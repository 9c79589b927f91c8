"""Parameters of robots on a parameter server: where they stand, and what they give."""

from __future__ import annotations

from typing import Any, Callable, Dict, Mapping, Optional

from rqt_mrta_py.app.doctor.launch_text import active_nodes, resolved_path
from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.source import Source, find_source
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.parameters.layers import Layer, value_layer
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.text import parse_xml
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import ArchitectureSpec

__all__ = ["ParameterPlaces", "served_layers"]

_ROBOT = "$(arg robot_id)"
_SUFFIX = "_params"


class ParameterPlaces:
    """Where the parameters of an architecture's robots stand on a parameter server.

    They stand where the architecture's own launch file for a robot loads them (``rosparam`` with a namespace that
    names the robot), else in a namespace of the robot that is named like the architecture's config for robots without
    ``_params``: ``/robot1/demir_cf``.

    Args:
        registry: what is registered.
        architecture: a registered name, a package's folder, or an rqt_mrta.xml.

    Raises:
        DiscoveryError: the architecture is not registered, and no file either.
        ConfigError: its file is not acceptable.
    """

    def __init__(self, registry: Registry, architecture: str) -> None:
        source = find_source(registry, architecture, RegistrationKind.ARCHITECTURE)
        spec = read_architecture(read_file(source.file), str(source.file), source.package)
        config = spec.robot_config_id or ""
        short = config[: -len(_SUFFIX)] if config.endswith(_SUFFIX) else config
        self._pattern = _loaded_into(spec, source) or (f"{_ROBOT}/{short}" if short else "")

    def of(self, robot: str) -> str:
        """Give the namespace of a robot's parameters; empty where the architecture has none."""
        return f"/{self._pattern.replace(_ROBOT, robot).strip('/')}" if self._pattern else ""


def served_layers(robots: Mapping[str, str], get: Callable[[str], Mapping[str, Any]]) -> Dict[str, Layer]:
    """Ask for the parameters of robots.

    Args:
        robots: for whom, by id, with the namespace to look into; an empty one is not looked into.
        get: gives all parameters of a namespace, nested.

    Returns:
        What there is, by robot.
    """
    found: Dict[str, Layer] = {}
    for robot, namespace in robots.items():
        values = get(namespace) if namespace else {}
        if values:
            found[robot] = value_layer(values, f"parameter server {namespace}")
    return found


def _loaded_into(spec: ArchitectureSpec, source: Source) -> Optional[str]:
    """Find out where the launch file for a robot loads parameters; None if there is none that tells."""
    packages = {source.package: source.file.parent}
    for launch in spec.launches:
        for include in launch.includes if launch.id == spec.robot_launch_id else ():
            found = resolved_path(include.file, source.file.parent, packages)
            if found is None or not found[0].is_file():
                continue
            try:
                root = parse_xml(found[0].read_bytes(), str(found[0]))
            except ConfigError:
                continue
            for node in active_nodes(root):
                namespace = node.get("ns") or ""
                if node.tag == "rosparam" and _ROBOT in namespace:
                    return namespace
    return None
