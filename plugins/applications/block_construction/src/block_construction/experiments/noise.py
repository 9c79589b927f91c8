"""Part ``noise``: how many builds stand whole where robots are told poses that are off (figure 48)."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

from team_measures.statistics.estimates import Estimate, estimated_mean, estimated_share
from team_measures.statistics.tables import MEANS, SHARES, estimate_text, share_text

from block_construction.experiments.builds import APPLICATION, build_of
from block_construction.experiments.part import Options
from block_construction.experiments.published_builds import NOISE_LIMITS
from block_construction.pictures.noise_curve import NoisyBuilds, noise_curve
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Experiment, Laboratory, Trial

__all__ = ["measure_noise"]

_NOISES = (0.0, 0.008, 0.02, 0.03)
_SEEDS = 20
_STRUCTURE, _SMALL_STRUCTURE = "cistern", "wall"


def measure_noise(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let one robot build under errors of x and y that are drawn anew for each pose it is told."""
    seeds = options.repetitions(_SEEDS)
    structure = _SMALL_STRUCTURE if options.quick else _STRUCTURE
    experiments = [
        Experiment(APPLICATION, seed, robots=1, settings=(f"structure={structure}", f"pose_noise={noise}"))
        for noise in _NOISES
        for seed in range(1, seeds + 1)
    ]
    trials = laboratory.trials(experiments)
    found: Dict[float, List[Trial]] = {noise: [next(trials) for _ in range(seeds)] for noise in _NOISES}
    whole = [estimated_share(sum(map(_stands, found[noise])), seeds) for noise in _NOISES]
    placed = [_mean([100.0 * _share(trial) for trial in found[noise]]) for noise in _NOISES]
    rows: List[Tuple[Any, ...]] = []
    for noise, stands, share in zip(_NOISES, whole, placed):
        builds = [build_of(trial) for trial in found[noise]]
        errors = [1000.0 * build["mean_error"] for build in builds if build["mean_error"] is not None]
        worst = max((1000.0 * build["max_error"] for build in builds if build["max_error"] is not None), default=None)
        minutes = _mean([(build["fetching"]["seconds"] + build["placing"]["seconds"]) / 60.0 for build in builds])
        limit = NOISE_LIMITS.get(noise)
        rows.append(
            (
                *(100.0 * noise, share_text(stands), estimate_text(share), estimate_text(estimated_mean(errors), 2)),
                *(worst, estimate_text(minutes), None if limit is None else "stands" if limit else "fails"),
            )
        )
    table = BenchmarkTable(
        f"Figure 48: the {structure}, {seeds} builds for each error of poses",
        (
            *("error up to [cm]", "stand whole", "blocks placed [%]", "mean error [mm]", "max error [mm]"),
            *("time [min]", "source's cistern"),
        ),
        tuple(rows),
        (
            "x and y of each pose are off by numbers evenly distributed within the error; headings are exact.",
            "Wheels count with the errors of table 18; what they count is fused with the poses.",
            "Whole: every block within 2 cm of its slot's middle, on its level.",
            SHARES,
            MEANS,
        ),
    )
    curve = noise_curve(
        f"Builds of the {structure} by one robot",
        [NoisyBuilds(noise, sum(map(_stands, found[noise])), seeds) for noise in _NOISES],
    )
    return BenchmarkReport((table,), (curve,))


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
