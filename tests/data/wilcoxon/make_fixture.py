#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes wilcoxon.json: differences of pairs with scipy.stats.wilcoxon's statistic and one-sided p-values.

Run in this folder with a Python that has scipy (written with 1.10.1). p is null where scipy raises an error or
returns NaN."""
import json
import math
import warnings

import numpy as np
import scipy
from scipy.stats import wilcoxon

warnings.simplefilter("ignore")


def outcome(differences, alternative):
    try:
        result = wilcoxon(np.asarray(differences, dtype=float), alternative=alternative)
    except ValueError:
        return None, None
    if math.isnan(result.pvalue):
        return None, None
    return float(result.statistic), float(result.pvalue)


def main():
    rng = np.random.default_rng(3)
    cases = {
        "plants, scipy's example": [6, 8, 14, 16, 23, 24, 28, 29, 41, -48, 49, 56, 60, -67, 75],
        "empty": [],
        "one": [2.5],
        "one negative": [-2.5],
        "one zero": [0],
        "two": [1, -3],
        "two that tie": [1, -1],
        "all zeros": [0, 0, 0, 0],
        "zeros but one": [0, 0, 5, 0],
        "ties, no zeros": [1, 1, -1, 2, 2, -2, 3, 3, 3, -3],
        "ties that make half ranks": [1, -1, 2, 3, -4, 4, 5],
        "zeros and ties": [0, 1, -1, 2, 0, 2, -3, 3, 3, 4, 0, 5],
        "all the same": [2] * 12,
        "all but one negative": [-1, -2, -3, -4, -5, 0.5],
        "normal, 15": rng.normal(0.3, 1.0, 15).tolist(),
        "normal, 50": rng.normal(-0.2, 1.0, 50).tolist(),
        "normal, 51": rng.normal(-0.2, 1.0, 51).tolist(),
        "counts, 15": rng.integers(-6, 4, 15).tolist(),
        "counts, 48": rng.integers(-6, 4, 48).tolist(),
        "counts, 120": rng.integers(-9, 12, 120).tolist(),
        "normal, 300": rng.normal(0.05, 1.0, 300).tolist(),
        "50 with ties, no zeros": [value if value else 7 for value in rng.integers(-9, 9, 50).tolist()],
    }
    rows = []
    for name, differences in cases.items():
        statistic, less = outcome(differences, "less")
        _, greater = outcome(differences, "greater")
        rows.append({"name": name, "differences": differences, "statistic": statistic, "less": less,
                     "greater": greater})
    with open("wilcoxon.json", "w") as file:
        json.dump({"scipy": scipy.__version__, "cases": rows}, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
