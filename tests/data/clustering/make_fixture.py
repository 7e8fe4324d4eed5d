#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes centroid_linkage.csv: points and their flat clusters by scipy, for several cutoffs.

Labels are numbered by each cluster's first point. Run in this folder with a Python that has numpy and scipy."""
import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage

CUTOFFS = [0.02, 0.05, 0.1, 0.2, 0.345, 0.738]


def by_first_point(labels):
    numbers = {}
    return [numbers.setdefault(label, len(numbers)) for label in labels]


def main():
    rng = np.random.default_rng(7)
    centres = rng.uniform([0, 0, 0], [3, 2, 0.6], (12, 3))
    clumps = [c + rng.normal(0, rng.uniform(0.02, 0.12), (30, 3)) for c in centres]
    stray = rng.uniform([0, 0, 0], [3, 2, 0.6], (60, 3))
    points = np.round(np.vstack(clumps + [stray]), 9)
    rng.shuffle(points)
    tree = linkage(points, "centroid")
    columns = [by_first_point(fcluster(tree, cutoff, "distance")) for cutoff in CUTOFFS]
    with open("centroid_linkage.csv", "w") as file:
        file.write("x,y,z," + ",".join(f"{cutoff:g}" for cutoff in CUTOFFS) + "\n")
        for i, point in enumerate(points):
            file.write(",".join([f"{value:.9f}" for value in point] + [str(column[i]) for column in columns]) + "\n")
    print("merges:", len(tree), "of which below the one before:", int((np.diff(tree[:, 2]) < 0).sum()))


if __name__ == "__main__":
    main()
