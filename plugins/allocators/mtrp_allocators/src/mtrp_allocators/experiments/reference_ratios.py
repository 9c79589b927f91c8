"""Mean ratios to the optimum that another implementation measured on the same instances, 30 of each size.

Rounded to three digits; UEM with alpha = 0.6. What ``ratios`` prints its own means beside.
"""

from __future__ import annotations

from typing import Dict, Iterable, Optional, Tuple

__all__ = ["reference_mean"]

_ROBOTS = (1, 2, 3, 5, 10, 20, 30, 50)
_TARGETS = (10, 20, 30, 40, 50)

# A row for each number of robots, a column for each number of targets.
_MEANS: Dict[str, Tuple[Tuple[float, ...], ...]] = {
    "EYH": (
        (1.076, 1.138, 1.143, 1.164, 1.174),
        (1.060, 1.095, 1.111, 1.154, 1.150),
        (1.037, 1.097, 1.087, 1.113, 1.108),
        (1.023, 1.043, 1.085, 1.088, 1.084),
        (1.013, 1.029, 1.045, 1.044, 1.054),
        (1.007, 1.013, 1.022, 1.029, 1.038),
        (1.004, 1.015, 1.014, 1.017, 1.025),
        (1.003, 1.006, 1.010, 1.010, 1.015),
    ),
    "UEM": (
        (1.039, 1.078, 1.097, 1.107, 1.132),
        (1.030, 1.082, 1.125, 1.103, 1.127),
        (1.045, 1.058, 1.073, 1.089, 1.128),
        (1.023, 1.038, 1.081, 1.102, 1.104),
        (1.015, 1.022, 1.039, 1.060, 1.046),
        (1.005, 1.017, 1.029, 1.030, 1.033),
        (1.004, 1.018, 1.017, 1.019, 1.034),
        (1.004, 1.007, 1.009, 1.011, 1.018),
    ),
    "PRIM-ORG": (
        (1.136, 1.246, 1.251, 1.266, 1.303),
        (1.116, 1.227, 1.247, 1.274, 1.268),
        (1.093, 1.200, 1.229, 1.256, 1.252),
        (1.089, 1.150, 1.238, 1.239, 1.248),
        (1.044, 1.099, 1.151, 1.181, 1.189),
        (1.045, 1.070, 1.077, 1.120, 1.137),
        (1.028, 1.053, 1.090, 1.083, 1.110),
        (1.026, 1.025, 1.032, 1.053, 1.064),
    ),
    "PRIM-SD": (
        (1.115, 1.162, 1.190, 1.188, 1.225),
        (1.091, 1.138, 1.177, 1.171, 1.213),
        (1.059, 1.136, 1.159, 1.191, 1.167),
        (1.058, 1.110, 1.132, 1.151, 1.165),
        (1.030, 1.080, 1.097, 1.116, 1.121),
        (1.028, 1.048, 1.064, 1.082, 1.090),
        (1.023, 1.042, 1.060, 1.058, 1.085),
        (1.026, 1.021, 1.030, 1.040, 1.046),
    ),
    "SSI": (
        (1.050, 1.091, 1.099, 1.148, 1.117),
        (1.032, 1.066, 1.086, 1.090, 1.122),
        (1.025, 1.078, 1.055, 1.085, 1.103),
        (1.014, 1.042, 1.064, 1.074, 1.061),
        (1.011, 1.028, 1.032, 1.038, 1.039),
        (1.005, 1.012, 1.016, 1.024, 1.025),
        (1.002, 1.014, 1.013, 1.013, 1.027),
        (1.003, 1.005, 1.009, 1.008, 1.012),
    ),
}


def reference_mean(method: str, sizes: Iterable[Tuple[int, int]]) -> Optional[float]:
    """Give the mean over sizes.

    Args:
        method: as tables name it.
        sizes: numbers of robots and targets.

    Returns:
        None if there is no size, or one of which the reference says nothing for this method.
    """
    means = []
    for robots, targets in sizes:
        if method not in _MEANS or robots not in _ROBOTS or targets not in _TARGETS:
            return None
        means.append(_MEANS[method][_ROBOTS.index(robots)][_TARGETS.index(targets)])
    return sum(means) / len(means) if means else None
