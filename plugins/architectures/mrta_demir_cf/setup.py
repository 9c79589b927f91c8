"""Lets catkin put the package's Python modules on the path."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

packages = [
    "mrta_demir_cf",
    "mrta_demir_cf.experiments",
    "mrta_demir_cf.planning",
    "mrta_demir_cf.planning.kernels",
]
setup(**generate_distutils_setup(packages=packages, package_dir={"": "src"}))
