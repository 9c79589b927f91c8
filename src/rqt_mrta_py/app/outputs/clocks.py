"""What messages of a recorded mission tell of clocks and gaps."""

from __future__ import annotations

from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.model.timing import TimingTable
from rqt_mrta_py.supervisor.clocks import timing_document

__all__ = ["write_clocks"]


def write_clocks(folder: OutputFolder, table: TimingTable) -> None:
    """Write what is known of each connection.

    Args:
        folder: where to.
        table: of all connections.
    """
    folder.write_json("clocks.json", timing_document(table))
