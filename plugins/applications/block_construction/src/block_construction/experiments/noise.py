"""Part ``noise``: how many builds stand whole where robots are told poses that are off (figure 48)."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Sequence, Tuple

from team_measures.statistics.estimates import Estimate, estimated_mean, estimated_share
from team_measures.statistics.tables import MEANS, SHARES, estimate_text, share_text

from block_construction.experiments.builds import APPLICATION, build_of
from block_construction.experiments.part import Options
from block_construction.experiments.published_builds import NOISE_LIMITS
from block_construction.pictures.noise_curve import NoisyBuilds, noise_curve
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Experiment, Laboratory, Trial

__all__ = ["measure_noise"]

_NOISES = (0.0, 0.008, 0.02, 0.03)
_HOLDS = (0.0, 60.0)
"""So long an error lasts [s]; within a minute a robot fetches or places, seldom both."""
_SIGHT_NOISE = 0.003
"""Standard deviation of where robots see blocks, in x and in y [m]; so it does not know exactly how it holds them."""
_LABELS = {0.0: "an error for each pose", 60.0: "errors that last 60 s"}
_SEEDS = 20
_STRUCTURE, _SMALL_STRUCTURE = "cistern", "wall"


class _Case(NamedTuple):
    """What poses are like.

    Attributes:
        noise: they are off by up to so much in x and in y [m].
        hold: how long one such error lasts [s].
    """

    noise: float
    hold: float

    @property
    def settings(self) -> Tuple[str, ...]:
        """As ``--set`` takes them."""
        return (f"pose_noise={self.noise}", f"pose_hold={self.hold}", f"sight_noise={_SIGHT_NOISE}")


def measure_noise(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let one robot build under errors of x and y, drawn anew for each pose it is told, and such that last."""
    seeds = options.repetitions(_SEEDS)
    structure = _SMALL_STRUCTURE if options.quick else _STRUCTURE
    cases = [_Case(noise, hold) for hold in _HOLDS for noise in _NOISES if noise or not hold]
    experiments = [
        Experiment(APPLICATION, seed, robots=1, settings=(f"structure={structure}", *case.settings))
        for case in cases
        for seed in range(1, seeds + 1)
    ]
    trials = laboratory.trials(experiments)
    found: Dict[_Case, List[Trial]] = {case: [next(trials) for _ in range(seeds)] for case in cases}
    table = BenchmarkTable(
        f"Figure 48: the {structure}, {seeds} builds for each error of poses",
        (
            *("error up to [cm]", "lasts [s]", "stand whole", "blocks placed [%]"),
            *("mean error [mm]", "max error [mm]", "time [min]", "source's cistern"),
        ),
        tuple([_row(case, builds) for case, builds in found.items()]),
        (
            "x and y of poses are off by numbers evenly distributed within the error; headings are exact.",
            f"Each look at a block is off with a standard deviation of {_SIGHT_NOISE:g} m in x and in y.",
            "Lasts 0 s: drawn for each pose. What a robot averages while it stands; no averaging removes what lasts.",
            "Wheels count with the errors of table 18; what they count is fused with the poses.",
            "Whole: every slot filled as it should be: within 2 cm, 5 mm of height and 10 degrees.",
            SHARES,
            MEANS,
        ),
    )
    # Without any error it does not matter how long it lasts: those builds begin both curves.
    lines = {
        _LABELS[hold]: [
            NoisyBuilds(case.noise, sum(map(_stands, builds)), seeds)
            for case, builds in found.items()
            if case.hold == hold or not case.noise
        ]
        for hold in _HOLDS
    }
    return BenchmarkReport((table,), (noise_curve(f"Builds of the {structure} by one robot", lines),))


def _row(case: _Case, trials: Sequence[Trial]) -> Tuple[Any, ...]:
    builds = [build_of(trial) for trial in trials]
    whole = estimated_share(sum(map(_stands, trials)), len(trials))
    errors = [1000.0 * build["mean_error"] for build in builds if build["mean_error"] is not None]
    worst = max((1000.0 * build["max_error"] for build in builds if build["max_error"] is not None), default=None)
    minutes = _mean([(build["fetching"]["seconds"] + build["placing"]["seconds"]) / 60.0 for build in builds])
    limit = NOISE_LIMITS.get(case.noise)
    return (
        *(100.0 * case.noise, case.hold if case.noise else None, share_text(whole)),
        estimate_text(_mean([100.0 * _share(trial) for trial in trials])),
        *(estimate_text(estimated_mean(errors), 2), worst, estimate_text(minutes)),
        None if limit is None else "stands" if limit else "fails",
    )


def _stands(trial: Trial) -> bool:
    return _share(trial) >= 1.0


def _share(trial: Trial) -> float:
    build = build_of(trial)
    return float(build["placed"] / build["blocks"])


def _mean(values: List[float]) -> Estimate:
    mean = estimated_mean(values)
    if mean is None:
        raise ValueError("no builds were measured")
    return mean
