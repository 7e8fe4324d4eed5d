#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes local_test.csv, tests.csv and fits.csv: what CloudCompare's Local Statistical Test makes of a cloud.

local_test.csv: x, y, z, two columns of values, then CloudCompare's χ² distance a test of tests.csv.
tests.csv: column of values, distribution with its parameters, p-value, neighbours, CloudCompare's threshold and the
           exact one (scipy).
fits.csv: the distributions fitted to the values by numpy and scipy, as CloudCompare defines the fits (its command line
          takes parameters, it does not fit).

Made with CloudCompare 2.11.3, numpy and scipy 1.10.1. Run in this folder; needs CloudCompare and xvfb-run."""
import csv
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from scipy.optimize import brentq
from scipy.stats import chi2, weibull_min

FLOAT_EPSILON = float(np.finfo(np.float32).eps)


def cloud():
    """Two walls and a floor of uneven density, in float32, with a restless and a quiet spot."""
    rng = np.random.default_rng(20)
    floor = np.c_[rng.uniform(0, 2, (450, 2)), rng.normal(0, 0.005, 450)]
    wall = np.c_[rng.normal(0, 0.005, 200), 2 * rng.uniform(0, 1, 200) ** 2, rng.uniform(0, 1, 200)]
    spot = rng.normal([1.2, 0.7, 0.05], 0.04, (50, 3))
    points = np.vstack([floor, wall, spot]).astype(np.float32)
    gauss = rng.normal(0.02, 0.006, len(points))
    gauss[650:] += 0.03
    skewed = weibull_min.rvs(1.6, scale=0.015, size=len(points), random_state=rng)
    skewed[650:] += 0.04
    near_corner = np.linalg.norm(points - [0, 0, 0], axis=1) < 0.5
    skewed[near_corner] *= 0.1
    skewed[:5] = 0
    return points, {"gauss": gauss.astype(np.float32), "skewed": skewed.astype(np.float32)}


def fits(values):
    v = values.astype(float)
    over = v - v.min()
    logarithms = np.log(np.maximum(over, FLOAT_EPSILON))

    def slope(shape):
        powers = np.exp(shape * (logarithms - logarithms.max()))
        return (powers @ logarithms / powers.sum() - logarithms.mean()) * shape - 1

    shape = brentq(slope, 1e-3, 1e3, xtol=1e-14)
    scale = np.mean(over**shape) ** (1 / shape)
    return [["gauss", v.mean(), v.std(), 0], ["weibull", shape, scale, v.min()]]


def settled(points, values, test):
    """CloudCompare's threads share one histogram, so that a few points get a wrong distance, others in every run
    (with several processors most runs have many). One processor and the median of five runs keep these out."""
    runs = [cloudcompare(points, values, test) for _ in range(5)]
    return np.median([distance for distance, _ in runs], axis=0), runs[0][1]


def cloudcompare(points, values, test):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        np.savetxt(folder / "in.xyz", np.c_[points, values], fmt="%.9g")
        command = ["taskset", "-c", "0", "xvfb-run", "-a", "CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF",
                   "-C_EXPORT_FMT", "ASC", "-PREC", "9", "-EXT", "txt", "-O", "in.xyz", "-SET_ACTIVE_SF", "0",
                   "-STAT_TEST", *test, "-SAVE_CLOUDS", "FILE", "out.txt"]
        log = subprocess.run(command, cwd=folder, check=True, text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT).stdout
        out = np.loadtxt(folder / "out.txt")
    assert np.allclose(out[:, :3], points, atol=1e-6)
    return out[:, 4], float(re.search(r"test result = (\S+)", log).group(1))


def main():
    points, columns = cloud()
    fitted = [[name, *fit] for name, values in columns.items() for fit in fits(values)]
    with open("fits.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["values", "distribution", "a", "b", "shift"])
        for name, distribution, *numbers in fitted:
            writer.writerow([name, distribution] + [f"{number:.12g}" for number in numbers])
    models = [(name, distribution, *(float(f"{number:.6g}") for number in numbers))
              for name, distribution, *numbers in fitted]
    models.append(("skewed", "weibull", 1.6, 0.015, 0.002))
    tests, distances = [], []
    for name, distribution, a, b, shift in models:
        for p, k in [(0.0005, 16), (0.01, 50), (0.05, 5), (0.0005, 3)]:
            numbers = [a, b] if distribution == "gauss" else [a, b, shift]
            test = [distribution.upper(), *(f"{number:.6g}" for number in numbers), f"{p:g}", str(k)]
            distance, threshold = settled(points, columns[name], test)
            exact = np.sqrt(chi2.isf(p, int(np.ceil(np.sqrt(k))) - 1))
            tests.append([name, distribution, *(f"{number:.6g}" for number in (a, b, shift)), f"{p:g}", k, threshold,
                          f"{exact:.12g}"])
            distances.append(distance)
    with open("tests.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow("values,distribution,a,b,shift,p_value,neighbours,threshold,exact_threshold".split(","))
        writer.writerows(tests)
    with open("local_test.csv", "w") as file:
        file.write("x,y,z," + ",".join(columns) + "," + ",".join(f"test_{i}" for i in range(len(tests))) + "\n")
        for i, point in enumerate(points):
            row = [*point, *(values[i] for values in columns.values()), *(distance[i] for distance in distances)]
            file.write(",".join(f"{value:.9g}" for value in row) + "\n")


if __name__ == "__main__":
    main()
