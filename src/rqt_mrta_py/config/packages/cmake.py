"""The CMakeLists.txt of a new package, which installs whatever the package consists of."""

from __future__ import annotations

from typing import Iterable

__all__ = ["cmake_text"]


def cmake_text(package: str, files: Iterable[str], folders: Iterable[str] = (), python: bool = False) -> str:
    """Write a CMakeLists.txt for catkin.

    Args:
        package: its name.
        files: to be installed beside the manifest.
        folders: likewise.
        python: True if it brings Python modules by a setup.py, and registers one of them as a plugin.

    Returns:
        The whole file, sound by catkin_lint's strict rules.
    """
    share = "${CATKIN_PACKAGE_SHARE_DESTINATION}"
    lines = ["cmake_minimum_required(VERSION 3.5)", f"project({package})", ""]
    if python:
        lines += ["# A plugin of rqt_mrta_py is a module, no file of pluginlib."]
        lines += ["#catkin_lint: ignore plugin_export_prefix", ""]
    lines += ["find_package(catkin REQUIRED)", *(["catkin_python_setup()"] if python else []), "catkin_package()", ""]
    lines.append(f"install(FILES {' '.join(sorted(files))} DESTINATION {share})")
    listed = sorted(folders)
    if listed:
        lines.append(f"install(DIRECTORY {' '.join(listed)} DESTINATION {share})")
    return "\n".join([*lines, ""])
