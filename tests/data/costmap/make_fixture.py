#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Costs of costmap_2d's inflation layer on grids with random obstacles, worked out with scipy from the published formula.

Writes costs.csv: a block for each grid with its settings, then a line for each row of cells (row 0 first), every cell as
KIND:COST with KIND one of . # ? (free, occupied, unknown).
"""
import math
import pathlib

import numpy as np
from scipy.ndimage import distance_transform_edt

HERE = pathlib.Path(__file__).parent
ROBOTS = [  # inscribed radius, inflation radius, cost scaling factor
    (0.2154, 0.5, 10.0),
    (0.2154, 0.55, 3.0),
    (0.17, 0.17, 10.0),
    (0.0, 1.0, 2.0),
]


def costs(kinds, resolution, inscribed, inflation, scaling):
    cells = distance_transform_edt(kinds != "#") if (kinds == "#").any() else np.full(kinds.shape, np.inf)
    result = np.zeros(kinds.shape, int)
    for at in np.ndindex(kinds.shape):
        metres = cells[at] * resolution
        cost = 0
        if cells[at] == 0:
            cost = 254
        elif cells[at] <= math.ceil(inflation / resolution):
            cost = 253 if metres <= inscribed else int(252 * math.exp(-scaling * (metres - inscribed)))
        result[at] = 255 if kinds[at] == "?" and cost < 253 else cost
    return result


def main():
    random = np.random.default_rng(20240)
    lines = []
    for resolution in (0.05, 0.1, 0.02):
        for robot in ROBOTS:
            kinds = random.choice(list(".#?"), size=(26, 34), p=(0.93, 0.012, 0.058))
            lines.append(f"grid,{resolution},{robot[0]},{robot[1]},{robot[2]}")
            for row, cost in zip(kinds, costs(kinds, resolution, *robot)):
                lines.append(",".join(f"{kind}:{value}" for kind, value in zip(row, cost)))
    (HERE / "costs.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
