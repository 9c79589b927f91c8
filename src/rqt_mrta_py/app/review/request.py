"""What a user asks of a review."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional, Tuple

from rqt_mrta_py.app.live.interest import TopicChoice

__all__ = ["ReviewRequest"]


@dataclass(frozen=True)
class ReviewRequest:
    """What the user asks for.

    Attributes:
        bag: to review.
        more: other bags of the same mission, merged with it by time.
        start: what was received earlier is left out, from the first message on [s]; None: nothing.
        end: what was received later is left out, likewise [s]; None: nothing.
        topics: which to read.
        why: ids or patterns of tasks that are to be explained.
        application: a registered name or path that says what the bag is about; None to ask the bag itself.
        architecture: a registered name or path; None for the application's own.
        out: folder for the outputs; None to choose one.
        force: write into a folder that is not empty.
        pictures: seconds of mission time between pictures, 0 for none; None for the scenario's, else 1 [s].
        video: make a film of the pictures.
        exports: names of exporters whose files are wanted.
        figures: names of makers whose figures are wanted.
    """

    bag: Path
    application: Optional[str] = None
    architecture: Optional[str] = None
    out: Optional[Path] = None
    force: bool = False
    pictures: Optional[float] = None
    video: bool = False
    exports: Tuple[str, ...] = ()
    figures: Tuple[str, ...] = ()
    more: Tuple[Path, ...] = ()
    start: Optional[float] = None
    end: Optional[float] = None
    topics: TopicChoice = field(default_factory=TopicChoice)
    why: Tuple[str, ...] = ()
