#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The robot's launch files say what the paper's appendix A says, as roslaunch understands them.

The nodes' packages (RTAB-Map, TurtleBot3, RealSense) are not in Debian: so nothing is started, but all is resolved."""

import os
import subprocess
import sys
import unittest

try:
    import roslaunch.config
    import roslaunch.xmlloader
    import yaml
except ImportError as problem:
    print(f"skipped: roslaunch is not installed ({problem}); see packaging/dependencies.txt")
    sys.exit(77)

FOLDER = os.path.join(os.environ["FODSCOPE_RESOURCES"], "robot")
ROBOT = os.path.join(FOLDER, "robot.launch")

# Appendix A, in its order: what it lists, and the parameters in which that ends up.
GLOBAL_PARAMETERS = [
    ("frame_id", "base_footprint", ["/rtabmap/rtabmap/frame_id"]),
    ("odom_frame_id", "odom", ["/rtabmap/rtabmap/odom_frame_id"]),
    ("approx_rgbd_sync", False, ["/rtabmap/rgbd_sync/approx_sync"]),
    ("odom_tf_angular_variance", 1.0, ["/rtabmap/rtabmap/odom_tf_angular_variance"]),
    ("odom_tf_linear_variance", 1.0, ["/rtabmap/rtabmap/odom_tf_linear_variance"]),
]
NODE_PARAMETERS = [
    ("map_assembler", "cloud_output_voxelized", False),
    ("map_assembler", "Grid/RangeMax", "0.5"),
    ("map_assembler", "Grid/cloud_subtrack_filtering_min_neighbors", "10"),
    ("map_assembler", "Grid/DepthDecimation", "1"),
    ("map_optimizer", "publish_tf", False),
    ("map_optimizer", "odom_frame_id", "odom"),
    ("rtabmap", "Grid/FromDepth", "true"),
    ("rtabmap", "Grid/CellSize", "0.01"),
    ("rtabmap", "Grid/DepthDecimation", "1"),
    ("rtabmap", "Grid/MaxGroundHeight", "0.05"),
    ("rtabmap", "Grid/MaxObstacleHeight", "1"),
]
NODE_REMAPS = [("rtabmap", "grid_map", "/map")]


def dumped(*arguments):
    answer = subprocess.run(["/usr/bin/python3", "/usr/bin/roslaunch", "--dump-params", ROBOT, *arguments],
                            capture_output=True, text=True, timeout=60)
    # It tells a broken file on standard error and exits with 0.
    if answer.returncode != 0 or not answer.stdout.strip():
        raise AssertionError(answer.stderr)
    return yaml.safe_load(answer.stdout)


def nodes(*arguments):
    config = roslaunch.config.ROSLaunchConfig()
    roslaunch.xmlloader.XmlLoader().load(ROBOT, config, argv=list(arguments), verbose=False)
    return {node.namespace + node.name: node for node in config.nodes}


def remaps(node):
    return {source.split("/")[-1]: target for source, target in node.remap_args}


class LaunchFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.visual, cls.wheel = dumped(), dumped("odometry:=wheel")

    def both(self):
        return (("visual", self.visual), ("wheel", self.wheel))

    def test_global_parameters_are_the_papers(self):
        for odometry, parameters in self.both():
            for name, value, places in GLOBAL_PARAMETERS:
                for place in places:
                    with self.subTest(odometry=odometry, parameter=name, place=place):
                        self.assertEqual(parameters[place], value)

    def test_node_parameters_are_the_papers(self):
        for odometry, parameters in self.both():
            for node, name, value in NODE_PARAMETERS:
                with self.subTest(odometry=odometry, node=node, parameter=name):
                    self.assertEqual(parameters[f"/rtabmap/{node}/{name}"], value)

    def test_the_grid_is_published_as_map(self):
        for node, source, target in NODE_REMAPS:
            self.assertEqual(remaps(nodes()[f"/rtabmap/{node}"])[source], target)

    def test_rtabmaps_own_parameters_are_strings(self):
        """RTAB-Map ignores them when they are numbers."""
        for name, value in self.visual.items():
            if name.startswith("/rtabmap/") and any(f"/{group}/" in name for group in ("Grid", "Mem")):
                self.assertIsInstance(value, str, name)

    def test_the_cloud_to_inspect_comes_from_the_assembler_alone(self):
        senders = [name for name, node in nodes().items() if remaps(node).get("cloud_map") in
                   ("cloud_map", "/rtabmap/cloud_map")]
        self.assertEqual(senders, ["/rtabmap/map_assembler"])
        self.assertNotIn(remaps(nodes()["/rtabmap/rtabmap"])["cloud_map"], ("cloud_map", "/rtabmap/cloud_map"))

    def test_one_node_sends_the_odometry(self):
        """Visual odometry is the default; either way /odom and odom -> base_footprint have one sender (REP 105)."""
        visual, wheel = nodes(), nodes("odometry:=wheel")
        self.assertIn("/rtabmap/rgbd_odometry", visual)
        self.assertEqual(remaps(visual["/rtabmap/rgbd_odometry"])["odom"], "/odom")
        self.assertEqual(dict(visual["/turtlebot3_core"].remap_args)["/tf"], "/wheel/tf")
        self.assertEqual(dict(visual["/turtlebot3_core"].remap_args)["/odom"], "/wheel/odom")
        self.assertNotIn("/rtabmap/rgbd_odometry", wheel)
        self.assertEqual(wheel["/turtlebot3_core"].remap_args, [])

    def test_another_odometry_is_refused(self):
        with self.assertRaises(AssertionError):
            dumped("odometry:=legs")

    def test_localization_keeps_the_map(self):
        self.assertEqual(self.visual["/rtabmap/rtabmap/Mem/IncrementalMemory"], "true")
        localizing = dumped("localization:=true")
        self.assertEqual(localizing["/rtabmap/rtabmap/Mem/IncrementalMemory"], "false")
        self.assertEqual(localizing["/rtabmap/rtabmap/Mem/InitWMWithAllNodes"], "true")

    def test_newer_rtabmap_has_its_nodes_in_other_packages(self):
        packages = {name: node.package for name, node in nodes("split_rtabmap_packages:=true").items()}
        self.assertEqual(packages["/rtabmap/rtabmap"], "rtabmap_slam")
        self.assertEqual(packages["/rtabmap/rgbd_odometry"], "rtabmap_odom")
        self.assertEqual(packages["/rtabmap/map_assembler"], "rtabmap_util")
        self.assertEqual(packages["/rtabmap/map_optimizer"], "rtabmap_util")
        self.assertEqual({node.package for name, node in nodes().items()
                          if name.startswith("/rtabmap/") and node.package != "nodelet"}, {"rtabmap_ros"})

    def test_the_cost_map_is_the_papers(self):
        for cost_map in ("global_costmap", "local_costmap"):
            place = f"/move_base/{cost_map}"
            self.assertEqual(self.visual[f"{place}/robot_radius"], 0.17)
            self.assertEqual(self.visual[f"{place}/footprint_padding"], 0.05)
            self.assertEqual(self.visual[f"{place}/inflation_layer/inflation_radius"], 0.5)
            self.assertEqual(self.visual[f"{place}/inflation_layer/cost_scaling_factor"], 10.0)
        self.assertEqual(self.visual["/move_base/global_costmap/global_frame"], "map")
        self.assertEqual(self.visual["/move_base/global_costmap/robot_base_frame"], "base_footprint")

    def test_the_camera_gives_registered_depth_with_equal_stamps(self):
        camera = "/camera/realsense2_camera"
        self.assertIs(self.visual[f"{camera}/align_depth"], True)
        self.assertIs(self.visual[f"{camera}/enable_sync"], True)
        self.assertEqual((self.visual[f"{camera}/color_width"], self.visual[f"{camera}/color_height"]), (1280, 720))
        sync = remaps(nodes()["/rtabmap/rgbd_sync"])
        self.assertEqual(sync["image"], "/camera/aligned_depth_to_color/image_raw")


if __name__ == "__main__":
    unittest.main(verbosity=1)
