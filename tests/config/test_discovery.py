"""Discovery, held against rospkg where the two must agree."""

from __future__ import annotations

import sys
from importlib import metadata
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence

import pytest

from rqt_mrta_py.config.discovery import search as search_module
from rqt_mrta_py.config.discovery.manifest import Manifest, parse_manifest
from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.search import discover, own_packages
from rqt_mrta_py.errors import DiscoveryError

Write = Callable[[str, str], Path]


@pytest.fixture
def package(write: Write) -> Callable[..., Path]:
    """Write a package; with an export it is an application of that file."""

    def make(folder: str, name: Optional[str] = None, application: bool = False, plugin: str = "") -> Path:
        tag = '<rqt_mrta_py application="${prefix}/rqt_mrta.xml"/>' if application else ""
        tag += f'<rqt_mrta_py plugin="{plugin}"/>' if plugin else ""
        depend = "<depend>rqt_mrta_py</depend>" if tag else ""
        text = f"<package><!-- <name>no</name> --><name>{name or Path(folder).name}</name>{depend}"
        write(f"{folder}/rqt_mrta.xml", "<rqt_mrta/>")
        return write(f"{folder}/package.xml", f"{text}<export>{tag}</export></package>").parent

    return make


def search(
    ros: Sequence[Path] = (),
    cmake: Sequence[Path] = (),
    prefix: str = "/nowhere",
    own: Sequence[Path] = (),
    **rest: Any,
) -> Registry:
    environ: Dict[str, str] = {
        "ROS_PACKAGE_PATH": ":".join(map(str, ros)),
        "CMAKE_PREFIX_PATH": ":".join(map(str, cmake)),
    }
    return discover(environ, prefix, own, **{"shares": (), "distributions": (), **rest})


def names(registry: Registry, kind: RegistrationKind = RegistrationKind.APPLICATION) -> List[str]:
    return [registration.package for registration in registry.of_kind(kind)]


def test_discovery_reads_a_manifest_whose_encoding_hides_that_it_mentions_us(
    tmp_path: Path, package: Callable[..., Path]
) -> None:
    manifest = package("ros/wide", application=True) / "package.xml"
    manifest.write_bytes(manifest.read_text(encoding="utf-8").encode("utf-16"))

    assert names(search([tmp_path / "ros"])) == ["wide"]


def test_discovery_searches_in_the_documented_order_and_the_first_name_wins(
    tmp_path: Path, package: Callable[..., Path]
) -> None:
    places = ["ros", "cmake/share", "debian", "prefix/share", "own"]
    for index, place in enumerate(places):
        package(f"{place}/only_{index}", application=True)
        for other in places[: index + 1]:
            package(f"{place}/from_{other.split('/')[0]}", application=True)

    registry = search(
        [tmp_path / "ros"],
        [tmp_path / "cmake"],
        str(tmp_path / "prefix"),
        [tmp_path / "own"],
        shares=[tmp_path / "debian"],
    )

    assert names(registry) == [
        "from_ros",
        "only_0",
        "from_cmake",
        "only_1",
        "from_debian",
        "only_2",
        "from_prefix",
        "only_3",
        "from_own",
        "only_4",
    ]
    assert registry.packages["from_ros"] == tmp_path / "ros" / "from_ros"


def test_discovery_descends_as_rospkg_does(tmp_path: Path, package: Callable[..., Path], write: Write) -> None:
    rospkg = pytest.importorskip("rospkg")
    package("src/b")
    package("src/group/deep/a")
    package("src/b/nested_in_a_package")
    package("src/ignored/c")
    write("src/ignored/CATKIN_IGNORE", "")
    package("src/.hidden/d")
    package("src/stopped/below/e")
    write("src/stopped/rospack_nosubdirs", "")
    package("src/ignored_package")
    write("src/ignored_package/CATKIN_IGNORE", "")
    (tmp_path / "src" / "group" / "loop").symlink_to(tmp_path / "src")
    package("elsewhere/linked")
    (tmp_path / "src" / "link").symlink_to(tmp_path / "elsewhere")

    registry = search([tmp_path / "src"])

    assert list(registry.packages) == ["b", "a", "linked"]
    assert sorted(registry.packages) == sorted(rospkg.RosPack([str(tmp_path / "src")]).list())


def test_discovery_takes_the_name_of_the_manifest_and_not_of_the_folder(package: Callable[..., Path]) -> None:
    folder = package("src/folder", name="called", application=True)

    assert search([folder.parent]).packages == {"called": folder}


def test_discovery_looks_one_level_deep_into_share_folders(tmp_path: Path, package: Callable[..., Path]) -> None:
    package("share/seen")
    package("share/group/unseen")

    assert list(search(prefix=str(tmp_path)).packages) == ["seen"]


def test_discovery_does_not_descend_into_a_share_folder_on_the_package_path(
    tmp_path: Path, package: Callable[..., Path]
) -> None:
    package("usr/share/seen")
    package("usr/share/doc/unseen")

    assert list(search([tmp_path / "usr" / "share"]).packages) == ["seen"]


def test_discovery_reports_a_broken_manifest_and_goes_on(
    tmp_path: Path, package: Callable[..., Path], write: Write
) -> None:
    package("src/a", application=True)
    broken = write("src/b/package.xml", "<package>\n<name>b</name><depend>rqt_mrta</depend>")
    package("src/c", application=True)

    registry = search([tmp_path / "src"])

    assert names(registry) == ["a", "c"]
    assert [str(problem) for problem in registry.problems] == [
        f"{broken}:2: is not well-formed XML: Premature end of data in tag package line 1"
    ]


def test_discovery_passes_over_folders_that_do_not_exist(tmp_path: Path) -> None:
    assert search([tmp_path / "gone"], [tmp_path / "gone"], own=[tmp_path / "gone"]).packages == {}


def test_discovery_makes_relative_folders_absolute(
    tmp_path: Path, package: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = package("src/p", application=True)
    monkeypatch.chdir(tmp_path)

    assert search([Path("src")]).find("p").folder == folder


def test_discovery_finds_the_packages_of_this_checkout_through_the_same_search(root: Path) -> None:
    registry = discover({}, prefix="/nowhere", shares=(), distributions=())

    assert own_packages() == (root, root / "plugins")
    assert registry.packages["rqt_mrta_py"] == root
    assert "border_patrol" in names(registry)
    assert "mrta_alliance" in names(registry, RegistrationKind.ARCHITECTURE)
    assert registry.problems == ()


def test_discovery_searches_what_came_with_another_copy_of_this_project_last(
    tmp_path: Path, package: Callable[..., Path]
) -> None:
    """A checkout must not run the plugins that a wheel of it once left in the same environment."""
    package("prefix/share/rqt_mrta_py")
    package("prefix/share/border_patrol", application=True)
    package("prefix/share/only_there", application=True)
    own = package("own/border_patrol", application=True)

    registry = search(prefix=str(tmp_path / "prefix"), own=[tmp_path / "own"])

    assert registry.find("border_patrol").folder == own
    assert names(registry) == ["border_patrol", "only_there"]


def test_discovery_of_an_installation_keeps_to_the_documented_order(
    tmp_path: Path, package: Callable[..., Path]
) -> None:
    share = package("prefix/share/rqt_mrta_py").parent
    package("prefix/share/only_installed", application=True)
    stubs = package("prefix/share/rqt_mrta_py/stubs/rqt_mrta", application=True).parent
    package("prefix/share/group/nested", application=True)

    registry = search(prefix=str(tmp_path / "prefix"), own=[share.resolve(), stubs.resolve()])

    # Share folders are flat; the stubs lie below one, where nobody meets them by chance.
    assert names(registry) == ["only_installed", "rqt_mrta"]


def test_discovery_lets_a_package_of_the_user_stand_before_ours(package: Callable[..., Path]) -> None:
    folder = package("src/border_patrol", application=True)

    registry = discover({"ROS_PACKAGE_PATH": str(folder.parent)}, prefix="/nowhere", shares=(), distributions=())

    assert registry.find("border_patrol").folder == folder


@pytest.fixture
def distribution(write: Write) -> Callable[[str, str], Path]:
    """Write an installed distribution with entry points; give the folder that it lies in."""

    def make(name: str, entry_points: str) -> Path:
        info = f"site/{name}-1.0.dist-info"
        write(f"{info}/METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
        return write(f"{info}/entry_points.txt", entry_points).parent.parent

    return make


def test_discovery_takes_entry_points_as_plugins_by_name(
    package: Callable[..., Path], distribution: Callable[[str, str], Path]
) -> None:
    folder = package("src/p", plugin="p.plugin")
    distribution("yard", "[rqt_mrta_py]\nsecond = yard.more:Plugin\nfirst = yard.plugin\n[console_scripts]\ny = y:y\n")
    site = distribution("alley", "[rqt_mrta_py]\na = alley.plugin\nalready = p.plugin\n")

    registry = search([folder.parent], distributions=metadata.distributions(path=[str(site), str(site)]))

    plugins = registry.of_kind(RegistrationKind.PLUGIN)
    assert [(entry.package, entry.plugin) for entry in plugins] == [
        ("p", "p.plugin"),
        ("alley", "alley.plugin"),
        ("yard", "yard.plugin"),
        ("yard", "yard.more:Plugin"),
    ]
    assert plugins[1].folder == site


def test_discovery_asks_the_installed_distributions(
    distribution: Callable[[str, str], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    site = distribution("yard", "[rqt_mrta_py]\nyard = yard.plugin\n")
    monkeypatch.setattr(sys, "path", [str(site)])

    assert [entry.plugin for entry in discover({}, "/nowhere", (), ()).registrations] == ["yard.plugin"]


def test_registry_finds_messages_of_any_package(package: Callable[..., Path], write: Write) -> None:
    folder = package("src/plain_msgs")
    path = write("src/plain_msgs/msg/Point.msg", "float64 x\n")

    registry = search([folder.parent])

    assert registry.message_file("plain_msgs/Point") == path
    for unknown in ("plain_msgs/Line", "other_msgs/Point", "Point", "", "plain_msgs/../Point", "plain_msgs/"):
        assert registry.message_file(unknown) is None


def test_registry_names_the_nearest_name_for_one_that_is_not_registered(package: Callable[..., Path]) -> None:
    folder = package("src/border_patrol", application=True)
    package("src/plain")
    registry = search([folder.parent])

    with pytest.raises(DiscoveryError) as misspelt:
        registry.find("boarder_patrol", RegistrationKind.APPLICATION)
    with pytest.raises(DiscoveryError) as plain:
        registry.find("plain", RegistrationKind.APPLICATION)
    with pytest.raises(DiscoveryError) as none:
        registry.find("x", RegistrationKind.ARCHITECTURE)

    assert str(misspelt.value) == (
        "boarder_patrol: no application of this name is registered; nearest is 'border_patrol'"
    )
    assert str(plain.value) == (
        f"plain: the package in {folder.parent / 'plain'} registers no application; its package.xml must depend on "
        "rqt_mrta_py and export <rqt_mrta_py application=.../>"
    )
    assert str(none.value) == (
        "x: no architecture of this name is registered; there is none; packages are found on ROS_PACKAGE_PATH, or by "
        "their folder"
    )


def test_manifests_of_foreign_packages_are_not_parsed(
    tmp_path: Path, package: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(3):
        package(f"share/foreign_{number}")
    package("share/ours", application=True)
    parsed: List[Path] = []

    def spy(raw: bytes, path: Path) -> Manifest:
        parsed.append(path)
        return parse_manifest(raw, path)

    monkeypatch.setattr(search_module, "parse_manifest", spy)

    registry = search(prefix=str(tmp_path))

    assert sorted(registry.packages) == ["foreign_0", "foreign_1", "foreign_2", "ours"]
    assert parsed == [tmp_path / "share" / "ours" / "package.xml"]


def test_what_a_service_is_asked_and_answers_is_found_as_a_type(tmp_path: Path) -> None:
    folder = tmp_path / "calls"
    (folder / "srv").mkdir(parents=True)
    (folder / "srv" / "Sum.srv").write_text("int32 a\nint32 b\n--- \nint32 sum\n")
    (folder / "srv" / "Torn.srv").write_text("int32 a\n")
    registry = Registry({"calls": folder})
    assert registry.message_text("calls/SumRequest") == "int32 a\nint32 b\n"
    assert registry.message_text("calls/SumResponse") == "int32 sum\n"
    assert registry.message_text("calls/Sum") is None
    assert registry.message_text("other/SumRequest") is None
    with pytest.raises(ValueError, match="has 0 lines '---'"):
        registry.message_text("calls/TornRequest")
