"""Reading of TSPLIB files: what is accepted, and all that is wrong with one that is not."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Callable, List, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_demir_cf.planning.tsplib import TsplibError, parse_tsplib, read_tsplib

HEADER = "NAME: tiny\nTYPE: TSP\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\n"
WHOLE = HEADER + "NODE_COORD_SECTION\n1 3 4\n2 5.5 6e1\nEOF\n"


def problems(text: str) -> List[str]:
    with pytest.raises(TsplibError) as caught:
        parse_tsplib(text, "tiny.tsp")
    return str(caught.value).splitlines()


@pytest.mark.parametrize(
    "text",
    [
        WHOLE,
        WHOLE.replace(":", " :"),
        WHOLE.replace(":", " : ").replace("\n", "  \n"),
        WHOLE.replace("\n", "\r\n"),
        WHOLE.replace("\n", "\n\n"),
        WHOLE.replace("EOF\n", ""),
        WHOLE.replace("EUC_2D", "ATT"),
        WHOLE.replace("1 3 4\n2 5.5 6e1\n", "  2\t5.5 60\n 1 3.0 4.000\n"),
        WHOLE.replace("TYPE: TSP\n", "COMMENT: one: two\nCOMMENT: three\n"),
        WHOLE + "\nwhat stands after the end",
    ],
)
def test_variants_of_the_format_are_read(text: str) -> None:
    instance = parse_tsplib(text, "tiny.tsp")
    assert instance.name == "tiny"
    assert instance.cities.tolist() == [[3.0, 4.0], [5.5, 60.0]]


def test_a_file_without_a_name_is_called_like_the_file() -> None:
    assert parse_tsplib(WHOLE.replace("NAME: tiny\n", ""), "some/where/small.tsp").name == "small"


def test_cities_that_coincide_are_read() -> None:
    assert parse_tsplib(WHOLE.replace("5.5 6e1", "3 4"), "tiny.tsp").cities.tolist() == [[3.0, 4.0], [3.0, 4.0]]


@pytest.mark.parametrize(
    ("name", "count", "first", "last"),
    [("att48", 48, [6734, 1453], [3023, 1942]), ("berlin52", 52, [565, 575], [1740, 245])],
)
def test_files_of_the_library_are_read(
    name: str, count: int, first: List[float], last: List[float], shared_data: Callable[[str], Path]
) -> None:
    instance = read_tsplib(shared_data(f"tsplib/{name}.tsp"))
    assert (instance.name, len(instance.cities)) == (name, count)
    assert [instance.cities[0].tolist(), instance.cities[-1].tolist()] == [first, last]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            WHOLE.replace("2 5.5 6e1\nEOF\n", ""),
            "tiny.tsp:6: NODE_COORD_SECTION: ends after 1 of 2 cities, without city 2; is the file cut short?",
        ),
        (HEADER, "tiny.tsp:4: NODE_COORD_SECTION: is missing; the cities' coordinates are needed"),
        (
            WHOLE.replace("6e1", ""),
            "tiny.tsp:7: NODE_COORD_SECTION: holds '2 5.5'; a line of it is a city's number, x and y",
        ),
        (
            WHOLE.replace("6e1", "nan"),
            "tiny.tsp:7: NODE_COORD_SECTION: holds '2 5.5 nan'; a line of it is a city's number, x and y, "
            "finite numbers and no more",
        ),
        (
            WHOLE.replace("2 5.5", "1 5.5"),
            "tiny.tsp:7: NODE_COORD_SECTION: holds city 1 again, first in line 6; each city stands once",
        ),
        (
            WHOLE.replace("2 5.5", "3 5.5"),
            "tiny.tsp:7: NODE_COORD_SECTION: holds city 3; cities are numbered 1 to DIMENSION, 2",
        ),
        (WHOLE.replace("EUC_2D", "GEO"), "tiny.tsp:4: EDGE_WEIGHT_TYPE: is 'GEO'; accepted: EUC_2D, ATT"),
        (
            WHOLE.replace("EDGE_WEIGHT_TYPE: EUC_2D\n", ""),
            "tiny.tsp:7: EDGE_WEIGHT_TYPE: is missing; accepted: EUC_2D, ATT",
        ),
        (WHOLE.replace("TYPE: TSP", "TYPE: CVRP"), "tiny.tsp:2: TYPE: is 'CVRP'; accepted: TSP"),
        (
            WHOLE.replace("DIMENSION: 2", "DIMENSION: two"),
            "tiny.tsp:3: DIMENSION: is 'two'; give the number of cities, at least 1",
        ),
        (
            WHOLE.replace("DIMENSION: 2\n", ""),
            "tiny.tsp:7: DIMENSION: is 'missing'; give the number of cities, at least 1",
        ),
        (
            WHOLE.replace("DIMENSION: 2", "DIMENSION: 2\nDIMENSION: 2"),
            "tiny.tsp:4: DIMENSION: is given again, first in line 3; give it once",
        ),
        ("tiny\n" + WHOLE, "tiny.tsp:1: tiny: is no entry; an entry is a keyword, a colon and a value"),
    ],
)
def test_what_is_wrong_is_said(text: str, expected: str) -> None:
    assert problems(text) == [expected]


def test_everything_wrong_is_said_at_once() -> None:
    text = WHOLE.replace("TYPE: TSP", "TYPE: TOUR").replace("1 3 4", "one 3 4").replace("DIMENSION: 2", "DIMENSION: 0")
    assert [problem.split(": ")[1] for problem in problems(text)] == ["NODE_COORD_SECTION", "TYPE", "DIMENSION"]


def test_an_empty_file_lacks_what_is_needed() -> None:
    assert [problem.split(": ")[1] for problem in problems("")] == [
        "EDGE_WEIGHT_TYPE",
        "NODE_COORD_SECTION",
        "DIMENSION",
    ]


def test_a_file_that_is_not_there_is_told(tmp_path: Path) -> None:
    path = tmp_path / "none.tsp"
    with pytest.raises(TsplibError, match=f"^{re.escape(str(path))}: cannot be read \\(No such file or directory\\)"):
        read_tsplib(path)


coordinates = st.floats(allow_nan=False, allow_infinity=False)


@given(st.lists(st.tuples(coordinates, coordinates), min_size=1, max_size=9))
def test_what_is_written_is_read(cities: List[Tuple[float, float]]) -> None:
    lines = [f"{number} {x!r} {y!r}" for number, (x, y) in enumerate(cities, start=1)]
    text = f"DIMENSION : {len(cities)}\nEDGE_WEIGHT_TYPE : ATT\nNODE_COORD_SECTION\n" + "\n".join(lines)
    assert list(map(tuple, parse_tsplib(text, "any.tsp").cities.tolist())) == cities


def refusal(text: str) -> str:
    """Give the text of the error, empty where the file is read."""
    try:
        parse_tsplib(text, "tiny.tsp")
    except TsplibError as error:
        return str(error)
    return ""


def test_a_file_cut_short_is_read_only_where_every_line_is_whole() -> None:
    cuts = [WHOLE[:length] for length in range(len(WHOLE))]
    # A number that has lost digits at the very end cannot be told from a shorter one.
    assert [cut[-4:] for cut in cuts if not refusal(cut)] == [".5 6", " 6e1", "6e1\n", "\nEOF"]


@given(st.text(alphabet=st.sampled_from(list("DIMENSION:EUC_2 TSPOF\n0159.-eENAME"))))
def test_any_text_is_read_or_refused_in_words(text: str) -> None:
    assert all(problem.startswith("tiny.tsp:") for problem in refusal(HEADER + text).splitlines())
