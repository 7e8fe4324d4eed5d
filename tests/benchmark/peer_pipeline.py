#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From a map's file to candidates with Open3D and scipy, as people would write it: the steps of `fodscope-cli detect`.

    /usr/bin/python3 tests/benchmark/peer_pipeline.py --reference REF.ply --map MAP.pcd [--initial T.csv] [--rounds 3]

Prints one line of JSON: seconds of each round and stage, the pose, and counts that Fodscope's must agree with. Reading is
part of the time, starting the interpreter and loading the libraries are not. Every step uses its library's fastest way
that is in common use: all cores in Open3D (OMP_NUM_THREADS) and in scipy's searches (workers), arrays instead of loops. Without --initial the pose is unknown and found as Open3D's tutorial on global
registration does it.
"""
import argparse
import json
import os
import time

os.environ.setdefault("OMP_NUM_THREADS", str(os.cpu_count()))

import numpy as np
import open3d as o3d
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial import cKDTree

registration = o3d.pipelines.registration

PLY_TYPES = {"float": "<f4", "double": "<f8", "int": "<i4", "uint": "<u4", "uchar": "u1", "char": "i1",
             "short": "<i2", "ushort": "<u2"}


def read_reference(path):
    """Points, covariances and which are trained, of a binary PLY."""
    with open(path, "rb") as file:
        fields, count = [], 0
        while (line := file.readline().split())[:1] != [b"end_header"]:
            if line[:2] == [b"element", b"vertex"]:
                count = int(line[2])
            elif line[:1] == [b"property"]:
                fields.append((line[2].decode(), PLY_TYPES[line[1].decode()]))
        table = np.frombuffer(file.read(), np.dtype(fields), count)
    points = np.column_stack([table[axis] for axis in "xyz"]).astype(float)
    covariances = np.stack([table["cov_" + pair] for pair in ("xx", "xy", "xz", "xy", "yy", "yz", "xz", "yz", "zz")],
                           axis=1).astype(float).reshape(-1, 3, 3)
    return points, covariances, table["untrained"] == 0


def cloud_of(points):
    return o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))


def features(cloud, voxel_m):
    """The tutorial's: voxels, normals and FPFH."""
    down = cloud.voxel_down_sample(voxel_m)
    down.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(radius=2.0 * voxel_m, max_nn=30))
    search = o3d.geometry.KDTreeSearchParamHybrid(radius=5.0 * voxel_m, max_nn=100)
    return down, registration.compute_fpfh_feature(down, search)


def global_pose(cloud, reference, voxel_m):
    """The tutorial's RANSAC on feature matches, then its point-to-plane ICP."""
    down, map_features = features(cloud, voxel_m)
    target, reference_features = features(reference, voxel_m)
    distance_m = 1.5 * voxel_m
    found = registration.registration_ransac_based_on_feature_matching(
        down, target, map_features, reference_features, True, distance_m,
        registration.TransformationEstimationPointToPoint(False), 3,
        [registration.CorrespondenceCheckerBasedOnEdgeLength(0.9),
         registration.CorrespondenceCheckerBasedOnDistance(distance_m)],
        registration.RANSACConvergenceCriteria(100_000, 0.999))
    return plane_pose(down, target, found.transformation, 2.0 * voxel_m)


def start_pose(cloud, reference, initial, voxel_m):
    """From a known start pose point-to-plane ICP is enough."""
    down = cloud.voxel_down_sample(voxel_m)
    target = reference.voxel_down_sample(voxel_m)
    target.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(radius=2.0 * voxel_m, max_nn=30))
    return plane_pose(down, target, initial, 0.5)


def plane_pose(down, target, start, distance_m):
    return registration.registration_icp(down, target, distance_m, start,
                                         registration.TransformationEstimationPointToPlane()).transformation


def refined(cloud, reference, start):
    """The paper's alignment: 2 cm voxels point to point."""
    return registration.registration_icp(
        cloud.voxel_down_sample(0.02), reference, 0.5, start, registration.TransformationEstimationPointToPoint(),
        registration.ICPConvergenceCriteria(1e-6, 1e-6, 200)).transformation


def voxels_of(points, edge_m):
    """Means and counts, which Open3D's own voxel grid does not tell."""
    lattice = np.floor((points - points.min(axis=0)) / edge_m).astype(np.int64)
    size = lattice.max(axis=0) + 1
    keys = (lattice[:, 0] * size[1] + lattice[:, 1]) * size[2] + lattice[:, 2]
    _, voxel, counts = np.unique(keys, return_inverse=True, return_counts=True)
    sums = np.stack([np.bincount(voxel, points[:, axis]) for axis in range(3)], axis=1)
    return sums / counts[:, None], counts


class Clock:
    def __init__(self):
        self.seconds = {}
        self.last = time.perf_counter()

    def stop(self, stage):
        now = time.perf_counter()
        self.seconds[stage] = now - self.last
        self.last = now


def run(reference_file, map_file, initial=None, threshold=2.75, cutoff_m=0.345):
    clock = Clock()
    workers = os.cpu_count()
    reference_points, covariances, trained = read_reference(reference_file)
    cloud = o3d.io.read_point_cloud(str(map_file))
    clock.stop("load")

    cloud, kept = cloud.remove_statistical_outlier(50, 2.0)
    clock.stop("denoise")

    reference = cloud_of(reference_points)
    if initial is None:
        pose = global_pose(cloud, reference, 0.05)
    else:
        pose = start_pose(cloud, reference, initial, 0.05)
    pose = refined(cloud, reference, pose)
    clock.stop("registration")

    points = np.asarray(cloud.points) @ pose[:3, :3].T + pose[:3, 3]
    inside = np.all((points > reference_points.min(axis=0)) & (points < reference_points.max(axis=0)), axis=1)
    means, counts = voxels_of(points[inside], 0.02)
    _, nearest = cKDTree(reference_points).query(means, workers=workers)
    deviations = means - reference_points[nearest]
    inverse = np.full(covariances.shape, np.nan)
    inverse[trained] = np.linalg.inv(covariances[trained])
    discrepancies = np.sqrt(np.einsum("ni,nij,nj->n", deviations, inverse[nearest], deviations))
    _, near = cKDTree(means).query(means, k=50, workers=workers)
    known = np.isfinite(discrepancies)
    weights = np.where(known, counts, 0)
    with np.errstate(invalid="ignore"):
        smoothed = (weights * np.where(known, discrepancies, 0.0))[near].sum(axis=1) / weights[near].sum(axis=1)
    clock.stop("discrepancy")

    above = means[smoothed > threshold]
    candidates = int(fcluster(linkage(above, "centroid"), cutoff_m, "distance").max()) if len(above) > 1 else len(above)
    clock.stop("candidates")
    return {"seconds": sum(clock.seconds.values()), "stages": clock.seconds, "pose": pose.tolist(), "kept": len(kept),
            "voxels": len(means), "above": len(above), "candidates": candidates}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--reference", required=True, help="PLY with covariances, from 'fodscope-cli reference'")
    parser.add_argument("--map", required=True, help="PCD or PLY")
    parser.add_argument("--initial", type=lambda file: np.loadtxt(file, delimiter=","), help="4 rows of 4")
    parser.add_argument("--threshold", type=float, default=2.75)
    parser.add_argument("--cutoff", type=float, default=0.345)
    parser.add_argument("--rounds", type=int, default=1)
    options = parser.parse_args()
    for _ in range(options.rounds):
        print(json.dumps(run(options.reference, options.map, options.initial, options.threshold, options.cutoff)),
              flush=True)


if __name__ == "__main__":
    main()
