"""Packaging for pip and for catkin alike; it must not import catkin_pkg, which a plain pip build does not have."""

from __future__ import annotations

import os
import re
from pathlib import Path, PurePosixPath
from typing import Dict, List, Sequence, Tuple

from setuptools import find_packages, setup

HERE = Path(__file__).resolve().parent

# Lower bounds: what Debian 12 carries or Python 3.8 can install. Upper bounds: the next major version.
EXTRAS = {
    "bag": ["rosbags>=0.9.20,<0.12", "lz4>=4.0,<5"],
    "plot": ["opencv-python-headless>=4.6,<6", "matplotlib>=3.6,<4", "pillow>=9.4,<14"],
    "sim": ["pybullet>=3.2.5,<4", "scipy>=1.10,<2"],
    "terminal": ["rich>=13,<16"],
}
EXTRAS["all"] = [requirement for name in sorted(EXTRAS) for requirement in EXTRAS[name]]
# Large, and wanted by few: decisions of thousands of robots, compiled (the last version for Python 3.8 is 0.58), and
# what proves assembly diagrams and routes of the multiple travelling robot problem.
EXTRAS["compiled"] = ["numba>=0.56,<1"]
EXTRAS["exact"] = ["ortools>=9.10,<10"]
EXTRAS["references"] = [*EXTRAS["exact"], "pyvrp>=0.14,<0.15; python_version >= '3.11'"]
# Formats of other programs: MCAP files, Parquet tables.
EXTRAS["mcap"] = ["mcap>=1.1,<2"]
EXTRAS["parquet"] = ["pyarrow>=12,<30"]
EXTRAS["test"] = [
    *EXTRAS["compiled"],
    *EXTRAS["mcap"],
    *EXTRAS["parquet"],
    *EXTRAS["references"],
    # An independent decoder of the ROS messages in MCAP files.
    "mcap-ros1-support>=0.7,<1",
    "pytest>=8,<10",
    "hypothesis>=6.100,<7",
    # An independent reader of the JSON Schemas that come with the package.
    "jsonschema>=4.17,<5",
    "pytest-cov>=5,<8",
    # ./test lets a process for each processor share the tests.
    "pytest-xdist>=3.5,<4",
    # ruff's formatter may change its mind with every minor version, and its verdict is law here.
    "ruff>=0.17,<0.18",
    "mypy>=1.14,<2",
    "types-PyYAML>=6,<7",
    "types-setuptools>=75,<100",
    "lxml-stubs>=0.5,<1",
    # What ROS's own libraries find and accept is held against ours.
    "catkin_pkg>=0.5.2,<2",
    "rospkg>=1.4,<2",
    # Tests build the wheel, from what is installed.
    "packaging>=21",
    "setuptools>=64",
    "wheel>=0.38",
]


def ros_files() -> List[Tuple[str, Sequence[str]]]:
    """List what a ROS package has outside of its Python modules, for this package and for those under plugins.

    Returns:
        Folders below the installation's prefix as REP-122 wants them, each with its files.
    """
    share = "share/rqt_mrta_py"
    # rosrun looks below lib in a catkin workspace, below share where ROS_PACKAGE_PATH names that folder.
    placed = [(share, HERE / "package.xml"), *_below("lib/rqt_mrta_py", HERE / "scripts")]
    for folder in ("scripts", "config", "msg", "srv", "launch_xml"):
        placed += _below(f"{share}/{folder}", HERE / folder)
    for manifest in (HERE / "plugins").glob("*/*/package.xml"):
        package = manifest.parent
        # A stub must not stand beside a real package of its name: it is found last, from a folder of its own.
        parent = f"{share}/stubs" if package.parent.name == "stubs" else "share"
        placed += _below(f"{parent}/{package.name}", package)
    folders: Dict[str, List[str]] = {}
    for target, path in sorted(placed):
        folders.setdefault(target, []).append(path.relative_to(HERE).as_posix())
    return [(target, files) for target, files in sorted(folders.items())]


def _below(target: str, folder: Path) -> List[Tuple[str, Path]]:
    """Place all files below a folder, but for what Python and its tools leave there."""
    files = [path for path in folder.rglob("*") if path.is_file()]
    kept = [path for path in files if not re.search(r"/__pycache__/|\.egg-info/", path.as_posix())]
    return [((PurePosixPath(target) / path.relative_to(folder)).parent.as_posix(), path) for path in kept]


setup(
    name="rqt_mrta_py",
    version="0.1.0",
    description="A supervisor, without a desktop, for teams of robots that share out tasks among themselves",
    long_description=(HERE / "README.md").read_text(encoding="utf-8"),
    long_description_content_type="text/markdown",
    license="Apache-2.0",
    license_files=["LICENSE"],
    maintainer="rqt_mrta_py maintainers",
    maintainer_email="maintainers@rqt-mrta-py.example",
    keywords=["robotics", "multi-robot", "task allocation", "MRTA", "ROS", "ALLIANCE", "simulation"],
    classifiers=[
        "Development Status :: 3 - Alpha",
        "Environment :: Console",
        "Intended Audience :: Science/Research",
        "Operating System :: POSIX :: Linux",
        "Programming Language :: Python :: 3",
        "Programming Language :: Python :: 3.8",
        "Programming Language :: Python :: 3.11",
        "Topic :: Scientific/Engineering",
        "Topic :: System :: Distributed Computing",
        "Typing :: Typed",
    ],
    python_requires=">=3.8",
    package_dir={"": "src"},
    packages=find_packages("src"),
    package_data={
        "rqt_mrta_py": [
            "py.typed",
            "config/schema/*.rng",
            "config/schema/*.json",
            "config/packages/skeleton/*.in",
            "render/report/assets/*",
        ]
    },
    # Under catkin CMakeLists.txt installs these.
    data_files=[] if "CATKIN_BINARY_DIR" in os.environ else ros_files(),
    install_requires=[
        "PyYAML>=6.0,<7",
        "lxml>=4.9,<7",
        "numpy>=1.24,<3",
        "pluggy>=1.0,<2",
    ],
    extras_require=EXTRAS,
    entry_points={"console_scripts": ["mrta = rqt_mrta_py.app.cli.main:main"]},
)
