"""CMake's language, by the grammar in cmake-language(7)."""

from __future__ import annotations

from pathlib import Path
from typing import List, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.app.doctor.cmake_commands import cmake_commands
from rqt_mrta_py.app.doctor.install_rules import read_install_rules


def plain(text: str) -> List[Tuple[str, List[str]]]:
    """Read commands as names and texts."""
    return [(command.name, [argument.text for argument in command.arguments]) for command in cmake_commands(text)]


@pytest.mark.parametrize(
    ("text", "commands"),
    [
        ("project(a)", [("project", ["a"])]),
        ("  PROJECT ( a\n\tb )\n", [("project", ["a", "b"])]),
        ("set(a b) # c(d)\nset(e)", [("set", ["a", "b"]), ("set", ["e"])]),
        ("# set(a)\nset(b)", [("set", ["b"])]),
        ("#[[ set(a)\n ]] set(b)", [("set", ["b"])]),
        ("#[==[ ]] ]=] set(a) ]==] set(b)", [("set", ["b"])]),
        ('set("a # b" "c)")', [("set", ["a # b", "c)"])]),
        (r'set("a \"b\"" c\ d \#e)', [("set", ['a "b"', "c d", "#e"])]),
        ("set([[a ${b} \\c]] [=[ ]] ]=])", [("set", ["a ${b} \\c", " ]] "])]),
        ("if(a AND (b OR c))\nendif()", [("if", ["a", "AND", "b", "OR", "c"]), ("endif", [])]),
        ("set(a ${b}/${c d}.e)", [("set", ["a", "${b}/${c d}.e"])]),
        ("set(a\n  # why\n  b)", [("set", ["a", "b"])]),
        ("set(a)set(b)", [("set", ["a"]), ("set", ["b"])]),
        ("set(a", []),
        ("no command here", []),
        ("", []),
    ],
)
def test_commands_are_read_as_cmake_reads_them(text: str, commands: List[Tuple[str, List[str]]]) -> None:
    assert plain(text) == commands


def test_lines_are_those_of_the_names() -> None:
    text = '# one\n\nset(a\n  "b\n c")\n#[[\n]]\nset(d)\n'
    assert [command.line for command in cmake_commands(text)] == [3, 8]


@given(st.text(alphabet='set(ab)"\\#[]=${};\n /install FILES DESTINATION', max_size=80))
def test_any_text_is_read(text: str) -> None:
    rules = read_install_rules(f"{text}\ninstall(FILES {text} DESTINATION share/a)", Path(__file__).parent, "a")
    assert rules.covers("b.xml") in (True, False)


def test_variables_that_double_themselves_come_to_an_end(tmp_path: Path) -> None:
    text = 'set(a "${a}${a}" "${a}${a}")\n' * 40 + "install(FILES ${a} DESTINATION share/a)"
    assert not read_install_rules(text, tmp_path, "a").is_clear
