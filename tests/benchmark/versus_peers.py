#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs stages of Fodscope and of the programs that people would use instead, in turns, on the same files.

    /usr/bin/python3 tests/benchmark/versus_peers.py --timer build/bin/fodscope-stage-timer --mesh TANK.ply [--rounds 5]

Needs Debian's python3-numpy, python3-scipy and python3-open3d, and cloudcompare with xvfb-run. Prints a table of the
ratios peer / Fodscope: median, least and greatest over the rounds. The files are read before either clock starts.
"""
import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import tempfile
import time

os.environ.setdefault("OMP_NUM_THREADS", str(os.cpu_count()))

import numpy as np
import open3d as o3d
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial import cKDTree


def sampled(mesh, count, seed):
    """Points on a mesh, uniform by area."""
    generator = np.random.default_rng(seed)
    corners = np.asarray(mesh.vertices)[np.asarray(mesh.triangles)]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    chosen = corners[generator.choice(len(corners), count, p=areas / areas.sum())]
    u = np.sqrt(generator.random((count, 1)))
    v = generator.random((count, 1))
    return (1 - u) * chosen[:, 0] + u * (1 - v) * chosen[:, 1] + u * v * chosen[:, 2]


def noisy(points, sigma_m, seed):
    return points + np.random.default_rng(seed).normal(0.0, sigma_m, points.shape)


def write(folder, name, points):
    path = folder / f"{name}.ply"
    cloud = o3d.t.geometry.PointCloud(o3d.core.Tensor(points.astype(np.float32)))
    o3d.t.io.write_point_cloud(str(path), cloud)
    return path


def read(path):
    return o3d.io.read_point_cloud(str(path))


class Ours:
    def __init__(self, timer):
        self.timer = timer

    def __call__(self, stage, *options):
        out = subprocess.run([self.timer, stage, *map(str, options)], check=True, capture_output=True, text=True)
        answer = json.loads(out.stdout)
        return answer["seconds"][0], answer["result"], answer["peak_memory_bytes"]


def timed(run):
    begin = time.perf_counter()
    result = run()
    return time.perf_counter() - begin, result


def cloud_compare(cloud, reference):
    """CloudCompare's own printed time of a cloud to cloud distance."""
    command = ["xvfb-run", "-a", "CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF",
               "-O", str(cloud), "-O", str(reference), "-C2C_DIST"]
    out = subprocess.run(command, check=True, capture_output=True, text=True)
    found = re.findall(r"Time: ([\d.]+) s", out.stdout + out.stderr)
    if not found:
        raise RuntimeError("CloudCompare printed no time")
    return float(found[-1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timer", required=True, help="build/bin/fodscope-stage-timer")
    parser.add_argument("--mesh", required=True, help="a tank's CAD mesh, metres")
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    ours = Ours(options.timer)
    mesh = o3d.io.read_triangle_mesh(options.mesh)
    rows = []

    def row(work, peer, run):
        """`run` gives our seconds and the peer's, and raises where their results differ."""
        ratios, own, theirs = [], [], []
        for _ in range(options.rounds):
            mine, other = run()
            own.append(mine)
            theirs.append(other)
            ratios.append(other / mine)
        rows.append((work, peer, statistics.median(own), statistics.median(theirs), statistics.median(ratios),
                     min(ratios), max(ratios)))
        print("| {} | {} | {:.3f} | {:.3f} | {:.1f} | {:.1f} to {:.1f} |".format(*rows[-1]), flush=True)

    print("| work | peer | Fodscope s | peer s | ratio | least to greatest |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        million = write(folder, "million", sampled(mesh, 1_000_000, 1))
        noise = write(folder, "noise", noisy(sampled(mesh, 1_000_000, 2), 0.01, 3))

        def nearest():
            mine, mean_m, _ = ours("nearest", "--cloud", noise, "--reference", million)
            a, b = read(noise), read(million)
            other, distances = timed(lambda: np.asarray(a.compute_point_cloud_distance(b)))
            assert abs(distances.mean() - mean_m) < 1e-6, (distances.mean(), mean_m)
            return mine, other
        row("nearest of 1 M in 1 M", "Open3D", nearest)

        def nearest_cloud_compare():
            mine, _, _ = ours("nearest", "--cloud", noise, "--reference", million)
            return mine, cloud_compare(noise, million)
        row("nearest of 1 M in 1 M", "CloudCompare", nearest_cloud_compare)

        def outliers():
            mine, kept, _ = ours("outliers", "--cloud", noise)
            cloud = read(noise)
            other, answer = timed(lambda: cloud.remove_statistical_outlier(50, 2.0))
            assert abs(len(answer[1]) - kept) <= 2, (len(answer[1]), kept)
            return mine, other
        row("outliers of 1 M, k = 50", "Open3D", outliers)

        ten = write(folder, "ten", noisy(sampled(mesh, 10_000_000, 4), 0.01, 5))

        def voxels():
            mine, count, _ = ours("voxels", "--cloud", ten, "--length", 0.02)
            cloud = read(ten)
            other, answer = timed(lambda: cloud.voxel_down_sample(0.02))
            assert abs(len(answer.points) - count) <= 2, (len(answer.points), count)
            return mine, other
        row("voxel grid of 10 M, 2 cm", "Open3D, without weights", voxels)

        means = np.asarray(read(ten).voxel_down_sample(0.02).points)
        chosen = write(folder, "voxels", means[np.random.default_rng(6).permutation(len(means))[:560_000]])

        def smoothing():
            mine, _, _ = ours("smoothing", "--cloud", chosen)
            points = np.asarray(read(chosen).points)
            other, _ = timed(lambda: cKDTree(points).query(points, k=50, workers=2))
            return mine, other
        row("smoothing of 560 k voxels, k = 50", "scipy, the search alone, 2 workers", smoothing)

        few = write(folder, "few", noisy(sampled(mesh, 8_000, 7), 0.01, 8))

        def clusters():
            mine, count, _ = ours("clusters", "--cloud", few, "--length", 0.345)
            points = np.asarray(read(few).points)
            other, labels = timed(lambda: fcluster(linkage(points, "centroid"), 0.345, "distance"))
            assert labels.max() == count, (labels.max(), count)
            return mine, other
        row("centroid clusters of 8 k", "scipy", clusters)

        many = write(folder, "many", noisy(sampled(mesh, 200_000, 9), 0.01, 10))
        seconds, _, memory = ours("clusters", "--cloud", many, "--length", 0.345)
        print(f"\ncentroid clusters of 200 k: {seconds:.2f} s, peak memory {memory / 2**20:.0f} MiB")


if __name__ == "__main__":
    main()
