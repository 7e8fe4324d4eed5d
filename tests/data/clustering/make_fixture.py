#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes NAME.csv: points and their flat clusters by scipy, for both linkages and several cutoffs.

The header names linkage and cutoff of each column of labels. Labels are numbered by each cluster's first point. No two
merge distances tie, so that scipy's answer does not rest on rounding. For centroid linkage some cutoffs lie within an
inversion: between the distance of a merge and the smaller one of the merge that it made possible.
Run in this folder with a Python that has numpy and scipy."""
import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage

CUTOFFS = [0.02, 0.05, 0.1, 0.2, 0.345, 0.738]


def clustered(rng):
    centres = rng.uniform([0, 0, 0], [3, 2, 0.6], (12, 3))
    clumps = [c + rng.normal(0, rng.uniform(0.02, 0.12), (30, 3)) for c in centres]
    stray = rng.uniform([0, 0, 0], [3, 2, 0.6], (60, 3))
    return np.vstack(clumps + [stray])


def random(rng):
    return rng.uniform(0, 1, (300, 3))


def collinear(rng):
    on_axis = np.column_stack([rng.uniform(0, 5, 120), np.zeros(120), np.full(120, 0.2)])
    oblique = rng.uniform(0, 4, (120, 1)) * np.array([[0.36, 0.48, 0.8]]) + [0, 3, 0]
    return np.vstack([on_axis, oblique])


def surface(rng):
    """A thin floor and a wall, as what is left of a map above a low threshold."""
    floor = rng.uniform([0, 0, 0], [2.5, 1.5, 0.02], (300, 3))
    wall = rng.uniform([2.5, 0, 0], [2.52, 1.5, 0.6], (120, 3))
    return np.vstack([floor, wall])


def by_first_point(labels):
    numbers = {}
    return [numbers.setdefault(label, len(numbers)) for label in labels]


def within_inversions(distances, count):
    falls = np.flatnonzero(np.diff(distances) < 0)
    chosen = falls[np.argsort(np.diff(distances)[falls])[:count]]
    return [float(f"{(distances[i] + distances[i + 1]) / 2:.6f}") for i in sorted(chosen)]


def main():
    for seed, make in enumerate([clustered, random, collinear, surface], start=7):
        rng = np.random.default_rng(seed)
        points = np.round(make(rng), 9)
        rng.shuffle(points)
        columns = {}
        for method in ["centroid", "single"]:
            tree = linkage(points, method)
            gaps = np.diff(np.sort(tree[:, 2]))
            assert gaps.min() > 1e-10, "merge distances tie"
            cutoffs = CUTOFFS + (within_inversions(tree[:, 2], 4) if method == "centroid" else [])
            for cutoff in cutoffs:
                columns[f"{method} {cutoff:g}"] = by_first_point(fcluster(tree, cutoff, "distance"))
            print(make.__name__, method, "merges:", len(tree), "inversions:", int((np.diff(tree[:, 2]) < 0).sum()))
        with open(f"{make.__name__}.csv", "w") as file:
            file.write("x,y,z," + ",".join(columns) + "\n")
            for i, point in enumerate(points):
                values = [f"{value:.9f}" for value in point] + [str(labels[i]) for labels in columns.values()]
                file.write(",".join(values) + "\n")


if __name__ == "__main__":
    main()
