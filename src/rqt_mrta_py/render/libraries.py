"""The doors to the drawing libraries: imported when first needed, with an error that says what to install."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType
from typing import Any

from rqt_mrta_py.errors import MissingDependencyError

__all__ = ["matplotlib", "opencv", "pillow", "require"]


def require(module: str, package: str, purpose: str) -> ModuleType:
    """Import a library that only pictures need.

    Args:
        module: its import name.
        package: its name and bounds for pip.
        purpose: what needs it, as the beginning of a sentence.

    Returns:
        The module.

    Raises:
        MissingDependencyError: it is not installed, or does not load; says what to install.
    """
    try:
        return import_module(module)
    except ImportError as error:
        raise MissingDependencyError(
            f"{purpose}: the Python library {module!r} cannot be imported ({error}); "
            f"install {package!r}, or rqt_mrta_py with its extra [plot]"
        ) from error


def opencv() -> Any:
    """Give OpenCV.

    Raises:
        MissingDependencyError: it is not installed.
    """
    return require("cv2", "opencv-python-headless>=4.6,<6", "drawing and encoding pictures")


def pillow(module: str) -> Any:
    """Give one of Pillow's modules, for instance ``ImageFont``.

    Raises:
        MissingDependencyError: it is not installed.
    """
    return require(f"PIL.{module}", "pillow>=9.4", "writing on pictures")


def matplotlib(module: str) -> Any:
    """Give one of matplotlib's modules, for instance ``figure``.

    Raises:
        MissingDependencyError: it is not installed.
    """
    return require(f"matplotlib.{module}", "matplotlib>=3.6,<4", "drawing the dashboard")
