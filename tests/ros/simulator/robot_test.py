#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The robot simulator, seen from outside as any ROS 1 robot: it maps, drives, sees and answers."""

import math
import os
import sys
import unittest
import xmlrpc.client

import ros_client

ros_client.skip_without_ros(*sys.argv[1:2])

import cv2
import numpy
import rospy
from actionlib_msgs.msg import GoalID
from geometry_msgs.msg import Twist
from map_msgs.msg import OccupancyGridUpdate
from move_base_msgs.msg import MoveBaseActionFeedback, MoveBaseActionGoal, MoveBaseActionResult
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, PointCloud2
from std_srvs.srv import Empty

import small_room
from robot_case import (ABORTED, ACTIVE, PREEMPTED, SUCCEEDED, RobotCase, Site, goal_at, stands, start_robot)
from robot_peer import PublishMap
from ros_client import Topic
from ros_core import RosCore


def rotation(q):
    return numpy.array([
        [1 - 2 * (q.y ** 2 + q.z ** 2), 2 * (q.x * q.y - q.z * q.w), 2 * (q.x * q.z + q.y * q.w)],
        [2 * (q.x * q.y + q.z * q.w), 1 - 2 * (q.x ** 2 + q.z ** 2), 2 * (q.y * q.z - q.x * q.w)],
        [2 * (q.x * q.z - q.y * q.w), 2 * (q.y * q.z + q.x * q.w), 1 - 2 * (q.x ** 2 + q.y ** 2)]])


def decoded(compressed):
    return cv2.imdecode(numpy.frombuffer(compressed.data, numpy.uint8), cv2.IMREAD_COLOR)


def red_pixels(image):
    blue, green, red = (image[:, :, channel].astype(int) for channel in range(3))
    rows, columns = numpy.nonzero((red > 90) & (red > 2 * green) & (red > 2 * blue))
    return columns, rows


def publish_map(graph_only=False):
    rospy.wait_for_service("/rtabmap/publish_map", ros_client.WITHIN_S)
    rospy.ServiceProxy("/rtabmap/publish_map", PublishMap)(True, True, graph_only)


def points_of(cloud):
    layout = numpy.dtype({"names": [field.name for field in cloud.fields], "formats": ["<f4"] * len(cloud.fields),
                          "offsets": [field.offset for field in cloud.fields], "itemsize": cloud.point_step})
    return numpy.frombuffer(cloud.data, layout)


class GoalRules:
    """Of actionlib's SimpleActionServer. The same tests run against Debian's own, in the Python robot."""

    def test_a_newer_goal_preempts_and_an_earlier_one_is_cancelled_at_once(self):
        first = self.send(goal_at(0.9, -0.5))
        self.wait_for_status(first, ACTIVE)
        with Topic("/move_base/result", MoveBaseActionResult) as results:
            publisher = rospy.Publisher("/move_base/goal", MoveBaseActionGoal, queue_size=1)
            ros_client.wait_until(lambda: publisher.get_num_connections() > 0, what="the server")
            earlier = MoveBaseActionGoal(goal=goal_at(0.0, 0.0))
            earlier.goal_id.id, earlier.goal_id.stamp = "earlier", rospy.Time.now() - rospy.Duration(60)
            refused = results.after(lambda: publisher.publish(earlier),
                                    holds=lambda message: message.status.goal_id.id == "earlier")[0]
            self.assertIn("another goal was rec", refused.status.text)
            self.assertEqual(self.statuses_of(first, 1), [ACTIVE])
            second = self.send(goal_at(-0.5, 0.4))
            self.wait_for_status(first, PREEMPTED)
            self.wait_for_status(second, SUCCEEDED)
        ros_client.wait_until(lambda: numpy.allclose(self.pose_in("map")[:2], (-0.5, 0.4), atol=0.01),
                              what="the second goal's pose")

    def test_cancelling_everything_stops_the_goal_of_anybody(self):
        goal_id = self.send(goal_at(1.0, 0.5))
        self.odometry.next(lambda message: not stands(message))
        cancel = rospy.Publisher("/move_base/cancel", GoalID, queue_size=1)
        ros_client.wait_until(lambda: cancel.get_num_connections() > 0, what="the server")
        cancel.publish(GoalID())
        self.wait_for_status(goal_id, PREEMPTED)
        self.odometry.next(stands)


class RulesOfThePythonRobot(GoalRules, RobotCase):
    @classmethod
    def start(cls):
        start = [str(value) for value in small_room.START_MAP]
        peer = os.path.join(os.path.dirname(ros_client.__file__), "robot_peer.py")
        robot = ros_client.Program(["/usr/bin/python3", peer, "--start", *start], Site.core.environment)
        robot.wait_for_line('"ready"')
        return robot


class WithAFinishedMap(GoalRules, RobotCase):
    def test_frames_hang_together_by_rep_103_and_105(self):
        for parent, child in (("map", "odom"), ("odom", "base_footprint"), ("base_footprint", "base_link")):
            self.tf.lookup_transform(parent, child, rospy.Time(0), rospy.Duration(ros_client.WITHIN_S))
        optical = self.tf.lookup_transform("base_footprint", "camera_color_optical_frame", rospy.Time(0)).transform
        turn = rotation(optical.rotation)
        pitch = math.radians(5.0)
        self.assertAlmostEqual(optical.translation.z, 0.20, places=6)
        numpy.testing.assert_allclose(turn[:, 2], [math.cos(pitch), 0, -math.sin(pitch)], atol=1e-4)
        numpy.testing.assert_allclose(turn[:, 0], [0, -1, 0], atol=1e-6)

    def test_it_drives_to_a_goal_and_tells_so(self):
        with Topic("/move_base/feedback", MoveBaseActionFeedback) as feedback, \
                Topic("/move_base/result", MoveBaseActionResult) as result:
            state, text = self.drive(goal_at(0.3, -0.4, 1.2))
            self.assertEqual((state, text), (SUCCEEDED, "Goal reached."))
            self.assertEqual(feedback.first().feedback.base_position.header.frame_id, "map")
            self.assertEqual(result.first().status.status, SUCCEEDED)
        self.odometry.next(stands)
        # Frames come on another topic than results.
        ros_client.wait_until(lambda: numpy.allclose(self.pose_in("map"), (0.3, -0.4, 1.2), atol=0.01),
                              what="the goal's pose")

    def test_a_photo_shows_the_box_where_the_camera_model_puts_it(self):
        self.drive(goal_at(0.1, 0.2, 0.0))
        stood = self.odometry.next(stands).header.stamp
        with Topic("/camera/color/image_raw/compressed", CompressedImage) as photos, \
                Topic("/camera/color/image_raw", Image) as raws, \
                Topic("/camera/color/camera_info", CameraInfo) as infos:
            photo = photos.next(lambda message: message.header.stamp > stood)
            info = infos.first()
            raw = raws.next()
            same = photos.next(lambda message: message.header.stamp >= raw.header.stamp)
        self.assertEqual(photo.header.frame_id, "camera_color_optical_frame")
        self.assertIn("jpeg", photo.format)
        image = decoded(photo)
        self.assertEqual(image.shape, (info.height, info.width, 3))

        columns, rows = red_pixels(image)
        self.assertGreater(len(columns), 100, "the box is not to be seen")
        transform = self.tf.lookup_transform("camera_color_optical_frame", "map", rospy.Time(0)).transform
        corner_of = [numpy.array(small_room.box_centre_map()) + numpy.array(small_room.BOX_SIZE) / 2 * sign
                     for sign in numpy.array(numpy.meshgrid([-1, 1], [-1, 1], [-1, 1])).T.reshape(-1, 3)]
        t = transform.translation
        seen = [rotation(transform.rotation) @ corner + (t.x, t.y, t.z) for corner in corner_of]
        u = [info.K[0] * x / z + info.K[2] for x, _, z in seen]
        v = [info.K[4] * y / z + info.K[5] for _, y, z in seen]
        for measured, expected in ((columns.min(), min(u)), (columns.max(), max(u)), (rows.min(), min(v)),
                                   (rows.max(), max(v))):
            self.assertLess(abs(measured - expected), 4.0)

        pixels = numpy.frombuffer(raw.data, numpy.uint8).reshape(raw.height, raw.width, 3)
        self.assertEqual((raw.encoding, raw.step), ("rgb8", 3 * raw.width))
        difference = numpy.abs(pixels[:, :, ::-1].astype(int) - decoded(same).astype(int))
        self.assertLess(difference.mean(), 6.0)

    def test_no_two_frames_of_a_standing_camera_are_the_same(self):
        with Topic("/camera/color/image_raw/compressed", CompressedImage) as photos:
            one, other = photos.next_many(2)
        self.assertNotEqual(one.data, other.data)
        self.assertLess(numpy.abs(decoded(one).astype(int) - decoded(other).astype(int)).mean(), 3.0)

    def test_the_cost_map_is_sent_once_and_then_updated(self):
        place = "/move_base/global_costmap/costmap"
        with Topic(place, OccupancyGrid) as full, Topic(f"{place}_updates", OccupancyGridUpdate) as updates, \
                Topic("/map", OccupancyGrid) as grids:
            cost, grid = full.first(), grids.first()
            some = updates.next_many(3)
            self.assertEqual(full.count, 1)
        self.assertEqual((cost.info.width, cost.info.height), (grid.info.width, grid.info.height))
        costs = numpy.array(cost.data).reshape(cost.info.height, cost.info.width)
        cells = numpy.array(grid.data).reshape(costs.shape)
        for update in some:
            patch = numpy.array(update.data).reshape(update.height, update.width)
            numpy.testing.assert_array_equal(
                patch, costs[update.y:update.y + update.height, update.x:update.x + update.width])
        # costmap_2d's inflation, from every free cell to the nearest wall: scipy-free brute force.
        walls = numpy.argwhere(cells == 100)
        for row, column in numpy.argwhere(cells == 0)[::37]:
            far = round(cost.info.resolution, 6) * math.sqrt(((walls - (row, column)) ** 2).sum(axis=1).min())
            expected = 253 if far <= 0.2154 else int(252 * math.exp(-10.0 * (far - 0.2154)))
            if far > 0.5 + 1e-9:
                expected = 0
            percent = 99 if expected == 253 else 0 if expected == 0 else 1 + 97 * (expected - 1) // 251
            self.assertLessEqual(abs(int(costs[row, column]) - percent), 1, (row, column, far))

    def test_goals_that_make_no_sense_are_aborted(self):
        tilted = goal_at(0.0, 0.0)
        tilted.target_pose.pose.orientation.x = 0.5
        nothing = goal_at(0.0, 0.0)
        nothing.target_pose.pose.orientation.w = 0.0
        for goal in (tilted, nothing):
            state, text = self.drive(goal)
            self.assertEqual(state, ABORTED)
            self.assertIn("invalid quaternion", text)
        for goal in (goal_at(50.0, 0.0), goal_at(float("nan"), 0.0)):
            state, text = self.drive(goal)
            self.assertEqual(state, ABORTED)
            self.assertIn("valid plan", text)

    def test_a_goal_may_be_given_in_the_odometrys_frame(self):
        state, _ = self.drive(goal_at(0.5, 0.1, 0.0, frame="odom"))
        self.assertEqual(state, SUCCEEDED)
        ros_client.wait_until(lambda: numpy.allclose(self.pose_in("odom")[:2], (0.5, 0.1), atol=0.01),
                              what="the goal's pose in odom")
        numpy.testing.assert_allclose(self.pose_in("map")[:2], (0.5 + small_room.START_MAP[0], 0.1), atol=0.01)

    def test_the_modes_are_switched(self):
        for mode in ("mapping", "localization"):
            rospy.ServiceProxy(f"/rtabmap/set_mode_{mode}", Empty)()


class Teleoperation(RobotCase):
    """Phase one: the map grows under an operator who drives by velocity."""

    parameters = ("_mapped:=false",)

    def setUp(self):
        self.velocity = rospy.Publisher("/cmd_vel", Twist, queue_size=1)
        ros_client.wait_until(lambda: self.velocity.get_num_connections() > 0, what="the robot's wheels")

    def command(self, forward, turn, until, within_s=ros_client.WITHIN_S):
        """Says so ten times a second, as a held key does, until an odometry message is as wanted."""
        twist = Twist()
        twist.linear.x, twist.angular.z = forward, turn

        def keep(_):
            self.velocity.publish(twist)
        timer = rospy.Timer(rospy.Duration(0.1), keep)
        try:
            return self.odometry.next(until, within_s)
        finally:
            timer.shutdown()
            timer.join()

    def test_it_stops_when_the_commands_go_silent(self):
        moving = self.command(0.2, 0.0, lambda message: message.twist.twist.linear.x > 0.1)
        self.assertAlmostEqual(moving.twist.twist.linear.x, 0.2, delta=0.05)
        last = rospy.Time.now()
        stood = self.odometry.next(stands)
        self.assertLess((stood.header.stamp - last).to_sec(), 1.5)

    def test_it_cannot_be_driven_faster_than_its_motors(self):
        moving = self.command(5.0, 0.0, lambda message: message.twist.twist.linear.x > 0.2)
        self.assertLess(moving.twist.twist.linear.x, 0.30)

    def test_walls_stop_it(self):
        self.command(-0.26, 0.0, lambda message: message.twist.twist.linear.x < -0.1)
        self.command(-0.26, 0.0, lambda message: message.twist.twist.linear.x == 0.0)
        x, _, _ = self.pose_in("map")
        self.assertGreater(x, -small_room.LENGTH_M / 2 + small_room.MAP_SHIFT[0] + 0.15)

    def test_the_map_grows_and_stands_still_when_localising(self):
        with Topic("/rtabmap/cloud_map", PointCloud2) as clouds, Topic("/map", OccupancyGrid) as grids, \
                Topic("/rtabmap/mapPath", Path) as paths, \
                Topic("/move_base/global_costmap/costmap", OccupancyGrid) as cost_maps:
            begin = clouds.after(publish_map)[0]
            grid, path, cost_map = grids.first(), paths.first(), cost_maps.first()
            turning = Twist()
            turning.angular.z = 1.0
            timer = rospy.Timer(rospy.Duration(0.1), lambda _: self.velocity.publish(turning))
            try:
                # Without being asked for: the map changes, and somebody listens.
                cost_maps.next(lambda message: message.info.width > cost_map.info.width)
                clouds.next(lambda message: message.width > 1.5 * begin.width)
                self.assertGreater(known(grids.messages[-1]), known(grid))
                self.assertGreater(len(paths.messages[-1].poses), len(path.poses))

                rospy.ServiceProxy("/rtabmap/set_mode_localization", Empty)()
                before = paths.after(publish_map)[0]
                self.odometry.next_many(30)
                after = paths.after(publish_map)[0]
                self.assertEqual(len(after.poses), len(before.poses))
            finally:
                timer.shutdown()
                timer.join()


def known(grid):
    return sum(1 for cell in grid.data if cell >= 0)


class Beginnings(unittest.TestCase):
    def test_the_cloud_comes_only_when_asked_for_and_is_latched_then(self):
        with start_robot():
            with Topic("/odom", Odometry) as odometry:
                odometry.next_many(3)
            with Topic("/rtabmap/cloud_map", PointCloud2) as clouds, Topic("/rtabmap/mapPath", Path) as paths:
                paths.first()
                paths.after(lambda: publish_map(graph_only=True))
                self.assertEqual(clouds.count, 0)
                cloud = clouds.after(publish_map)[0]
            self.assertEqual(cloud.header.frame_id, "map")
            self.assertEqual([field.name for field in cloud.fields], ["x", "y", "z", "rgb"])
            self.assertEqual(cloud.width * cloud.height, small_room.MAP_POINTS)
            self.assertEqual(len(cloud.data), cloud.row_step * cloud.height)
            points = points_of(cloud)
            self.assertAlmostEqual(float(points["x"].min()), -1.475 + small_room.MAP_SHIFT[0], places=5)
            self.assertAlmostEqual(float(points["y"].max()), 0.975, places=5)
            with Topic("/rtabmap/cloud_map", PointCloud2) as late:
                self.assertEqual(late.first().data, cloud.data)

    def test_the_same_seed_makes_the_same_map(self):
        def first_cloud(namespace, seed):
            with start_robot("_mapped:=false", f"_seed:={seed}", f"__ns:={namespace}"), \
                    Topic(f"/{namespace}/rtabmap/cloud_map", PointCloud2) as clouds:
                name = f"/{namespace}/rtabmap/publish_map"
                rospy.wait_for_service(name, ros_client.WITHIN_S)
                ros_client.wait_until(clouds.is_connected, what="a connection to the cloud")
                rospy.ServiceProxy(name, PublishMap)(True, True, False)
                return clouds.first().data
        one, same, other = first_cloud("one", 5), first_cloud("two", 5), first_cloud("three", 6)
        self.assertGreater(len(one), 1000)
        self.assertEqual(one, same)
        self.assertNotEqual(one, other)

    def test_it_waits_for_a_master_and_registers_with_the_next_one(self):
        core = RosCore()
        try:
            with start_robot("_start_x:=0.2", "_start_y:=-0.3", environment=core.environment, wait=False) as robot:
                robot.wait_for_line("Failed to contact master")
                core.start()
                robot.wait_for_line("the robot is ready")
                core.kill()
                core.start()
                robot.wait_for_line("another master answers")
                ros_client.wait_until(lambda: sum("the robot is ready" in line for line in robot.lines) == 2,
                                      what="the robot under its new master")
                master = xmlrpc.client.ServerProxy(core.uri)
                self.assertTrue(any(name == "/rtabmap/cloud_map" for name, _ in master.getSystemState("/tester")[2][0]))
                self.assertAlmostEqual(master.getParam("/tester", "/robot_simulator/start_x")[2], 0.2)
        finally:
            core.close()

    def test_it_brings_a_roscore_and_takes_it_along_when_it_ends(self):
        core = RosCore()
        try:
            with start_robot("--roscore", environment=core.environment):
                ros_client.wait_until(core.answers, what="the roscore")
            ros_client.wait_until(lambda: not core.answers(), what="the end of the roscore")
        finally:
            core.close()

    def test_the_built_in_tank_comes_with_its_map(self):
        with start_robot("_world:=builtin", "_map_file:=", "_image_rate:=1"), \
                Topic("/rtabmap/cloud_map", PointCloud2) as clouds, Topic("/rtabmap/mapPath", Path) as paths:
            self.assertGreater(len(paths.first().poses), 50)
            ros_client.wait_until(clouds.is_connected, what="a connection to the cloud")
            points = points_of(clouds.after(publish_map)[0])
            self.assertGreater(len(points), 50000)
            # The tank is 3 by 2.8 m, its floor near z = 0.
            self.assertAlmostEqual(float(numpy.ptp(points["x"])), 3.0, delta=0.4)
            self.assertAlmostEqual(float(numpy.ptp(points["y"])), 2.8, delta=0.4)
            self.assertLess(abs(float(numpy.percentile(points["z"], 20))), 0.05)

    def test_a_parameter_or_world_that_is_wrong_is_named(self):
        for parameter, complaint in (("_wrold:=builtin", "no such parameter"), ("_speed:=fast", "not a number"),
                                     ("_speed:=-1", "speed"), ("_world:=/nowhere.json", "/nowhere.json"),
                                     ("_faults/camera:=grumpy", "no such fault"), ("_image_width:=3", "image size")):
            with self.subTest(parameter=parameter), start_robot(parameter, wait=False) as robot:
                self.assertEqual(robot.wait_for_end(), 1)
                self.assertIn(complaint, "".join(robot.lines))
            rospy.delete_param("/robot_simulator")


if __name__ == "__main__":
    Site.open(sys.argv.pop(1))
    try:
        unittest.main(verbosity=1, exit=False, warnings="ignore").result.wasSuccessful() or sys.exit(1)
    finally:
        Site.close()
