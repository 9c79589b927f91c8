"""Packages as they occur in the wild, what discovery makes of each, and what ``rospack plugins`` does.

Expected values are those of rospack 2.6, which a test asks again wherever it is installed, and the reasons for which
this project answers differently. The page of the room has a row for each ``row`` and each ``difference``.
"""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

__all__ = ["CASES", "HOSTS", "Case", "manifest"]

Content = Union[str, bytes]
Listed = Tuple[str, ...]


class Case(NamedTuple):
    """Packages and what is found of them.

    Attributes:
        name: of the case, part of the tests' names.
        row: of the table of what is found, or of what is done otherwise than rospack does it.
        files: content by path; a path that ends in a slash is a folder.
        found: ``attribute package file``, the file from the root of the tree; nothing after the package: none.
        rospack: the same, as rospack has it; None: no difference; empty: nothing or an error.
        links: target by link.
        entries: of the package path.
        hosts: False for a tree without the packages that are depended on.
        either: True if rospack's answer depends on the file system, as long as it is one of ``rospack``.
    """

    name: str
    row: str
    files: Dict[str, Content]
    found: Listed
    rospack: Optional[Listed] = None
    links: Sequence[Tuple[str, str]] = ()
    entries: Sequence[str] = ("ws",)
    hosts: bool = True
    either: bool = False


ARCHITECTURE = '<rqt_mrta architecture="${prefix}/rqt_mrta.xml"/>'
DEPEND = "<exec_depend>rqt_mrta</exec_depend>"
XML = "<rqt_mrta/>"


def manifest(name: str, depend: str = DEPEND, export: str = ARCHITECTURE, form: int = 2) -> str:
    """Write a package.xml of any format."""
    return (
        f'<?xml version="1.0"?>\n<package format="{form}">\n  <name>{name}</name>\n  <version>1.0.0</version>\n'
        f'  <description>d</description>\n  <maintainer email="m@example.org">m</maintainer>\n'
        f"  <license>BSD</license>\n  {depend}\n  <export>\n    {export}\n  </export>\n</package>\n"
    )


HOSTS = {
    f"hosts/{name}/package.xml": manifest(name, "<exec_depend>roscpp</exec_depend>", "")
    for name in ("rqt_mrta", "rqt_mrta_py")
}


def package(
    folder: str, name: str = "p", depend: str = DEPEND, export: str = ARCHITECTURE, form: int = 2
) -> Dict[str, Content]:
    """Write a package with the file that it exports."""
    return {f"{folder}/package.xml": manifest(name, depend, export, form), f"{folder}/rqt_mrta.xml": XML}


def _edited(old: str, new: str) -> Dict[str, Content]:
    return {"ws/p/package.xml": manifest("p").replace(old, new), "ws/p/rqt_mrta.xml": XML}


P = ("architecture p ws/p/rqt_mrta.xml",)
P_IN_A = ("architecture p ws/a/p/rqt_mrta.xml",)
P_HIDDEN = ("architecture p .ws/p/rqt_mrta.xml",)
NONE: Listed = ()

_DEPENDS = "a direct `run_depend`, `exec_depend` or `depend`, of any manifest format, whatever its `condition=`"
_TAGS = "several tags, both attributes in one tag"
_NAMES = "a name that differs from the folder's"
_NESTED = "a package in the folder of another"
_FIRST = "a name that an earlier entry of the path has already"
_MARKED = "folders with `CATKIN_IGNORE`, hidden ones, those below `rospack_nosubdirs`"
_UNMARKED = "folders with `AMENT_IGNORE` or `COLCON_IGNORE`, which are marks of ROS 2"
_LINKS = "linked folders and manifests"
_ROSBUILD = "rosbuild packages (`manifest.xml`), named after their folder"
_LENIENT = "text that is no well-formed XML, which catkin refuses"
_ORDER = "two packages of one name below one entry of the path"


def _depending() -> List[Case]:
    tags = {
        "run_depend": (1, "<run_depend>rqt_mrta</run_depend>"),
        "exec_depend": (2, DEPEND),
        "depend": (3, "<depend>rqt_mrta</depend>"),
        "exec_depend_in_format_1": (1, DEPEND),
        "run_depend_in_format_2": (2, "<run_depend>rqt_mrta</run_depend>"),
        "a_false_condition": (3, '<depend condition="$ROS_VERSION == 2">rqt_mrta</depend>'),
        "an_impossible_version": (2, '<exec_depend version_gte="9.0">rqt_mrta</exec_depend>'),
        "blanks_around_the_name": (2, "<exec_depend>\n  rqt_mrta\n</exec_depend>"),
        "a_comment_in_the_name": (2, "<exec_depend><!-- c -->rqt_mrta</exec_depend>"),
        "another_dependency_that_is_missing": (2, f"<exec_depend>gone</exec_depend>{DEPEND}"),
    }
    cases = [
        Case(f"depending_by_{name}", _DEPENDS, package("ws/p", depend=depend, form=form), P)
        for name, (form, depend) in tags.items()
    ]
    not_run_time = ("build_depend", "build_export_depend", "buildtool_depend", "test_depend", "doc_depend")
    row = "only another kind of dependency, or one through another package"
    cases += [
        Case(f"only_{tag}", row, package("ws/p", depend=f"<{tag}>rqt_mrta</{tag}>", form=3), NONE)
        for tag in (*not_run_time, "group_depend")
    ]
    indirect = {**package("ws/a", "a"), **package("ws/p", depend="<exec_depend>a</exec_depend>")}
    return [
        *cases,
        Case("an_indirect_dependency", row, indirect, ("architecture a ws/a/rqt_mrta.xml",)),
        Case("a_tag_alone", "a tag without a dependency", package("ws/p", depend=""), NONE),
        Case("a_dependency_alone", "a dependency without a tag", package("ws/p", export=""), NONE),
    ]


def _exporting() -> List[Case]:
    a, b = "${prefix}/a.xml", "${prefix}/b.xml"
    files: Dict[str, Content] = {"ws/p/a.xml": XML, "ws/p/b.xml": XML}
    both = ("application p ws/p/b.xml", "architecture p ws/p/a.xml")
    twice = ("architecture p ws/p/a.xml", "architecture p ws/p/b.xml")
    exports = {
        "two_tags": (f'<rqt_mrta architecture="{a}"/><rqt_mrta application="{b}"/>', both),
        "one_tag_with_both": (f'<rqt_mrta application="{b}" architecture="{a}"/>', both),
        "one_attribute_twice": (f'<rqt_mrta architecture="{a}"/><rqt_mrta architecture="{b}"/>', twice),
        "two_exports": (f'<rqt_mrta architecture="{a}"/></export><export><rqt_mrta application="{b}"/>', both),
        "a_tag_in_a_comment": (f'<!-- <rqt_mrta architecture="{a}"/> -->', NONE),
        "a_tag_deeper_down": (f'<group><rqt_mrta architecture="{a}"/></group>', NONE),
        "a_tag_in_capitals": (f'<RQT_MRTA architecture="{a}"/>', NONE),
    }
    tags = [
        Case(name, _TAGS, {**package("ws/p", export=export), **files}, found)
        for name, (export, found) in exports.items()
    ]
    ours = '<rqt_mrta_py architecture="${prefix}/rqt_mrta.xml"/>'
    by_ours = "<exec_depend>rqt_mrta_py</exec_depend>"
    crossed = "a dependency on one of `rqt_mrta`, `rqt_mrta_py` and a tag of the other"
    return [
        *tags,
        Case("our_own_name", _TAGS, package("ws/p", depend=by_ours, export=ours), P),
        Case("our_tag_for_the_original", crossed, package("ws/p", export=ours), P, NONE),
        Case("the_original_tag_for_us", crossed, package("ws/p", depend=by_ours), P, NONE),
        Case(
            "the_host_itself",
            "`rqt_mrta` itself, if it exports its own tag",
            package("ws/host", "rqt_mrta", depend=""),
            ("architecture rqt_mrta ws/host/rqt_mrta.xml",),
            entries=("ws", "hosts"),
        ),
        Case(
            "a_metapackage",
            "a metapackage",
            package("ws/p", export=f"<metapackage/>{ARCHITECTURE}"),
            NONE,
        ),
        Case("a_host_that_is_missing", "`rqt_mrta` itself missing", package("ws/p"), P, NONE, hosts=False),
    ]


def _placing() -> List[Case]:
    rosbuild = f'<package><description>d</description><depend package="rqt_mrta"/><export>{ARCHITECTURE}</export>'
    rosbuild += "</package>"
    old: Dict[str, Content] = {"ws/m/manifest.xml": rosbuild, "ws/m/rqt_mrta.xml": XML}
    named = rosbuild.replace("<description>", "<name>other</name><description>")
    found_old = ("architecture m ws/m/rqt_mrta.xml",)
    return [
        Case("another_name", _NAMES, package("ws/folder"), ("architecture p ws/folder/rqt_mrta.xml",)),
        Case("deep_down", _NAMES, package("ws/a/b/p"), ("architecture p ws/a/b/p/rqt_mrta.xml",)),
        Case("spaces_in_the_path", _NAMES, package("ws/a b/p"), ("architecture p ws/a b/p/rqt_mrta.xml",)),
        Case("a_nested_package", _NESTED, {**package("ws/p"), **package("ws/p/q", "q")}, P),
        Case("a_stack", _NAMES, {**package("ws/p"), "ws/stack.xml": "<stack/>"}, P),
        Case("two_entries", _FIRST, {**package("ws/p"), **package("b/p")}, P, entries=("ws", "b")),
        Case("an_entry_in_an_entry", _FIRST, package("ws/a/p"), P_IN_A, entries=("ws/a", "ws")),
        Case("an_entry_that_is_a_package", _FIRST, package("ws/p"), P, entries=("ws/p",)),
        Case("an_entry_that_is_missing", _FIRST, package("ws/p"), P, entries=("gone", "ws")),
        Case("a_folder_to_ignore", _MARKED, {**package("ws/a/p"), "ws/a/CATKIN_IGNORE": ""}, NONE),
        Case("a_package_to_ignore", _MARKED, {**package("ws/p"), "ws/p/CATKIN_IGNORE": ""}, NONE),
        Case("an_entry_to_ignore", _MARKED, {**package("ws/p"), "ws/CATKIN_IGNORE": ""}, NONE),
        Case("a_mark_that_is_a_folder", _MARKED, {**package("ws/p"), "ws/p/CATKIN_IGNORE/": ""}, P),
        Case("a_hidden_folder", _MARKED, package("ws/.a/p"), NONE),
        Case("an_entry_that_is_hidden", _MARKED, package(".ws/p"), P_HIDDEN, entries=(".ws",)),
        Case("nothing_below", _MARKED, {**package("ws/a/p"), "ws/a/rospack_nosubdirs": ""}, NONE),
        Case("nothing_below_a_package", _MARKED, {**package("ws/p"), "ws/p/rospack_nosubdirs": ""}, P),
        Case("a_mark_of_ament", _UNMARKED, {**package("ws/p"), "ws/p/AMENT_IGNORE": ""}, P),
        Case("a_mark_of_colcon", _UNMARKED, {**package("ws/p"), "ws/p/COLCON_IGNORE": ""}, P),
        Case("a_linked_package", _LINKS, package("real"), P, links=[("ws/p", "real")]),
        Case("a_linked_entry", _LINKS, package("real/p"), P, links=[("ws", "real")]),
        Case(
            "a_linked_manifest",
            _LINKS,
            {"real.xml": manifest("p"), "ws/p/rqt_mrta.xml": XML},
            P,
            links=[("ws/p/package.xml", "real.xml")],
        ),
        Case("a_link_to_nowhere", _LINKS, package("ws/p"), P, links=[("ws/a", "gone")]),
        Case("a_manifest_linked_to_nowhere", _LINKS, package("ws/a/p"), P_IN_A, links=[("ws/a/package.xml", "gone")]),
        Case("a_folder_called_package_xml", _LINKS, {**package("ws/a/p"), "ws/a/package.xml/": ""}, P_IN_A),
        Case(
            "a_loop_of_links",
            "a link to a folder above",
            package("ws/p"),
            P,
            (*P, "architecture p ws/{40}p/rqt_mrta.xml"),
            links=[("ws/loop", "ws")],
            either=True,
        ),
        Case("rosbuild", _ROSBUILD, old, found_old),
        Case("rosbuild_with_a_name", _ROSBUILD, {**old, "ws/m/manifest.xml": named}, found_old),
        Case("rosbuild_without_dependency", _ROSBUILD, {**old, "ws/m/manifest.xml": _catkin_in(rosbuild)}, NONE),
        Case(
            "a_manifest_of_each_kind",
            "a `package.xml` beside a `manifest.xml`",
            {**old, "ws/m/package.xml": manifest("p")},
            ("architecture p ws/m/rqt_mrta.xml",),
            found_old,
        ),
        Case(
            "one_name_twice_below_an_entry",
            _ORDER,
            {**package("ws/b"), **package("ws/a")},
            ("architecture p ws/a/rqt_mrta.xml",),
            ("architecture p ws/a/rqt_mrta.xml", "architecture p ws/b/rqt_mrta.xml"),
            either=True,
        ),
        Case(
            "below_a_share_folder",
            "packages deeper in a folder called `share`",
            {**package("share/p"), **package("share/a/q", "q")},
            ("architecture p share/p/rqt_mrta.xml",),
            ("architecture p share/p/rqt_mrta.xml", "architecture q share/a/q/rqt_mrta.xml"),
            entries=("share",),
        ),
    ]


def _catkin_in(rosbuild: str) -> str:
    return rosbuild.replace('<depend package="rqt_mrta"/>', "<run_depend>rqt_mrta</run_depend>")


def _naming_files() -> List[Case]:
    def exporting(value: str) -> Dict[str, Content]:
        return package("ws/p", export=f'<rqt_mrta architecture="{value}"/>')

    return [
        Case(
            "a_file_that_is_missing",
            "an exported file that is missing",
            {"ws/p/package.xml": manifest("p")},
            P,
        ),
        Case(
            "a_prefix_without_its_dollar",
            "`{prefix}` without the dollar",
            exporting("{prefix}/rqt_mrta.xml"),
            P,
            ("architecture p {prefix}/rqt_mrta.xml",),
        ),
        Case(
            "a_relative_path",
            "a relative path to the file",
            exporting("rqt_mrta.xml"),
            P,
            ("architecture p rqt_mrta.xml",),
        ),
        Case(
            "a_path_by_way_of_another_folder",
            "a path to the file that is not the shortest",
            exporting("${prefix}/a/../rqt_mrta.xml"),
            P,
            ("architecture p ws/p/a/../rqt_mrta.xml",),
        ),
        Case(
            "blanks_around_the_path",
            "blanks around the path to the file",
            exporting(" ${prefix}/rqt_mrta.xml "),
            P,
            ("architecture p  {root}/ws/p/rqt_mrta.xml ",),
        ),
        Case(
            "a_file_outside_the_package",
            "a file outside its package",
            exporting("${prefix}/../rqt_mrta.xml"),
            ("architecture p",),
            ("architecture p ws/p/../rqt_mrta.xml",),
        ),
        Case("no_file_at_all", "an empty attribute", exporting(""), ("architecture p",), ("architecture p ",)),
    ]


def _writing_xml() -> List[Case]:
    readable = "XML with a byte order mark, Latin letters, CDATA, character references, a namespace, Windows line ends"
    latin = manifest("p").replace("?>", ' encoding="iso-8859-1"?>', 1).replace(">d<", ">\xe9<")
    entity = "<!DOCTYPE package [<!ENTITY x 'y'>]>\n<package"
    text = manifest("p")
    return [
        Case("a_byte_order_mark", readable, {**package("ws/p"), "ws/p/package.xml": f"\ufeff{text}"}, P),
        Case("latin_letters", readable, {**package("ws/p"), "ws/p/package.xml": latin.encode("latin-1")}, P),
        Case("windows_line_ends", readable, {**package("ws/p"), "ws/p/package.xml": text.replace("\n", "\r\n")}, P),
        Case("character_data", readable, _edited(">rqt_mrta<", "><![CDATA[rqt_mrta]]><"), P),
        Case("a_character_reference", readable, _edited(">rqt_mrta<", ">&#114;qt_mrta<"), P),
        Case("a_default_namespace", readable, _edited("<package ", '<package xmlns="http://x" '), P),
        Case("a_document_type", readable, _edited("<package ", "<!DOCTYPE package>\n<package "), P),
        Case("an_ampersand_by_itself", _LENIENT, _edited(">d<", ">a & b<"), NONE, P),
        Case("a_control_character", _LENIENT, _edited(">d<", ">\x01<"), NONE, P),
        Case("an_unbound_prefix", _LENIENT, _edited("<license>", "<x:y/><license>"), NONE, P),
        Case("a_line_before_the_declaration", _LENIENT, _edited("<?xml", "\n<?xml"), NONE, P),
        Case(
            "an_encoding_that_nobody_knows",
            "an encoding that nobody knows",
            _edited('"1.0"?>', '"1.0" encoding="x-nothing"?>'),
            NONE,
            P,
        ),
        Case("an_entity", "declared entities", _edited("<package", entity), NONE, P),
        Case("no_name", "a manifest without a name", _edited("<name>p</name>", ""), NONE, P),
        Case(
            "a_name_with_slashes",
            "a name of other characters than letters, digits, `_` and `-`",
            _edited("<name>p</name>", "<name>../../p</name>"),
            NONE,
            ("architecture ../../p ws/p/rqt_mrta.xml",),
        ),
        Case(
            "another_root",
            "a root element other than `package`",
            _edited("package", "stack"),
            NONE,
            P,
        ),
        Case(
            "a_broken_manifest_elsewhere",
            "one broken manifest anywhere on the path",
            {**package("ws/p"), "ws/q/package.xml": "<package><name>q</name>"},
            P,
            NONE,
        ),
        Case(
            "utf_16",
            "UTF-16",
            {**package("ws/p"), "ws/p/package.xml": text.replace('"1.0"', '"1.0" encoding="utf-16"').encode("utf-16")},
            P,
            NONE,
        ),
    ]


CASES = (*_depending(), *_exporting(), *_placing(), *_naming_files(), *_writing_xml())
