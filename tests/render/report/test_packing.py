from __future__ import annotations

import base64
from typing import List

from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.render.report.packing import packed, unpacked

NUMBERS = st.integers(-(2**45), 2**45)


def test_columns_are_differences_with_their_sign_in_the_lowest_bit_seven_bits_a_byte() -> None:
    # Two rows; 1 and then 150 more: 2, 300 = 0b10_0101100; -1 and then 0 more: 1, 0.
    assert base64.b64decode(packed([1, 151], [-1, -1])) == bytes([2, 2, 0b10101100, 0b10, 1, 0])


def test_no_rows_are_one_byte() -> None:
    assert base64.b64decode(packed([], [])) == b"\0"
    assert unpacked(packed([], []), 2) == [[], []]


@given(st.lists(st.tuples(NUMBERS, NUMBERS, NUMBERS)))
def test_what_is_packed_comes_back(rows: List[List[int]]) -> None:
    columns = [[row[number] for row in rows] for number in range(3)]
    assert unpacked(packed(*columns), 3) == columns
