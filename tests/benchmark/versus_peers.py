#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs stages of Fodscope and of the programs that people would use instead, in turns, on the same files.

    /usr/bin/python3 tests/benchmark/versus_peers.py --timer build/bin/fodscope-stage-timer --mesh TANK.ply [--rounds 5]
        [--cli build/bin/fodscope-cli --reference REF.ply --map MAP.pcd [--trials DIR]]

Needs Debian's python3-numpy, python3-scipy and python3-open3d, and cloudcompare with xvfb-run. Prints a table of the
ratios peer / Fodscope: median, least and greatest over the rounds. The files are read before either clock starts.

With --cli a map's way from its file to its candidates is measured too: fodscope-cli from its start to its end, results
written, against peer_pipeline.py, whose interpreter and libraries are loaded before its clock starts. REF.ply is a
reference with covariances. With --trials also the search for the best parameters, which has no peer.
"""
import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

os.environ.setdefault("OMP_NUM_THREADS", str(os.cpu_count()))

import numpy as np
import open3d as o3d
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial import cKDTree

sys.dont_write_bytecode = True
import peer_pipeline


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


class OursWhole:
    """fodscope-cli detect as a user runs it."""

    def __init__(self, cli, reference, cloud, folder):
        self.command = [cli, "detect", "--reference", reference, "--map", cloud, "--out", str(folder / "detection")]
        self.folder = folder / "detection"

    def __call__(self, *options):
        seconds, _ = timed(lambda: subprocess.run(self.command + list(options), check=True, capture_output=True))
        answer = json.loads((self.folder / "candidates.json").read_text())
        header = (self.folder / "discrepancy.ply").read_bytes()[:4096]
        voxels = int(re.search(rb"element vertex (\d+)", header).group(1))
        return seconds, np.array(answer["T_reference_from_map"]), voxels, answer


def require_agreement(ours, peer, reference_points):
    """The pose to 5 mm anywhere in the reference, the voxels to half a hundredth, the candidates to one."""
    _, pose, voxels, answer = ours
    low, high = reference_points.min(axis=0), reference_points.max(axis=0)
    corners = np.array([[x, y, z, 1.0] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    there = np.linalg.inv(pose) @ corners.T
    away_m = np.linalg.norm(((np.array(peer["pose"]) - pose) @ there)[:3], axis=0).max()
    assert away_m < 0.005, away_m
    assert abs(voxels - peer["voxels"]) < 5e-3 * voxels, (voxels, peer["voxels"])
    assert abs(len(answer["candidates"]) - peer["candidates"]) <= 1, (len(answer["candidates"]), peer["candidates"])
    return away_m


def whole_map(options, folder, row):
    ours = OursWhole(options.cli, options.reference, options.map, folder)
    reference_points = peer_pipeline.read_reference(options.reference)[0]

    def cold():
        mine = ours()
        other = peer_pipeline.run(options.reference, options.map)
        require_agreement(mine, other, reference_points)
        return mine[0], other["seconds"]
    row("one map, file to candidates, pose unknown", "Open3D and scipy", cold)

    start = ours()[1] @ np.array([[np.cos(0.03), -np.sin(0.03), 0, 0.1], [np.sin(0.03), np.cos(0.03), 0, -0.05],
                                  [0, 0, 1, 0.02], [0, 0, 0, 1.0]])
    np.savetxt(folder / "start.csv", start, delimiter=",")

    def started():
        mine = ours("--initial", str(folder / "start.csv"))
        other = peer_pipeline.run(options.reference, options.map, start)
        require_agreement(mine, other, reference_points)
        return mine[0], other["seconds"]
    row("one map, file to candidates, start pose given", "Open3D and scipy", started)


def search_seconds(options, folder):
    command = [options.cli, "tune", "--reference", options.reference, "--trials", options.trials,
               "--metric", "mahalanobis", "--crop-height", "0.6", "--out", str(folder / "tuned.yaml")]
    return timed(lambda: subprocess.run(command, check=True, capture_output=True))[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timer", required=True, help="build/bin/fodscope-stage-timer")
    parser.add_argument("--mesh", required=True, help="a tank's CAD mesh, metres")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--cli", help="build/bin/fodscope-cli")
    parser.add_argument("--reference", help="with covariances; with --cli")
    parser.add_argument("--map", help="with --cli")
    parser.add_argument("--trials", help="folder of maps with known FOD; with --cli")
    options = parser.parse_args()
    if options.cli and not (options.reference and options.map):
        parser.error("--cli needs --reference and --map")
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
        if options.cli:
            whole_map(options, folder, row)
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
        if options.trials:
            seconds_of_search = [search_seconds(options, folder) for _ in range(options.rounds)]
            print(f"\nsearch of the parameters: {statistics.median(seconds_of_search):.1f} s")
        print(f"\ncentroid clusters of 200 k: {seconds:.2f} s, peak memory {memory / 2**20:.0f} MiB")


if __name__ == "__main__":
    main()
