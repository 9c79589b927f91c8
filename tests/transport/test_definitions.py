from __future__ import annotations

import json
from typing import List

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.codec.definitions import Constant, Field, parse_definition, parse_message
from rqt_mrta_py.transport.codec.types import TypeLibrary
from tests.transport.support import ROS_PYTHON, lookup, require_ros, run_ros

SEPARATOR = "=" * 80


@pytest.fixture(scope="module")
def library() -> TypeLibrary:
    return TypeLibrary(lookup)


def test_parse_message_reads_every_form_of_field() -> None:
    spec = parse_message(
        "pkg/Msg", "# first\nHeader header\n\n  uint8[]   raw # bytes\r\nOther o\nother/Thing[3] t\n\tfloat64[36]\tc\n"
    )
    assert spec.fields == (
        Field("std_msgs/Header", "header"),
        Field("uint8", "raw", is_array=True),
        Field("pkg/Other", "o"),
        Field("other/Thing", "t", is_array=True, length=3),
        Field("float64", "c", is_array=True, length=36),
    )


def test_parse_message_keeps_a_string_constant_to_the_end_of_its_line() -> None:
    spec = parse_message("pkg/Msg", "string TEXT=  a = b # no comment  \nint8 LOW = -1 # comment\n")
    assert spec.constants == (Constant("string", "TEXT", "a = b # no comment"), Constant("int8", "LOW", "-1"))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("uint8", "pkg/Msg, line 1 of its definition: 'uint8' is no declaration"),
        ("\nuint8 a b", "pkg/Msg, line 2 of its definition: 'uint8 a b' is no declaration"),
        ("uint8[2][2] a", "is no declaration"),
        ("uint8[-1] a", "is no declaration"),
        ("uint8 1st", "is no declaration"),
        ("a/b/c x", "is no declaration"),
        ("Header A=1", "'Header' cannot be the type of a constant"),
        ("uint8 =1", "'' cannot be the name of a constant"),
        ("uint8 a\nint8 a", "pkg/Msg: field 'a' is declared twice"),
    ],
)
def test_parse_message_says_which_line_is_wrong(text: str, message: str) -> None:
    with pytest.raises(TransportError) as caught:
        parse_message("pkg/Msg", text)
    assert message in str(caught.value)


def test_parse_definition_finds_contained_types_in_any_order() -> None:
    text = f"A a\nB b\n{SEPARATOR}\nMSG: pkg/B\nuint8 x\n{SEPARATOR}\nMSG: pkg/A\nB b\n"
    definition = parse_definition("pkg/Msg", text)
    assert list(definition.specs) == ["pkg/Msg", "pkg/A", "pkg/B"]
    assert definition.contained_first == ("pkg/B", "pkg/A", "pkg/Msg")


def test_parse_definition_refuses_a_text_that_lacks_a_type() -> None:
    with pytest.raises(TransportError, match="pkg/Msg: its definition lacks the text of pkg/Gone, which it contains"):
        parse_definition("pkg/Msg", "Gone g")


def test_parse_definition_refuses_a_type_that_contains_itself() -> None:
    text = f"A a\n{SEPARATOR}\nMSG: pkg/A\nB[] b\n{SEPARATOR}\nMSG: pkg/B\nA[] a\n"
    with pytest.raises(TransportError, match="pkg/A contains itself"):
        parse_definition("pkg/Msg", text)


@pytest.mark.parametrize("count", [33, 2000])
def test_parse_definition_refuses_endless_nesting(count: int) -> None:
    parts = [f"{SEPARATOR}\nMSG: pkg/T{i}\nT{i + 1} t\n" for i in range(count)]
    with pytest.raises(TransportError, match="nest"):
        parse_definition("pkg/Msg", "T0 t\n" + "".join(parts) + f"{SEPARATOR}\nMSG: pkg/T{count}\nuint8 x\n")


def test_parse_definition_refuses_nesting_that_hides_behind_a_shorter_way() -> None:
    listed = "".join(f"T{i} t{i}\n" for i in range(40, -1, -1))
    parts = [f"{SEPARATOR}\nMSG: pkg/T{i}\n{f'T{i + 1} t' if i < 40 else 'uint8 x'}\n" for i in range(41)]
    with pytest.raises(TransportError, match="pkg/Msg: messages nest 42 deep; at most 32 are accepted"):
        parse_definition("pkg/Msg", listed + "".join(parts))


def test_full_text_has_the_form_that_genmsg_writes() -> None:
    texts = {"p/A": "B b\nC c\n", "p/B": "C[] c # again\n", "p/C": "uint8 x"}
    assert TypeLibrary(texts.get).definition("p/A").full_text == (
        f"B b\nC c\n\n{SEPARATOR}\nMSG: p/B\nC[] c # again\n\n{SEPARATOR}\nMSG: p/C\nuint8 x"
    )


# Published by ROS (rosmsg md5) and, for alliance_msgs, by the original packages.
@pytest.mark.parametrize(
    ("type_name", "md5"),
    [
        ("std_msgs/Empty", "d41d8cd98f00b204e9800998ecf8427e"),
        ("std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1"),
        ("std_msgs/Header", "2176decaecbce78abc3b96ef049fabed"),
        ("rosgraph_msgs/Log", "acffd30cd6b6de30f120938c17c593fb"),
        ("sensor_msgs/LaserScan", "90c7ef2dc6895d81024acba2ac42f369"),
        ("nav_msgs/Odometry", "cd5e73d190d741a2f92e81eda573aca7"),
        ("tf2_msgs/TFMessage", "94810edda583a504dfda3829e70d7eec"),
        ("alliance_msgs/InterRobotCommunication", "8505d7acd13c06abd6d1570486e15ec1"),
        ("alliance_msgs/Motivation", "f2769f911dab2069bd205e5da97d8fb9"),
        ("alliance_msgs/SensoryFeedback", "7894d9f16222b7d62a11d47780ee8bf7"),
    ],
)
def test_md5_equals_the_published_one(library: TypeLibrary, type_name: str, md5: str) -> None:
    assert library.definition(type_name).md5 == md5


def test_md5_ignores_comments_and_blanks_but_not_names() -> None:
    plain, airy, other = (
        TypeLibrary({"p/A": text}.get).definition("p/A").md5
        for text in ("uint8 X=1\nuint8 a", "# c\n\n uint8   a  # d\nuint8 X = 1\n", "uint8 X=1\nuint8 b")
    )
    assert plain == airy != other


def test_types_say_where_an_unknown_type_was_looked_for(library: TypeLibrary) -> None:
    with pytest.raises(TransportError) as caught:
        library.definition("my_msgs/Thing")
    assert str(caught.value) == (
        "message type 'my_msgs/Thing' is not known: it is no standard type, and no package on the search path has "
        "my_msgs/msg/Thing.msg"
    )


def test_standard_types_do_not_come_from_the_lookup() -> None:
    library = TypeLibrary({"std_msgs/String": "uint8 broken"}.get)
    assert library.definition("std_msgs/String").root.fields == (Field("string", "data"),)


@pytest.mark.ros
def test_definitions_agree_with_genpy(library: TypeLibrary) -> None:
    require_ros("genpy.dynamic")
    names = sorted(
        [f"alliance_msgs/{name}" for name in ("InterRobotCommunication", "Motivation", "SensoryFeedback")]
        + ["rqt_mrta_py/Incident", "rqt_mrta_py/TeamState", "rqt_mrta_py/Mission", "odd/Everything", "odd/Arrays"]
        + [
            "nav_msgs/Odometry",
            "visualization_msgs/MarkerArray",
            "tf2_msgs/TFMessage",
            "diagnostic_msgs/DiagnosticArray",
        ]
    )
    script = (
        "import json, sys, genpy.dynamic as d\n"
        "texts = json.load(sys.stdin)\n"
        "print(json.dumps({n: d.generate_dynamic(n, t)[n]._md5sum for n, t in texts.items()}))\n"
    )
    texts = {name: library.definition(name).full_text for name in names}
    answer = run_ros([ROS_PYTHON, "-c", script], input=json.dumps(texts))
    assert json.loads(answer.stdout) == {name: library.definition(name).md5 for name in names}


_LINES = st.lists(
    st.sampled_from(
        ["uint8 a", "string S=x#y", "Other o", "float64[3] f", SEPARATOR, "MSG: pkg/Other", "=", "#", "A=B"]
    )
    | st.text(max_size=20)
)


@settings(deadline=None)
@given(_LINES)
@example(["Other o", SEPARATOR, "MSG: pkg/Other", "uint8 a"])
def test_parse_definition_either_understands_or_raises_transport_error(lines: List[str]) -> None:
    try:
        definition = parse_definition("pkg/Msg", "\n".join(lines))
    except TransportError:
        return
    assert len(definition.md5) == 32
    assert parse_definition("pkg/Msg", definition.full_text).md5 == definition.md5


@pytest.mark.parametrize(
    "error", [PermissionError(13, "Permission denied"), UnicodeDecodeError("utf-8", b"\xe4", 0, 1, "odd")]
)
def test_a_definition_that_cannot_be_read_is_an_error_that_names_the_type(error: Exception) -> None:
    def unreadable(name: str) -> str:
        raise error

    with pytest.raises(TransportError, match="message type 'p/A': its definition cannot be read: "):
        TypeLibrary(unreadable).definition("p/A")
