"""Finding a file by what the user calls it."""

from __future__ import annotations

from pathlib import Path
from typing import Callable

import pytest

from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.source import Source, find_source
from rqt_mrta_py.errors import DiscoveryError

Write = Callable[[str, str], Path]

ARCHITECTURE = RegistrationKind.ARCHITECTURE
MANIFEST = (
    '<package><name>called</name><depend>rqt_mrta</depend><export><rqt_mrta architecture="a.xml"/></export></package>'
)


def test_source_of_a_package_is_what_its_manifest_exports(write: Write) -> None:
    exported, other = write("p/a.xml", "<a/>"), write("p/b.xml", "<b/>")
    folder = write("p/package.xml", MANIFEST).parent

    assert find_source(Registry(), str(folder), ARCHITECTURE) == Source("called", exported)
    assert find_source(Registry(), str(exported), ARCHITECTURE) == Source("called", exported)
    assert find_source(Registry(), str(other), ARCHITECTURE) == Source("called", other)


def test_source_of_a_folder_without_manifest_is_its_file(write: Write) -> None:
    file = write("plain/rqt_mrta.xml", "<a/>")

    assert find_source(Registry(), str(file.parent), ARCHITECTURE) == Source("plain", file)


def test_source_that_is_in_no_package_is_called_by_its_own_name(write: Write) -> None:
    """It was once called as its folder, whatever that was."""
    file = write("downloads/yard.xml", "<a/>")

    assert find_source(Registry(), str(file), ARCHITECTURE) == Source("yard", file)
    usual = write("yard_watch/rqt_mrta.xml", "<a/>")
    assert find_source(Registry(), str(usual), ARCHITECTURE) == Source("yard_watch", usual)


def test_source_of_a_folder_that_holds_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(DiscoveryError) as caught:
        find_source(Registry(), str(tmp_path), ARCHITECTURE)

    assert str(caught.value) == f"{tmp_path}: holds neither package.xml nor rqt_mrta.xml"


def test_source_of_a_name_longer_than_names_of_files_is_refused_by_itself(tmp_path: Path) -> None:
    name = "a" * 300
    with pytest.raises(DiscoveryError, match=r"^a{300}: no architecture of this name is registered"):
        find_source(Registry(), name, ARCHITECTURE)
    with pytest.raises(DiscoveryError, match=r"a{300}: there is no such file or folder"):
        find_source(Registry(), f"{tmp_path}/{name}", ARCHITECTURE)


def test_source_of_a_package_that_registers_something_else_is_refused(write: Write) -> None:
    write("p/a.xml", "<a/>")
    folder = write("p/package.xml", MANIFEST).parent

    with pytest.raises(DiscoveryError) as caught:
        find_source(Registry(), str(folder), RegistrationKind.APPLICATION)

    assert str(caught.value) == f"{folder}: its package.xml registers no application; name the rqt_mrta.xml itself"
