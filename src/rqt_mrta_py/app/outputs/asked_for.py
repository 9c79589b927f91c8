"""What the user asks for by name among what plugins register."""

from __future__ import annotations

from typing import Any, List, Mapping, Sequence

from rqt_mrta_py.errors import UsageError

__all__ = ["asked_for"]


def asked_for(option: str, none: str, names: Sequence[str], registered: Mapping[str, Any]) -> List[str]:
    """Give the names that the user asks for, each once, in their order.

    Args:
        option: they were given to, for the message.
        none: says in the message that there is none such, as in ``there is no such exporter``.
        names: as given.
        registered: what there is, by name.

    Raises:
        UsageError: one of them is not registered; says which are.
    """
    for name in names:
        if name not in registered:
            known = ", ".join(sorted(registered)) or "none"
            raise UsageError(f"{option} {name}: {none}; there are: {known}")
    return list(dict.fromkeys(names))
