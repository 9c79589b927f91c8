"""Packaging for pip and for catkin alike; it must not import catkin_pkg, which a plain pip build does not have."""

from __future__ import annotations

from setuptools import find_packages, setup

# Lower bounds: what Debian 12 carries or Python 3.8 can install. Upper bounds: the next major version.
EXTRAS = {
    "bag": ["rosbags>=0.9.20,<0.12", "lz4>=4.0,<5"],
    "plot": ["opencv-python-headless>=4.6,<6", "matplotlib>=3.6,<4", "pillow>=9.4,<14"],
    "sim": ["pybullet>=3.2.5,<4", "scipy>=1.10,<2"],
    "terminal": ["rich>=13,<16"],
}
EXTRAS["all"] = [requirement for name in sorted(EXTRAS) for requirement in EXTRAS[name]]
EXTRAS["test"] = [
    "pytest>=8,<10",
    "hypothesis>=6.100,<7",
    "pytest-cov>=5,<8",
    # ruff's formatter may change its mind with every minor version, and its verdict is law here.
    "ruff>=0.17,<0.18",
    "mypy>=1.14,<2",
    "types-PyYAML>=6,<7",
    "types-setuptools>=75,<100",
    "lxml-stubs>=0.5,<1",
]

setup(
    name="rqt_mrta_py",
    version="0.1.0",
    description="A supervisor, without a desktop, for teams of robots that share out tasks among themselves",
    license="Apache-2.0",
    maintainer="rqt_mrta_py maintainers",
    maintainer_email="maintainers@rqt-mrta-py.example",
    python_requires=">=3.8",
    package_dir={"": "src"},
    packages=find_packages("src"),
    install_requires=[
        "PyYAML>=6.0,<7",
        "catkin_pkg>=0.5.2,<2",
        "lxml>=4.9,<7",
        "numpy>=1.24,<3",
        "pluggy>=1.0,<2",
        "rospkg>=1.4,<2",
    ],
    extras_require=EXTRAS,
    entry_points={"console_scripts": ["mrta = rqt_mrta_py.app.cli.main:main"]},
)
