"""XML that must not do harm."""

from __future__ import annotations

from pathlib import Path

import pytest

from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.text import decode_xml, parse_xml
from rqt_mrta_py.errors import ConfigError


def said_of(text: object) -> str:
    with pytest.raises(ConfigError) as caught:
        parse_xml(text, "f.xml")  # type: ignore[arg-type]
    return str(caught.value)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_entity_is_refused_in_every_encoding_that_can_hide_it(encoding: str) -> None:
    text = '<!DOCTYPE a [<!ENTITY e "x">]>\n<a b="&e;"/>'

    assert said_of(text.encode(encoding)) == "f.xml:1: declares the entity 'e'; entities are not accepted"


@pytest.mark.parametrize(("encoding", "line"), [("windows-1252", ":1"), ("Shift_JIS", "")])
def test_entity_is_refused_in_an_encoding_that_expat_knows_from_python_or_not_at_all(encoding: str, line: str) -> None:
    text = f'<?xml version="1.0" encoding="{encoding}"?><!DOCTYPE a [<!ENTITY e "x">]><a>&e;</a>'.encode("ascii")

    assert said_of(text) == f"f.xml{line}: declares the entity 'e'; entities are not accepted"


def test_parameter_entity_and_external_subset_reach_no_file(tmp_path: Path) -> None:
    dtd = tmp_path / "evil.dtd"
    dtd.write_text('<!ENTITY e "leaked">', encoding="utf-8")
    text = f'<!DOCTYPE a [<!ENTITY % p SYSTEM "{dtd.as_uri()}"> %p;]><a>&e;</a>'

    assert said_of(text) == "f.xml:1: declares the entity 'p'; entities are not accepted"
    external = f'<!DOCTYPE a SYSTEM "{dtd.as_uri()}"><a>&e;</a>'
    try:
        root = parse_xml(external, "f.xml")
    except ConfigError:
        return
    assert "leaked" not in "".join(root.itertext())


def test_bomb_of_attributes_is_refused_unexpanded() -> None:
    lines = ['<!ENTITY e0 "aaaaaaaaaa">', *(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 10))]

    # Expanded, it would take gigabytes.
    said = said_of(f'<!DOCTYPE a [{"".join(lines)}]><a b="&e9;"/>')

    assert said == "f.xml:1: declares the entity 'e0'; entities are not accepted"


def test_deep_nesting_is_refused() -> None:
    assert said_of("<a>" * 100_000 + "</a>" * 100_000).startswith("f.xml:1: is not well-formed XML: ")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (b"", "f.xml:1: is not well-formed XML: "),
        ("\ud800", "f.xml:1: is not well-formed XML: "),
        (b"<a>\n<b></a>", "f.xml:2: is not well-formed XML: "),
        (b"\xff\xfe\x00", "f.xml:1: is not well-formed XML: "),
        (b'<?xml version="1.0" encoding="martian"?><a/>', "f.xml:1: is not well-formed XML: "),
        ("<a>\0</a>", "f.xml:1: is not well-formed XML: "),
    ],
)
def test_broken_text_is_refused_with_its_line(text: object, said: str) -> None:
    assert said_of(text).startswith(said)


def test_harmless_document_type_is_accepted() -> None:
    assert read_architecture(
        "<!DOCTYPE rqt_mrta><rqt_mrta><architecture><name>A</name></architecture></rqt_mrta>", "a", "b"
    )


@pytest.mark.parametrize(
    ("raw", "text"),
    [
        (b"\xef\xbb\xbf<a/>", "<a/>"),
        ("<a>\u00e4</a>".encode("utf-16"), "<a>\u00e4</a>"),
        (
            b'<?xml version="1.0" encoding="latin-1"?><a>\xe4</a>',
            '<?xml version="1.0" encoding="latin-1"?><a>\u00e4</a>',
        ),
        ("<a>\u00e4</a>".encode(), "<a>\u00e4</a>"),
    ],
)
def test_decode_xml_follows_mark_declaration_or_utf_8(raw: bytes, text: str) -> None:
    assert decode_xml(raw) == text
