from __future__ import annotations

import pytest

from rqt_mrta_py.config.editing.xml_document import XmlDocument
from rqt_mrta_py.errors import ConfigError

TEXT = """<?xml version="1.0" encoding="UTF-8"?>
<!-- Before. -->

<rqt_mrta format="application">
  <robots>
    <!-- The first. -->
    <robot_0> <id>robot1</id> </robot_0>
    <robot_2>
      <id>robot3</id> <!-- third -->
    </robot_2>
  </robots>
</rqt_mrta>
<!-- After. -->
"""


def document(text: str = TEXT) -> XmlDocument:
    return XmlDocument(text.encode("utf-8"), "rqt_mrta.xml")


def test_what_is_not_edited_stays_byte_for_byte() -> None:
    assert document().text() == TEXT


def test_a_numbered_element_is_laid_out_as_its_siblings_are() -> None:
    edited = document()
    edited.add_numbered(edited.root[0], "robot", ["robot"], [("id", "a&b")])
    addition = "    <robot_3>\n      <id>a&amp;b</id>\n    </robot_3>\n"
    assert edited.text() == TEXT.replace("  </robots>\n", f"{addition}  </robots>\n")


def test_an_element_in_one_line_gets_siblings_in_one_line() -> None:
    text = "<rqt_mrta>\n  <c>\n    <p_0> <n>x</n> <v>1</v> </p_0>\n  </c>\n</rqt_mrta>"
    edited = document(text)
    edited.add_numbered(edited.root[0], "p", ["p"], [("n", "y"), ("v", "2")])
    assert edited.text() == text.replace("  </c>", "    <p_1> <n>y</n> <v>2</v> </p_1>\n  </c>")


def test_the_first_child_is_indented_as_the_file_is() -> None:
    edited = document("<rqt_mrta>\n\t<a>1</a>\n</rqt_mrta>\n")
    edited.add(edited.add(edited.root, "configs"), "config_0", [("id", "x")])
    assert edited.text() == (
        "<rqt_mrta>\n\t<a>1</a>\n\t<configs>\n\t\t<config_0>\n\t\t\t<id>x</id>\n\t\t</config_0>\n\t</configs>\n"
        "</rqt_mrta>\n"
    )


def test_removing_takes_the_line_away_and_numbers_count_on() -> None:
    edited = document()
    robots = edited.root[0]
    edited.remove(edited.numbered(robots, ["robot"])[0].node)
    edited.renumber(robots, ["robot"])
    assert edited.text() == TEXT.replace("    <robot_0> <id>robot1</id> </robot_0>\n", "").replace("robot_2", "robot_0")
    edited.remove(edited.numbered(robots, ["robot"])[0].node)
    assert edited.text() == TEXT.replace(TEXT[TEXT.index("    <robot_0>") : TEXT.index("  </robots>")], "")


def test_line_ends_and_another_encoding_survive_as_utf_8() -> None:
    raw = '<?xml version="1.0" encoding="ISO-8859-1"?>\r\n<rqt_mrta>\r\n<a>é</a>\r\n</rqt_mrta>\r\n'.encode("latin-1")
    edited = XmlDocument(raw, "rqt_mrta.xml")
    assert edited.text() == ('<?xml version="1.0" encoding="UTF-8"?>\r\n<rqt_mrta>\r\n<a>é</a>\r\n</rqt_mrta>\r\n')


def test_entities_are_refused() -> None:
    with pytest.raises(ConfigError, match="entities are not accepted"):
        document('<!DOCTYPE a [<!ENTITY x "y">]><rqt_mrta>&x;</rqt_mrta>')
