"""Which versions of the libraries that shape a result are installed."""

from __future__ import annotations

from importlib import metadata
from typing import Dict

__all__ = ["installed_versions"]

_LIBRARIES = (
    "lxml",
    "matplotlib",
    "numpy",
    "opencv-python-headless",
    "pluggy",
    "pybullet",
    "PyYAML",
    "rosbags",
    "scipy",
)


def installed_versions() -> Dict[str, str]:
    """Look up the version of each library, ``missing`` where it is not installed, in a fixed order."""
    versions = {}
    for name in _LIBRARIES:
        try:
            versions[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            versions[name] = "missing"
    return versions
