"""The node ``review``: reviews one bag, as its arguments or its private parameters say, and ends."""

from __future__ import annotations

import logging
import sys
from typing import Any, List, Mapping, Optional, Sequence

from rqt_mrta_py.app.cli.main import main as mrta
from rqt_mrta_py.app.cli.main import without_remappings
from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.nodes.frame import Ending, node_main
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["main", "options_of"]

_TEXTS = ("application", "architecture", "out", "pictures", "figures", "why", "fail_on")
_SWITCHES = ("video", "force", "json")


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Review a bag.

    Arguments are those of ``mrta review``. Without any, private parameters of their names say the same, with ``bag``
    for the bag: on the command line (``_bag:=FILE``), where no master is needed, or else on the parameter server.

    Args:
        argv: arguments without the program's name; None for the process's own.

    Returns:
        The exit status of ``mrta review``.
    """
    arguments: List[str] = list(sys.argv[1:] if argv is None else argv)
    plain = without_remappings(arguments)
    if plain:
        return mrta(["review", *plain])
    pairs = [argument.partition(":=") for argument in arguments]
    told = {name[1:]: value for name, _, value in pairs if name.startswith("_") and not name.startswith("__")}
    if "bag" not in told:
        asked: List[str] = []

        def ask(node: RosNode, _host: Host, _ending: Ending) -> None:
            asked.extend(options_of(node.parameters(node.name)))

        status = node_main("review", ask, arguments, level=logging.WARNING, await_master=False)
        return status or mrta(["review", *asked])
    return mrta(["review", *options_of(told)])


def options_of(parameters: Mapping[str, Any]) -> List[str]:
    """Turn private parameters into arguments of ``mrta review``; an empty text counts as not given."""
    arguments = [str(parameters["bag"])] if parameters.get("bag") else []
    for name in _TEXTS:
        value = parameters.get(name)
        if value not in (None, ""):
            arguments += [f"--{name.replace('_', '-')}", str(value)]
    arguments += [f"--{name}" for name in _SWITCHES if str(parameters.get(name, "")).lower() in ("true", "1")]
    return arguments
