"""The one door to rosbags, which is imported when it is first needed."""

from __future__ import annotations

from functools import lru_cache
from types import ModuleType
from typing import Any, Optional

from rqt_mrta_py.errors import MissingDependencyError

__all__ = ["noetic_definition", "rosbag1"]

_REMEDY = "install it with: pip install 'rqt_mrta_py[bag]'"


def rosbag1() -> ModuleType:
    """Import rosbags' reader and writer of ROS 1 bags.

    Raises:
        MissingDependencyError: rosbags is not installed.
    """
    try:
        import rosbags.rosbag1 as module
    except ImportError as error:
        raise MissingDependencyError(f"bags need the library rosbags ({error}); {_REMEDY}") from error
    return module


def noetic_definition(type_name: str) -> Optional[str]:
    """Give the full text of a standard type.

    Args:
        type_name: ``pkg/Msg``.

    Returns:
        Full text of the definition; None where Noetic's standard packages have no such type.

    Raises:
        MissingDependencyError: rosbags is not installed.
    """
    package, _, message = type_name.partition("/")
    stored = f"{package}/msg/{message}"
    store = _noetic_store()
    # ROS 1 has no package builtin_interfaces: there, time and duration are primitives.
    if package == "builtin_interfaces" or stored not in store.types:
        return None
    text: str = store.generate_msgdef(stored)[0]
    return text


@lru_cache(maxsize=1)
def _noetic_store() -> Any:
    try:
        from rosbags.typesys import Stores, get_typestore
    except ImportError as error:
        raise MissingDependencyError(f"standard messages need the library rosbags ({error}); {_REMEDY}") from error
    return get_typestore(Stores.ROS1_NOETIC)
