"""Manifests: who takes part, with what."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Callable, List, Tuple

import pytest

from rqt_mrta_py.config.discovery.manifest import Manifest, read_manifest
from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.errors import ConfigError

Write = Callable[[str, str], Path]

TAG = '<rqt_mrta architecture="${prefix}/a.xml"/>'


@pytest.fixture
def manifest(write: Write) -> Callable[..., Manifest]:
    """Write and read a package ``p`` whose exported files all exist."""

    def make(export: str, depend: str = "<depend>rqt_mrta</depend>", name: str = "p", form: int = 2) -> Manifest:
        for file in ("a.xml", "b.xml", "tasks.yaml", "scenario.yaml", "deep/c.xml"):
            write(f"{name}/{file}", "<rqt_mrta/>")
        text = f'<package format="{form}">\n<name>{name}</name>\n{depend}\n<export>\n{export}\n</export>\n</package>\n'
        return read_manifest(write(f"{name}/package.xml", text))

    return make


def messages(manifest: Manifest) -> List[str]:
    found = [*manifest.problems, *(problem for entry in manifest.registrations for problem in entry.problems)]
    return [f"{problem.line}: {problem.element}: {problem.message}" for problem in found]


def exported(manifest: Manifest) -> List[Tuple[RegistrationKind, str]]:
    return [(entry.kind, entry.plugin or str(entry.file and entry.file.name)) for entry in manifest.registrations]


@pytest.mark.parametrize(
    ("appendix", "name", "kind"),
    [
        ("appendix_c_package.xml", "alliance", RegistrationKind.ARCHITECTURE),
        ("appendix_d_package.xml", "alliance_test", RegistrationKind.APPLICATION),
    ],
)
def test_manifest_of_the_dissertation_registers(
    data: Path, write: Write, appendix: str, name: str, kind: RegistrationKind
) -> None:
    file = write("folder/rqt_mrta.xml", "<rqt_mrta/>")
    path = Path(shutil.copy(data / appendix, file.parent / "package.xml"))

    manifest = read_manifest(path)

    assert manifest.name == name
    (entry,) = manifest.registrations
    assert (entry.package, entry.kind, entry.file, entry.folder, entry.problems) == (name, kind, file, file.parent, ())


@pytest.mark.parametrize(
    ("form", "depend"),
    [
        (1, "<run_depend>rqt_mrta</run_depend>"),
        (2, "<exec_depend>rqt_mrta</exec_depend>"),
        (3, '<depend condition="$ROS_VERSION == 2"> rqt_mrta </depend>'),
        (3, "<exec_depend>rqt_mrta_py</exec_depend>"),
    ],
)
def test_manifest_of_every_format_registers_with_a_direct_run_time_dependency(
    manifest: Callable[..., Manifest], form: int, depend: str
) -> None:
    assert exported(manifest(TAG, depend, form=form)) == [(RegistrationKind.ARCHITECTURE, "a.xml")]


@pytest.mark.parametrize("tag", ["build_depend", "build_export_depend", "test_depend", "buildtool_depend"])
def test_manifest_registers_nothing_without_a_run_time_dependency(manifest: Callable[..., Manifest], tag: str) -> None:
    found = manifest(TAG, f"<{tag}>rqt_mrta</{tag}>")

    assert found.registrations == ()
    assert messages(found) == [
        "5: export/rqt_mrta: counts only with a direct <exec_depend>rqt_mrta</exec_depend>; add it"
    ]


def test_manifest_of_the_host_itself_needs_no_dependency(manifest: Callable[..., Manifest]) -> None:
    assert exported(manifest(TAG, "", name="rqt_mrta")) == [(RegistrationKind.ARCHITECTURE, "a.xml")]


def test_manifest_of_a_metapackage_registers_nothing_and_says_so(manifest: Callable[..., Manifest]) -> None:
    found = manifest(f"<metapackage/>{TAG}")

    assert (found.metapackage, found.registrations) == (True, ())
    assert messages(found) == [
        "5: export/rqt_mrta: counts for nothing in a metapackage; export it from a package of its own"
    ]


def test_manifest_of_rosbuild_has_the_name_of_its_folder(write: Write) -> None:
    write("old/a.xml", "<rqt_mrta/>")
    path = write("old/manifest.xml", f'<package><depend package="rqt_mrta"/><export>{TAG}</export></package>')

    found = read_manifest(path)

    assert (found.name, found.problems) == ("old", ())
    assert exported(found) == [(RegistrationKind.ARCHITECTURE, "a.xml")]


def test_manifest_may_depend_and_not_export(manifest: Callable[..., Manifest]) -> None:
    found = manifest('<nodelet plugin="${prefix}/n.xml"/>')

    assert (found.registrations, found.problems) == ((), ())


def test_manifest_lists_several_tags_and_attributes_in_file_order(manifest: Callable[..., Manifest]) -> None:
    found = manifest(
        '<rqt_mrta_py application="${prefix}/b.xml" architecture="${prefix}/a.xml" plugin="p.plugin"/>\n'
        '<rqt_mrta architecture="{prefix}/deep/c.xml"/>\n<rqt_mrta_py plugin="p.more"/>'
    )

    assert exported(found) == [
        (RegistrationKind.ARCHITECTURE, "a.xml"),
        (RegistrationKind.APPLICATION, "b.xml"),
        (RegistrationKind.PLUGIN, "p.plugin"),
        (RegistrationKind.ARCHITECTURE, "c.xml"),
        (RegistrationKind.PLUGIN, "p.more"),
    ]
    assert [entry.line for entry in found.registrations] == [5, 5, 5, 6, 7]
    assert messages(found) == []
    assert found.registrations[3].file == found.folder / "deep" / "c.xml"


def test_manifest_joins_tasks_and_scenario_with_the_application_of_another_tag(
    manifest: Callable[..., Manifest],
) -> None:
    found = manifest(
        '<rqt_mrta application="a.xml"/>\n<rqt_mrta_py tasks="${prefix}/tasks.yaml" scenario="scenario.yaml"/>'
    )

    (entry,) = found.registrations
    assert (entry.tasks, entry.scenario) == (found.folder / "tasks.yaml", found.folder / "scenario.yaml")
    assert messages(found) == []


@pytest.mark.parametrize("value", ["../a.xml", "${prefix}/../p2/a.xml", "/etc/passwd", "${prefix}", "."])
def test_manifest_exports_only_from_within_its_package(manifest: Callable[..., Manifest], value: str) -> None:
    found = manifest(f'<rqt_mrta architecture="{value}"/>')

    assert found.registrations[0].file is None
    assert messages(found) == [
        f"5: export/rqt_mrta/@architecture: must name a file within the package (got {value!r}); "
        "begin with ${prefix}/"
    ]


def test_manifest_reports_an_exported_file_that_is_missing(manifest: Callable[..., Manifest]) -> None:
    found = manifest('<rqt_mrta architecture="${prefix}/gone.xml"/>')

    assert messages(found) == [
        "5: export/rqt_mrta/@architecture: names a file that does not exist (got '${prefix}/gone.xml'): "
        f"{found.folder / 'gone.xml'}"
    ]


def test_manifest_reports_what_a_tag_says_wrongly(manifest: Callable[..., Manifest]) -> None:
    found = manifest(
        '<rqt_mrta_py aplication="${prefix}/a.xml" plugin="p/plugin.py" architecture=""/>\n'
        '<rqt_mrta_py tasks="tasks.yaml"/>\n<rqt_mrta_py tasks="tasks.yaml"/>'
    )

    assert sorted(messages(found)) == [
        "5: export/rqt_mrta_py/@aplication: is not known; nearest is 'application'",
        "5: export/rqt_mrta_py/@architecture: is empty; give a file, such as ${prefix}/rqt_mrta.xml",
        "5: export/rqt_mrta_py/@plugin: must be a dotted module (got 'p/plugin.py'), such as p.plugin",
        "6: @tasks: goes with an application; export application= as well",
        "7: export/rqt_mrta_py/@tasks: is given twice; the one in line 6 counts",
    ]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("<package>\n<name>p</name>", "2: is not well-formed XML: Premature end of data in tag package line 1"),
        ("<package/>", "1: name: is missing or empty; give the name of the package"),
        ("<stack><name>p</name></stack>", "1: stack: is not the root of a manifest; accepted: package"),
        (
            '<!DOCTYPE package [<!ENTITY x "y">]><package><name>&x;</name></package>',
            "1: declares the entity 'x'; entities are not accepted",
        ),
    ],
)
def test_manifest_that_is_broken_is_refused(write: Write, text: str, said: str) -> None:
    path = write("p/package.xml", text)

    with pytest.raises(ConfigError) as caught:
        read_manifest(path)

    assert str(caught.value) == f"{path}:{said}"


@pytest.mark.parametrize("name", ["../../x", "..", "a/b", "/tmp/x", "-x", "a b", "@robot_id@", "b\u00fccher"])
def test_manifest_of_a_package_whose_name_could_lead_elsewhere_is_refused(write: Write, name: str) -> None:
    """``config/<architecture>/`` and ``launch/<package>.launch`` were written outside of the application."""
    path = write("p/package.xml", f'<package format="2">\n<name>{name}</name>\n</package>\n')
    with pytest.raises(ConfigError) as caught:
        read_manifest(path)
    assert str(caught.value) == f"{path}:2: name: must be letters, digits, _ and - (got {name!r}); give such a name"


def test_manifest_that_is_missing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match=r"package\.xml: cannot be read: No such file or directory"):
        read_manifest(tmp_path / "package.xml")
