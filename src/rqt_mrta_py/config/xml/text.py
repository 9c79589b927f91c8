"""From XML text to an element tree: no entities, no network, no document type, no surprise.

Texts also come out of bags that strangers recorded, so a hostile one must end in one clear problem. Python's expat
walks over the text first and stops at the first declaration of an entity, before anything could be expanded.
"""

from __future__ import annotations

import re
from typing import Any, Optional, Tuple, Union
from xml.parsers import expat

from lxml import etree

from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["decode_xml", "joined", "line_of", "lines_of", "parse_xml"]

_WRAP = re.compile(r"\s*[\r\n]\s*")
_POSITION = re.compile(r",? line \d+, column \d+.*\Z", re.DOTALL)
_ENCODING = re.compile(rb"""\A\s*<\?xml[^>]*?encoding\s*=\s*["']([A-Za-z0-9._-]+)["']""")


class _EntityDeclaredError(Exception):
    """An entity is declared in this line."""

    def __init__(self, line: int, name: str) -> None:
        super().__init__(name)
        self.line = line
        self.name = name


def parse_xml(text: Union[str, bytes], path: str) -> etree._Element:
    """Parse a whole document.

    Args:
        text: the document; of a str, the declared encoding is disregarded.
        path: by which problems name it.

    Returns:
        The root element, comments and processing instructions left out.

    Raises:
        ConfigError: the text is not well-formed, or declares entities.
    """
    raw = text.encode("utf-8", "surrogatepass") if isinstance(text, str) else text
    encoding = "utf-8" if isinstance(text, str) else None
    try:
        _refuse_entities(raw, encoding)
        root = etree.fromstring(raw, _parser(encoding))
        # An encoding that expat does not know hides declarations from it.
        dtd: Any = root.getroottree().docinfo.internalDTD
        for entity in dtd.iterentities() if dtd is not None else ():
            raise _EntityDeclaredError(0, str(entity.name))
    except _EntityDeclaredError as error:
        message = f"declares the entity {error.name!r}; entities are not accepted"
        raise ConfigError([Problem(path, error.line, "", message)]) from error
    except (etree.XMLSyntaxError, LookupError, ValueError) as error:
        reason = " ".join(_POSITION.sub("", str(error)).split()) or "it is empty"
        line = getattr(error, "lineno", None) or 1
        raise ConfigError([Problem(path, line, "", f"is not well-formed XML: {reason}")]) from error
    return root


def decode_xml(raw: bytes) -> str:
    """Turn a document's bytes into text, by its byte order mark, its declaration, or as UTF-8.

    Args:
        raw: a document that ``parse_xml`` accepts.

    Returns:
        The text; what its encoding does not allow is replaced.
    """
    for mark, encoding in ((b"\xef\xbb\xbf", "utf-8-sig"), (b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16")):
        if raw.startswith(mark):
            return raw.decode(encoding, "replace")
    declared = _ENCODING.match(raw)
    try:
        return raw.decode(declared.group(1).decode("ascii") if declared else "utf-8", "replace")
    except LookupError:
        return raw.decode("utf-8", "replace")


def joined(text: Optional[str]) -> str:
    """Give a text as files mean it: trimmed, wrapped lines joined by one space; empty for None."""
    return _WRAP.sub(" ", (text or "").strip())


def line_of(node: etree._Element) -> int:
    """Give the 1-based line on which an element begins; 0 if unknown."""
    line: Any = node.sourceline
    return int(line or 0)


def lines_of(node: etree._Element) -> Tuple[int, int]:
    """Give the 1-based lines on which an element begins, and the last one within it."""
    return line_of(node), max(map(line_of, node.iter()))


def _parser(encoding: Union[str, None]) -> etree.XMLParser:
    return etree.XMLParser(
        encoding=encoding,
        resolve_entities=False,
        no_network=True,
        load_dtd=False,
        dtd_validation=False,
        huge_tree=False,
        recover=False,
        remove_comments=True,
        remove_pis=True,
    )


def _refuse_entities(raw: bytes, encoding: Union[str, None]) -> None:
    walker = expat.ParserCreate(encoding)

    def declared(name: str, *_: object) -> None:
        raise _EntityDeclaredError(walker.CurrentLineNumber, name)

    walker.EntityDeclHandler = declared
    try:
        walker.Parse(raw, True)
    except (expat.ExpatError, LookupError, ValueError):
        return  # lxml says better what is wrong
