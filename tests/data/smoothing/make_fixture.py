#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes covariances and discrepancies in every form of smoothing, computed with numpy and scipy from the formulas.

reference.csv     a small reference: points of a floor and a wall, some that no sample reaches, two that coincide
samples.csv       points of nominal maps, in the reference's frame
covariances.csv   n_i, S_i, and per form of smoothing the six entries of the covariance; nan: untrained
map.csv           a map under inspection with an object on the floor
discrepancy.csv   its voxels: mean, count, nearest reference point, both discrepancies, and them smoothed per form

Of covariances.csv and discrepancy.csv only the first 9 digits are given. Weights are computed in long double, in which none of them vanishes; those that vanish in double leave a point
untrained, as do V1 - V2/V1 = 0 and a covariance without an inverse (least eigenvalue at most 1e-6 of the greatest).
Run in this folder with a Python that has numpy and scipy."""
import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

RADIUS, SIGMA, VOXEL, LAMBDA = 0.2, 0.05, 0.15, 1e-6
QUERY_VOXEL = 0.04
ENTRIES = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)]
NAMES = ["xx", "xy", "xz", "yy", "yz", "zz"]


def neighbourhoods(points, places, neighbourhood, k):
    """Of points at the same distance the first ones count as nearer."""
    for distance in cdist(places, points):
        order = np.argsort(distance, kind="stable")
        near = order[distance[order] <= RADIUS] if neighbourhood == "ball" else order[:k]
        yield near, distance[near]


def is_invertible(matrix):
    values = np.linalg.eigvalsh(matrix)
    return values[0] > 0 and values[0] > 1e-6 * values[2]


def smoothed_covariance(n, s, near, distance, weights):
    n, s = n[near], s[near]
    if n.sum() == 0:
        return None
    if weights == "mean":
        return s.sum(0) / n.sum()
    w = np.exp(-(distance.astype(np.longdouble) / SIGMA) ** 2)
    if not (n * w.astype(float)).sum() > 0:
        return None
    v1, v2 = (n * w).sum(), (n * w * w).sum()
    if not v1 - v2 / v1 > 1e-12 * v1:
        return None
    return ((w[:, None, None] * s).sum(0) / (v1 - v2 / v1)).astype(float)


def voxel_means(points, origin, size):
    cells = np.floor((points - origin) / size).astype(int)
    _, inverse, counts = np.unique(cells, axis=0, return_inverse=True, return_counts=True)
    sums = np.zeros((len(counts), 3))
    np.add.at(sums, inverse.ravel(), points)
    return sums / counts[:, None], counts


def covariances(points, n, s, neighbourhood, weights, k, voxel, regularisation):
    places = points if voxel is None else voxel_means(points, points.min(0) - voxel / 2, voxel)[0]
    result = np.full((len(places), 3, 3), np.nan)
    for i, (near, distance) in enumerate(neighbourhoods(points, places, neighbourhood, k)):
        matrix = smoothed_covariance(n, s, near, distance, weights)
        if matrix is None:
            continue
        matrix = matrix + regularisation * np.eye(3)
        if is_invertible(matrix):
            result[i] = matrix
    return result if voxel is None else result[cKDTree(places).query(points)[1]]


def smoothed_discrepancy(points, n, d, neighbourhood, weights, k):
    result = np.full(len(points), np.nan)
    for i, (near, distance) in enumerate(neighbourhoods(points, points, neighbourhood, k)):
        known = ~np.isnan(d[near])
        w = n[near] * (np.exp(-(distance / SIGMA) ** 2) if weights == "gaussian" else 1.0)
        if w[known].sum() > 0:
            result[i] = (w * d[near])[known].sum() / w[known].sum()
    return result


def write(name, columns):
    with open(name, "w") as file:
        file.write(",".join(columns) + "\n")
        for row in zip(*columns.values()):
            file.write(",".join(f"{value:.9g}" for value in row) + "\n")


def xyz(points):
    return dict(zip("xyz", points.T))


def scene(rng):
    floor = rng.uniform([0, 0, -0.005], [1, 0.8, 0.005], (90, 3))
    wall = rng.uniform([-0.005, 0, 0], [0.005, 0.8, 0.5], (30, 3))
    unseen = rng.uniform([2.5, 0, 0], [2.8, 0.3, 0.1], (8, 3))
    lone = np.array([[1.8, 0.4, 0.0]])
    flat = rng.uniform([0, 2, 0], [0.05, 2.05, 0], (6, 3)) * [1, 1, 0]
    reference = np.round(np.vstack([floor, wall, unseen, lone, flat, floor[:2]]), 6)
    samples = [rng.uniform([0, 0, 0], [1, 0.8, 0], (500, 3)) + rng.normal(0, [0.01, 0.01, 0.004], (500, 3)),
               rng.uniform([0, 0, 0], [0, 0.8, 0.5], (150, 3)) + rng.normal(0, [0.012, 0.01, 0.01], (150, 3)),
               lone + [[0.002, -0.001, 0.003]],
               rng.uniform([0, 2, 0], [0.05, 2.05, 0], (25, 3)) * [1, 1, 0]]
    floor_map = rng.uniform([0.01, 0.01, 0], [0.98, 0.78, 0], (500, 3)) + rng.normal(0, [0, 0, 0.002], (500, 3))
    thing = rng.uniform([0.4, 0.3, 0.03], [0.5, 0.36, 0.09], (60, 3))
    beyond = rng.uniform([2.5, 0.01, 0.01], [2.79, 0.29, 0.09], (40, 3))
    return reference, np.round(np.vstack(samples), 6), np.round(np.vstack([floor_map, thing, beyond]), 6)


def main():
    reference, samples, query = scene(np.random.default_rng(11))
    # Of two coincident points the first one takes the samples.
    distance, nearest = cKDTree(reference).query(samples)
    for first, second in ((0, len(reference) - 2), (1, len(reference) - 1)):
        nearest[nearest == second] = first
    deviation = samples - reference[nearest]
    n = np.bincount(nearest, minlength=len(reference))
    s = np.zeros((len(reference), 3, 3))
    np.add.at(s, nearest, deviation[:, :, None] * deviation[:, None, :])

    columns = {"n": n} | {f"S_{name}": s[:, a, b] for name, (a, b) in zip(NAMES, ENTRIES)}
    fitted = {}
    for neighbourhood, k in (("knn", 12), ("knn", 1), ("knn", 1000), ("ball", 0)):
        for weights in ("mean", "gaussian"):
            for voxel in (None, VOXEL):
                for regularisation in (0, LAMBDA):
                    if k in (1, 1000) and (regularisation or voxel) or regularisation and voxel:
                        continue
                    form = f"{neighbourhood}{k or ''}_{weights}" + ("_voxel" if voxel else "")
                    form += "_regularised" if regularisation else ""
                    fitted[form] = covariances(reference, n, s, neighbourhood, weights, k, voxel, regularisation)
                    for name, (a, b) in zip(NAMES, ENTRIES):
                        columns[f"{form}_{name}"] = fitted[form][:, a, b]
                    print(form, "untrained:", int(np.isnan(fitted[form][:, 0, 0]).sum()), "of", len(reference))
    write("reference.csv", xyz(reference))
    write("samples.csv", xyz(samples))
    write("covariances.csv", columns)

    low, high = reference.min(0), reference.max(0)
    inside = query[((query > low) & (query < high)).all(1)]
    voxels, counts = voxel_means(inside, inside.min(0), QUERY_VOXEL)
    euclidean, nearest = cKDTree(reference).query(voxels)
    inverse = np.full((len(reference), 3, 3), np.nan)
    covariance = fitted["ball_mean"]
    for i in np.flatnonzero(~np.isnan(covariance[:, 0, 0])):
        inverse[i] = np.linalg.inv(covariance[i])
    deviation = voxels - reference[nearest]
    mahalanobis = np.sqrt(np.einsum("ia,iab,ib->i", deviation, inverse[nearest], deviation))
    columns = xyz(voxels) | {"n": counts, "euclidean": euclidean, "mahalanobis": mahalanobis}
    for neighbourhood, k in (("knn", 9), ("knn", 5000), ("ball", 0)):
        for weights in ("mean", "gaussian"):
            for metric, values in (("euclidean", euclidean), ("mahalanobis", mahalanobis)):
                for passes in (1, 2, 3):
                    values = smoothed_discrepancy(voxels, counts, values, neighbourhood, weights, k)
                    if passes != 2:
                        columns[f"{neighbourhood}{k or ''}_{weights}_{passes}_{metric}"] = values
    write("map.csv", xyz(query))
    write("discrepancy.csv", columns)
    print("voxels:", len(voxels), "of which unknown:", int(np.isnan(mahalanobis).sum()))


if __name__ == "__main__":
    main()
