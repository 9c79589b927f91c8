"""The package.xml of a new package."""

from __future__ import annotations

from typing import Iterable, Mapping, Sequence, Tuple

from lxml import etree

from rqt_mrta_py.config.packages.description import PackageDescription

__all__ = ["manifest_text"]

_HEAD = (
    '<?xml version="1.0"?>\n'
    '<?xml-model href="http://download.ros.org/schema/package_format3.xsd" '
    'schematypens="http://www.w3.org/2001/XMLSchema"?>\n'
)


def manifest_text(
    described: PackageDescription,
    dependencies: Sequence[Tuple[str, Iterable[str]]],
    exported: Mapping[str, str],
) -> str:
    """Write a manifest of format 3.

    Args:
        described: its head.
        dependencies: names by kind, such as ``exec_depend``, in the order to be written.
        exported: attributes of the export tag ``rqt_mrta_py``.

    Returns:
        The whole file.
    """
    root = etree.Element("package", format="3")
    _leaf(root, "name", described.package)
    _leaf(root, "version", described.version)
    _leaf(root, "description", described.description)
    _leaf(root, "maintainer", described.maintainer).set("email", described.email)
    _leaf(root, "license", described.license)
    for kind, names in dependencies:
        for name in sorted(set(names)):
            _leaf(root, kind, name)
    tag = etree.SubElement(etree.SubElement(root, "export"), "rqt_mrta_py")
    for name, value in exported.items():
        tag.set(name, value)
    etree.indent(root, "  ")
    return _HEAD + str(etree.tostring(root, encoding="unicode")) + "\n"


def _leaf(parent: etree._Element, name: str, text: str) -> etree._Element:
    leaf = etree.SubElement(parent, name)
    leaf.text = text
    return leaf
