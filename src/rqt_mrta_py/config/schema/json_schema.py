"""JSON Schemas, written from the tables of YAML files; editors check and complete such files by them."""

from __future__ import annotations

import json
from typing import Any, Dict, List

from rqt_mrta_py.config.yaml.schema import REQUIRED, Key, Table, ValueType

__all__ = ["json_schema"]

_DIALECT = "https://json-schema.org/draft/2020-12/schema"
_TEXT: Dict[str, Any] = {"type": "string", "pattern": r"\S"}


def json_schema(table: Table) -> str:
    """Write the schema of a file.

    Args:
        table: its keys. What tables do not say, such as ids that stand twice, no schema can check either.

    Returns:
        JSON, ending in a line break.
    """
    schema = {"$schema": _DIALECT, "title": table.name, **_mapping(table)}
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


def _mapping(table: Table) -> Dict[str, Any]:
    known = {key.name: _value(key) for key in table.keys}
    schema: Dict[str, Any] = {"type": "object", "description": table.summary, "properties": known}
    required = [key.name for key in table.keys if key.default is REQUIRED]
    if required:
        schema["required"] = required
    if not table.variants:
        schema["additionalProperties"] = table.further
        return schema
    schema["oneOf"] = [_variant(table, value, variant) for value, variant in table.variants.items()]
    return {**schema, "unevaluatedProperties": table.further}


def _variant(table: Table, value: str, variant: Table) -> Dict[str, Any]:
    required = [key.name for key in variant.keys if key.default is REQUIRED]
    return {
        "description": variant.summary,
        "properties": {table.by: {"const": value}, **{key.name: _value(key) for key in variant.keys}},
        **({"required": required} if required else {}),
    }


def _value(key: Key) -> Dict[str, Any]:
    schema = {"description": f"{key.summary} [{key.unit}]" if key.unit else key.summary, **_type(key)}
    if key.default is REQUIRED:
        return schema
    if key.default is not None:
        schema["default"] = list(key.default) if isinstance(key.default, tuple) else key.default
    # A key without a value takes its default.
    if "enum" in schema:
        schema["enum"] = [*schema["enum"], None]
    schema["type"] = [schema["type"], "null"]
    return schema


def _type(key: Key) -> Dict[str, Any]:
    kind = key.type
    if kind is ValueType.TABLE and key.table is not None:
        return _without_text(_mapping(key.table))
    if kind is ValueType.TABLES and key.table is not None:
        return {"type": "array", "items": _mapping(key.table)}
    if kind is ValueType.TEXTS:
        return {"type": "array", "items": _text(key)}
    if kind is ValueType.GROUPS:
        return {"type": "array", "items": {"type": "array", "items": _text(key)}}
    if kind is ValueType.NUMBERS:
        size = {} if key.count is None else {"minItems": key.count, "maxItems": key.count}
        return {"type": "array", "items": _number(key, "number"), **size}
    if kind is ValueType.TEXT:
        return _text(key)
    if kind is ValueType.SWITCH:
        return {"type": "boolean"}
    if kind is ValueType.FREE:
        return {"type": "object"}
    return _number(key, "integer" if kind is ValueType.WHOLE else "number")


def _text(key: Key) -> Dict[str, Any]:
    if key.choices:
        return {"type": "string", "enum": list(key.choices)}
    return {"type": "string"} if key.blank else dict(_TEXT)


def _number(key: Key, name: str) -> Dict[str, Any]:
    bounds = {"minimum": key.minimum, "maximum": key.maximum, "exclusiveMinimum": key.above}
    return {"type": name, **{bound: value for bound, value in bounds.items() if value is not None}}


def _without_text(schema: Dict[str, Any]) -> Dict[str, Any]:
    names: List[str] = [name for name in schema if name != "description"]
    return {name: schema[name] for name in names}
