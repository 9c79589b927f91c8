"""Tables: whole away from a terminal, folded on one, never short of a word."""

from __future__ import annotations

from typing import List, Optional, Tuple

from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.app.cli.table import table_lines

HEAD = ("NAME", "TYPE", "TOOL TIP")
ROWS = [
    ("spin_rate", "double", "Enter how often the robot updates its motivations [Hz]."),
    ("name", "string", ""),
]


def test_a_table_away_from_a_terminal_has_a_line_for_each_row() -> None:
    assert table_lines(HEAD, ROWS) == [
        "NAME       TYPE    TOOL TIP",
        "spin_rate  double  Enter how often the robot updates its motivations [Hz].",
        "name       string",
    ]


def test_a_table_that_fits_its_terminal_is_the_same() -> None:
    assert table_lines(HEAD, ROWS, 74) == table_lines(HEAD, ROWS)


def test_a_table_folds_its_last_column_below_itself() -> None:
    assert table_lines(HEAD, ROWS, 48) == [
        "NAME       TYPE    TOOL TIP",
        "spin_rate  double  Enter how often the robot",
        "                   updates its motivations [Hz].",
        "name       string",
    ]


def test_a_table_gives_its_last_column_lines_of_their_own_where_there_is_no_room_beside_the_others() -> None:
    assert table_lines(HEAD, ROWS, 40) == [
        "NAME       TYPE",
        "    TOOL TIP",
        "spin_rate  double",
        "    Enter how often the robot updates",
        "    its motivations [Hz].",
        "name       string",
    ]


def test_a_table_may_have_no_rows_and_a_single_column() -> None:
    assert table_lines(("NAME",), []) == ["NAME"]


@given(
    st.lists(st.tuples(*[st.text("ab c-", max_size=30)] * 3), max_size=4),
    st.one_of(st.none(), st.integers(0, 90)),
)
def test_a_table_of_any_width_holds_every_word(rows: List[Tuple[str, str, str]], width: Optional[int]) -> None:
    words = " ".join(table_lines(HEAD, rows, width)).split()

    assert sorted(words) == sorted(" ".join(" ".join(row) for row in [HEAD, *rows]).split())
