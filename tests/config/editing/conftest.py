"""The application ``yard`` as a package that can be edited, beside two architectures."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable

import pytest

from rqt_mrta_py.config.discovery.registration import Registry
from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.editing.configuring import Configuration, plan_configuration
from tests.config.editing.yard import APPLICATION, ARCHITECTURE, FILES, MANIFEST, SCENARIO, TASKS

Plan = Callable[..., Configuration]


@pytest.fixture
def yard(tmp_path: Path) -> Path:
    """Write the application ``yard`` and the architectures ``home`` and ``away``."""
    for name in ("home", "away"):
        folder = tmp_path / "packages" / name
        folder.mkdir(parents=True)
        (folder / "package.xml").write_text(MANIFEST.format(name=name, export='architecture="${prefix}/rqt_mrta.xml"'))
        (folder / "rqt_mrta.xml").write_text(ARCHITECTURE.replace("{name}", name))
    folder = tmp_path / "packages" / "yard"
    folder.mkdir()
    (folder / "package.xml").write_text(MANIFEST.format(name="yard", export=FILES))
    for name, text in (("rqt_mrta.xml", APPLICATION), ("tasks.yaml", TASKS), ("scenario.yaml", SCENARIO)):
        (folder / name).write_text(text)
    return folder


@pytest.fixture
def registry(yard: Path) -> Registry:
    """Discover the packages beside ``yard``."""
    return discover({"ROS_PACKAGE_PATH": str(yard.parent)})


@pytest.fixture
def plan(registry: Registry) -> Plan:
    """Plan the configuration of ``yard`` after edits."""

    def make(*edits: Any, architecture: Any = None) -> Configuration:
        return plan_configuration(registry, "yard", architecture, edits)

    return make


@pytest.fixture
def configure(plan: Plan) -> Callable[..., Configuration]:
    """Carry the plan out, too."""

    def make(*edits: Any, architecture: Any = None) -> Configuration:
        made = plan(*edits, architecture=architecture)
        made.carry_out()
        return made

    return make
