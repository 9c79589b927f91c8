"""Lets catkin put the package's Python modules on the path."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(**generate_distutils_setup(packages=["parquet_tables"], package_dir={"": "src"}))
