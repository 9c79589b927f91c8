"""Reads places of cities from TSPLIB files: EUC_2D and ATT instances with coordinates.

G. Reinelt, TSPLIB: a traveling salesman problem library, ORSA Journal on Computing 3(4), 1991. Of the distances that a
file asks for nothing is taken over: both types are read for their coordinates, between which Euclidean distances are
meant, as Table 1 of Sariel, Erdogan and Balch (2007) takes them, att48 included.

Accepted: blanks around the colon and at line ends, blank lines, CRLF, integers and reals, a missing EOF, cities in any
order, cities that coincide.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Optional, Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats
from rqt_mrta_py.hooks import MrtaError

__all__ = ["TsplibError", "TsplibInstance", "parse_tsplib", "read_tsplib"]

_WEIGHTS = ("EUC_2D", "ATT")
_COORDINATES = "NODE_COORD_SECTION"
_LINE = "a line of it is a city's number, x and y"


class TsplibError(MrtaError):
    """A TSPLIB file cannot be read, or is of a kind that has no coordinates in the plane; says all that is wrong."""


@dataclass(frozen=True)
class TsplibInstance:
    """One instance.

    Attributes:
        name: as the file says, else the file's own.
        cities: (n, 2), in the order of their numbers 1 to n; the unit is the file's.
    """

    name: str
    cities: Floats


def read_tsplib(path: Path) -> TsplibInstance:
    """Read an instance from a file.

    Raises:
        TsplibError: see ``parse_tsplib``; or the file cannot be opened.
    """
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise TsplibError(f"{path}: cannot be read ({error.strerror}); give a TSPLIB file") from error
    return parse_tsplib(text, str(path))


def parse_tsplib(text: str, path: str) -> TsplibInstance:
    """Read an instance from the text of a file.

    Args:
        text: of the file.
        path: where it comes from, for errors and for the name of an instance without one.

    Raises:
        TsplibError: something is missing, cut short, given twice, no number, or of another kind; one line for each
            problem: path, line, entry, what was found, what is accepted.
    """
    reading = _Reading(path)
    for number, line in enumerate(text.splitlines(), start=1):
        reading.take(number, line.strip())
    return reading.finish()


class _Reading:
    """One file, read line by line."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._entries: Dict[str, Tuple[int, str]] = {}
        self._cities: Dict[int, Tuple[int, float, float]] = {}
        self._section: Optional[str] = None
        self._problems: List[str] = []
        self._last = 0

    def take(self, number: int, line: str) -> None:
        if not line or self._section == "EOF":
            return
        self._last = number
        word = re.split(r"[\s:]", line, maxsplit=1)[0]
        if ":" in line or word == "EOF" or word.endswith("_SECTION"):
            self._take_entry(number, word, line)
        elif self._section == _COORDINATES:
            self._take_city(number, line.split())
        elif self._section is None:
            self._refuse(number, line, "is no entry; an entry is a keyword, a colon and a value")

    def _take_entry(self, number: int, word: str, line: str) -> None:
        if ":" not in line or word.endswith("_SECTION"):
            self._section = word
        if word in self._entries and word != "COMMENT":
            self._refuse(number, word, f"is given again, first in line {self._entries[word][0]}; give it once")
        self._entries.setdefault(word, (number, line.partition(":")[2].strip()))

    def _take_city(self, number: int, words: List[str]) -> None:
        try:
            city, along_x, along_y = int(words[0]), float(words[1]), float(words[2])
        except (IndexError, ValueError):
            self._refuse(number, _COORDINATES, f"holds {' '.join(words)!r}; {_LINE}")
            return
        if len(words) > 3 or not (math.isfinite(along_x) and math.isfinite(along_y)):
            self._refuse(number, _COORDINATES, f"holds {' '.join(words)!r}; {_LINE}, finite numbers and no more")
        elif city in self._cities:
            first = self._cities[city][0]
            self._refuse(number, _COORDINATES, f"holds city {city} again, first in line {first}; each city stands once")
        else:
            self._cities[city] = (number, along_x, along_y)

    def finish(self) -> TsplibInstance:
        self._expect("TYPE", ("TSP",), needed=False)
        self._expect("EDGE_WEIGHT_TYPE", _WEIGHTS, needed=True)
        if _COORDINATES not in self._entries:
            self._refuse(self._last, _COORDINATES, "is missing; the cities' coordinates are needed")
        dimension = self._dimension()
        if dimension is not None and _COORDINATES in self._entries:
            self._check_cities(dimension)
        if self._problems:
            raise TsplibError("\n".join(self._problems))
        name = self._entries.get("NAME", (0, Path(self._path).stem))[1]
        places = [self._cities[city][1:] for city in sorted(self._cities)]
        return TsplibInstance(name, np.array(places, dtype=np.float64).reshape(-1, 2))

    def _expect(self, word: str, accepted: Tuple[str, ...], needed: bool) -> None:
        line, value = self._entries.get(word, (0, ""))
        if line and value.split(" ")[0] not in accepted:
            self._refuse(line, word, f"is {value!r}; accepted: {', '.join(accepted)}")
        elif not line and needed:
            self._refuse(self._last, word, f"is missing; accepted: {', '.join(accepted)}")

    def _dimension(self) -> Optional[int]:
        line, value = self._entries.get("DIMENSION", (self._last, "missing"))
        if not re.fullmatch(r"0*[1-9][0-9]{0,8}", value):
            self._refuse(line, "DIMENSION", f"is {value!r}; give the number of cities, at least 1")
            return None
        return int(value)

    def _check_cities(self, dimension: int) -> None:
        for city, (line, _, _) in self._cities.items():
            if not 1 <= city <= dimension:
                self._refuse(line, _COORDINATES, f"holds city {city}; cities are numbered 1 to DIMENSION, {dimension}")
        if len(self._cities) < dimension and not self._problems:
            missing = next(city for city in range(1, dimension + 1) if city not in self._cities)
            self._refuse(
                self._last,
                _COORDINATES,
                f"ends after {len(self._cities)} of {dimension} cities, without city {missing}; is the file cut short?",
            )

    def _refuse(self, line: int, entry: str, text: str) -> None:
        self._problems.append(f"{self._path}:{line}: {entry}: {text}")
