"""Lets catkin put the package's Python modules on the path."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

packages = ["mtrp_allocators", "mtrp_allocators.experiments", "mtrp_allocators.references"]
setup(**generate_distutils_setup(packages=packages, package_dir={"": "src"}))
