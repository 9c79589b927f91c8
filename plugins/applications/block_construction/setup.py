"""Lets catkin put the package's Python modules on the path."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

packages = [
    "block_construction",
    "block_construction.building",
    "block_construction.diagram",
    "block_construction.exact",
    "block_construction.execution",
    "block_construction.experiments",
    "block_construction.learning",
    "block_construction.mission",
    "block_construction.pictures",
    "block_construction.structure",
    "block_construction.team",
    "block_construction.verbs",
]
setup(**generate_distutils_setup(packages=packages, package_dir={"": "src"}))
