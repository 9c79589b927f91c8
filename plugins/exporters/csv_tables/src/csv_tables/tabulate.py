"""The verb ``tabulate``: one line of CSV for each finished run or review."""

from __future__ import annotations

import os
import sys
import tempfile
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import List

from csv_tables.digest import Digest, columns_of, read_digest
from csv_tables.table import csv_bytes
from rqt_mrta_py.hooks import MrtaError, UsageError, Verb, VerbTools

__all__ = ["TABULATE"]

_HELP = "Write one line of CSV for each finished run or review."
_STDOUT = "-"


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("folders", metavar="FOLDER", nargs="+", type=Path, help="outputs of a run or review")
    parser.add_argument("--out", metavar="FILE", default=_STDOUT, help="where to write; - (the default) is stdout")
    parser.add_argument("--force", action="store_true", help="write over FILE if it is there")


def _main(options: Namespace, _tools: VerbTools) -> int:
    digests: List[Digest] = []
    problems: List[str] = []
    for folder in options.folders:
        try:
            digests.append(read_digest(folder))
        except ValueError as error:
            problems.append(str(error))
    if problems:
        raise MrtaError("\n".join(problems))
    columns = columns_of(digests)
    content = csv_bytes(columns, ([digest.get(column) for column in columns] for digest in digests))
    if options.out == _STDOUT:
        sys.stdout.buffer.write(content)
        sys.stdout.buffer.flush()
    else:
        _write(Path(options.out), content, force=options.force)
    return 0


TABULATE = Verb(_HELP, _add_arguments, _main)


def _write(path: Path, content: bytes, *, force: bool) -> None:
    """Write a file whole or not at all.

    Raises:
        UsageError: it is there already and shall not be written over.
        MrtaError: it cannot be written.
    """
    if path.exists() and not force:
        raise UsageError(f"{path}: is there already; --force writes over it")
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=f".{path.name}.", delete=False) as aside:
            try:
                aside.write(content)
                aside.flush()
                # NamedTemporaryFile lets nobody else read; a table is for others.
                os.chmod(aside.name, 0o644)  # noqa: PTH101 - the name, not a path, is at hand
                Path(aside.name).replace(path)
            except BaseException:
                Path(aside.name).unlink()
                raise
    except OSError as error:
        raise MrtaError(f"{path}: cannot be written: {error.strerror or error}") from error
