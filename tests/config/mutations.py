"""Files made hostile: cut, swapped, repeated, re-encoded, stuffed with what parsers choke on."""

from __future__ import annotations

import random
import re
from typing import Callable, List, Sequence

from lxml import etree

__all__ = ["mutated_xml", "mutated_yaml"]

_NUMBERS = [b"0", b"-1", b"9" * 400, b"1e999", b"-0.0", b"nan", b"inf", b"1_000", b"0x1f", b"1.0e-400", b"00", b"+3"]
_TOKENS = [b"@index@", b"@task_id@", b"@robot_id@", b"@array_size@", b"@package@", b"/", b"//", b" ", b"\t", b"\r\n"]
_BYTES = [b"\0", b"\xff", b"\xfe\xff", b"\xef\xbb\xbf", b"\x1b[31m", b"\xed\xa0\x80", b"\xe2\x80\xae", b"\x85", b"\xa0"]
_XML = [
    b"<",
    b">",
    b"</",
    b"&",
    b"&lt;",
    b"&#0;",
    b"&#xD800;",
    b"<![CDATA[",
    b"]]>",
    b"<!--",
    b"-->",
    b"<?x ?>",
    b"<a/>",
]
_DOCTYPES = [
    b"<!DOCTYPE rqt_mrta>",
    b'<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;&b;&b;">]>',
    b'<!DOCTYPE a [<!ENTITY a SYSTEM "file:///etc/passwd">]>',
    b'<!DOCTYPE a [<!ENTITY % p SYSTEM "file:///etc/passwd"> %p;]>',
    b'<!DOCTYPE a SYSTEM "file:///dev/zero">',
]
_YAML = [
    b": ",
    b"- ",
    b"\n",
    b"&a ",
    b"*a",
    b"!!int ",
    b"!!python/object:os.system ",
    b"? ",
    b"|",
    b">",
    b"'",
    b'"',
    b"---",
]
_YAML += [
    b"{",
    b"}",
    b"[",
    b"]",
    b"#",
    b"%",
    b"...",
    b"<<: ",
    b"~",
    b"\\U99999999",
    b"=",
    b"0o7",
    b"1:30",
    b"2001-01-01",
]
_ENCODINGS = ["utf-16", "utf-16-le", "utf-32", "latin-1", "cp037", "utf-7", "utf-8-sig"]
_DECLARED = [b"UTF-16", b"latin-1", b"Shift_JIS", b"martian", b"UCS-4", b"ascii", b"EBCDIC-CP-US", b""]

_Step = Callable[[random.Random, bytes], bytes]


def mutated_xml(chance: random.Random, seeds: Sequence[bytes]) -> bytes:
    """Make a hostile XML file.

    Args:
        chance: where all choices come from.
        seeds: sound files.
    """
    raw = chance.choice(seeds)
    if chance.random() < 0.6:
        raw = _change_tree(chance, raw)
    for _ in range(chance.choice([0, 1, 1, 1, 2, 3, 6])):
        raw = chance.choice([*_ANY, _insert_of(_XML), _declare, _add_doctype, _deepen_xml])(chance, raw)
    return raw


def mutated_yaml(chance: random.Random, seeds: Sequence[bytes]) -> bytes:
    """Make a hostile YAML file.

    Args:
        chance: where all choices come from.
        seeds: sound files.
    """
    raw = chance.choice(seeds)
    for _ in range(chance.choice([1, 1, 1, 2, 3, 6])):
        raw = chance.choice([*_ANY, _insert_of(_YAML), _change_lines, _change_lines, _change_value, _deepen_yaml])(
            chance, raw
        )
    return raw


def _slice(chance: random.Random, raw: bytes) -> slice:
    start = chance.randint(0, len(raw))
    return slice(start, min(len(raw), start + chance.choice([1, 1, 3, 10, 60, 400])))


def _cut(chance: random.Random, raw: bytes) -> bytes:
    return raw[: chance.randint(0, len(raw))]


def _drop(chance: random.Random, raw: bytes) -> bytes:
    place = _slice(chance, raw)
    return raw[: place.start] + raw[place.stop :]


def _repeat(chance: random.Random, raw: bytes) -> bytes:
    place = _slice(chance, raw)
    return raw[: place.stop] + raw[place] * chance.choice([1, 1, 2, 50]) + raw[place.stop :]


def _swap(chance: random.Random, raw: bytes) -> bytes:
    one, other = sorted((_slice(chance, raw), _slice(chance, raw)), key=lambda place: place.start)
    if one.stop > other.start:
        return raw
    return raw[: one.start] + raw[other] + raw[one.stop : other.start] + raw[one] + raw[other.stop :]


def _flip(chance: random.Random, raw: bytes) -> bytes:
    if not raw:
        return raw
    place = chance.randrange(len(raw))
    return raw[:place] + bytes([chance.randrange(256)]) + raw[place + 1 :]


def _recode(chance: random.Random, raw: bytes) -> bytes:
    return raw.decode("utf-8", "replace").encode(chance.choice(_ENCODINGS), "replace")


def _change_number(chance: random.Random, raw: bytes) -> bytes:
    numbers = list(re.finditer(rb"[0-9]+(\.[0-9]+)?", raw))
    if not numbers:
        return raw
    found = chance.choice(numbers)
    return raw[: found.start()] + chance.choice(_NUMBERS) + raw[found.end() :]


def _insert_of(what: Sequence[bytes]) -> _Step:
    def insert(chance: random.Random, raw: bytes) -> bytes:
        place = chance.randint(0, len(raw))
        return raw[:place] + chance.choice(what) * chance.choice([1, 1, 1, 2, 300]) + raw[place:]

    return insert


_ANY: List[_Step] = [
    _cut,
    _drop,
    _repeat,
    _swap,
    _flip,
    _recode,
    _change_number,
    _insert_of(_BYTES),
    _insert_of(_TOKENS),
]


def _declare(chance: random.Random, raw: bytes) -> bytes:
    declaration = b'<?xml version="1.0" encoding="' + chance.choice(_DECLARED) + b'"?>'
    return declaration + re.sub(rb"\A<\?xml[^>]*\?>", b"", raw)


def _add_doctype(chance: random.Random, raw: bytes) -> bytes:
    head = re.match(rb"\A\s*(<\?xml[^>]*\?>)?", raw)
    place = head.end() if head is not None else 0
    rest = raw[place:]
    if chance.random() < 0.5:
        rest = rest.replace(b"</", chance.choice([b"&a;", b"&c;", b"&lt;"]) + b"</", 3)
    return raw[:place] + chance.choice(_DOCTYPES) + rest


def _deepen_xml(chance: random.Random, raw: bytes) -> bytes:
    kind = chance.choice([b"params_0", b"array_0", b"x"])
    depth = chance.choice([3, 60, 120, 5000])
    place = raw.find(b">", chance.randint(0, len(raw))) + 1
    name = b"<name>n</name>"
    return raw[:place] + (b"<" + kind + b">" + name) * depth + (b"</" + kind + b">") * depth + raw[place:]


def _change_tree(chance: random.Random, raw: bytes) -> bytes:
    """Change whole elements, so that the text stays well-formed."""
    root = etree.fromstring(raw)
    for _ in range(chance.choice([1, 1, 2, 4])):
        nodes = [node for node in root.iter() if isinstance(node.tag, str)]
        node, other = chance.choice(nodes), chance.choice(nodes)
        what = chance.randrange(8)
        if what == 0:
            node.tag = other.tag
        elif what == 1:
            node.tag = re.sub(r"[0-9]+\Z", lambda _: chance.choice(["1", "007", "99", "9" * 30, ""]), node.tag) or "x"
        elif what == 2 and node.getparent() is not None:
            node.getparent().remove(node)
        elif what == 3 and node.getparent() is not None:
            node.addnext(etree.fromstring(etree.tostring(node, with_tail=False)))
        elif what == 4:
            node.text = other.text
        elif what == 5:
            node.text = chance.choice([*_NUMBERS, *_TOKENS, b"true", b"a b", b"<&>", b"1", b"10", b"x" * 5000]).decode()
        elif what == 6:
            node.set(
                chance.choice(["format", "x", "architecture", "plugin"]), chance.choice(["application", "", "a b"])
            )
        elif node.getparent() is not None and other not in [node, *node.iterancestors(), *node.iter()]:
            other.append(node)
    return etree.tostring(root)


def _change_lines(chance: random.Random, raw: bytes) -> bytes:
    lines = raw.split(b"\n")
    one, other = chance.randrange(len(lines)), chance.randrange(len(lines))
    what = chance.randrange(4)
    if what == 0:
        lines[one], lines[other] = lines[other], lines[one]
    elif what == 1:
        lines.insert(other, lines[one])
    elif what == 2:
        del lines[one]
    else:
        lines[one] = b" " * chance.randrange(9) + lines[one].lstrip()
    return b"\n".join(lines)


def _change_value(chance: random.Random, raw: bytes) -> bytes:
    values = list(re.finditer(rb":[ ]+([^\s,{}\[\]]+)", raw))
    if not values:
        return raw
    found = chance.choice(values)
    nasty = chance.choice(
        [*_NUMBERS, *_TOKENS, b"null", b"{}", b"[]", b"[[1]]", b"true", b"''", b"robot_stops", b".inf"]
    )
    return raw[: found.start(1)] + nasty + raw[found.end(1) :]


def _deepen_yaml(chance: random.Random, raw: bytes) -> bytes:
    opening, closing = chance.choice([(b"[", b"]"), (b"{a: ", b"}"), (b"- ", b""), (b"? ", b""), (b"&a [*a, ", b"]")])
    depth = chance.choice([3, 45, 60, 3000])
    place = chance.randint(0, len(raw))
    return raw[:place] + opening * depth + b"1" + closing * depth + raw[place:]
