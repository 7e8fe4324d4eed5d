#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Each fault of the robot simulator does what its name says, and is over when it is taken back."""

import sys
import unittest

import ros_client

ros_client.skip_without_ros(*sys.argv[1:2])

import cv2
import numpy
import rosgraph
import rospy
from map_msgs.msg import OccupancyGridUpdate
from move_base_msgs.msg import MoveBaseActionResult
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import CompressedImage, Image, PointCloud2
from std_srvs.srv import Empty
from tf2_msgs.msg import TFMessage

import small_room
from robot_case import (ABORTED, ACTIVE, PREEMPTED, REJECTED, SUCCEEDED, RobotCase, Site, goal_at, stands)
from robot_peer import PublishMap
from ros_client import Topic

FAR, NEAR = (0.9, -0.5), (-0.6, 0.3)


def at_home(pose, tolerance=0.02):
    return abs(pose[0] - small_room.START_MAP[0]) < tolerance and abs(pose[1]) < tolerance


class GoalFaults(RobotCase):
    def setUp(self):
        self.drive(goal_at(*small_room.START_MAP[:2]))

    def test_a_lost_goal_never_shows_in_the_status(self):
        self.set_fault(goal="lost")
        lost = self.send(goal_at(*NEAR))
        self.assertEqual(self.statuses_of(lost, 5), [None] * 5)

    def test_a_fault_may_hit_so_many_goals_only(self):
        self.set_fault(goal="lost", goal_times=1)
        lost = self.send(goal_at(*NEAR))
        self.assertEqual(self.statuses_of(lost, 3), [None] * 3)
        self.assertEqual(self.drive(goal_at(*NEAR))[0], SUCCEEDED)
        self.set_fault(goal_times=0)

    def test_a_rejected_goal(self):
        self.set_fault(goal="rejected")
        self.assertEqual(self.drive(goal_at(*NEAR))[0], REJECTED)

    def test_an_aborted_goal_ends_on_the_way(self):
        self.set_fault(goal="aborted")
        state, text = self.drive(goal_at(*FAR))
        self.assertEqual(state, ABORTED)
        self.assertIn("Failed to find a valid plan", text)
        pose = self.pose_in("map")
        self.assertFalse(at_home(pose, 0.1))
        self.assertGreater(numpy.hypot(pose[0] - FAR[0], pose[1] - FAR[1]), 0.1)

    def test_somebody_else_preempts_the_goal(self):
        self.set_fault(goal="preempted")
        self.assertEqual(self.drive(goal_at(*FAR))[0], PREEMPTED)
        other = self.status.next(lambda message: any(one.goal_id.id.startswith("/rviz-") and one.status == SUCCEEDED
                                                     for one in message.status_list))
        self.assertTrue(other)
        self.assertTrue(at_home(self.pose_in("map")))

    def test_a_robot_that_never_arrives_stands_with_an_active_goal(self):
        self.set_fault(goal="never_arrives")
        goal_id = self.send(goal_at(*FAR))
        self.odometry.next(lambda message: not stands(message))
        self.odometry.next(stands)
        self.odometry.next_many(15, stands)
        self.assertEqual(self.statuses_of(goal_id, 3), [ACTIVE] * 3)
        self.client.cancel_goal()
        self.wait_for_status(goal_id, PREEMPTED)

    def test_the_server_restarts_and_forgets_its_goal(self):
        self.set_fault(goal="server_restarts")
        goal_id = self.send(goal_at(*FAR))
        self.wait_for_status(goal_id, ACTIVE)
        self.status.next(lambda message: not message.status_list)
        self.clear_faults()
        self.odometry.next(stands)
        ros_client.wait_until(self.client.action_client.wait_for_server, what="the server")
        self.assertEqual(self.drive(goal_at(*NEAR))[0], SUCCEEDED)

    def test_there_is_no_server(self):
        master = rosgraph.Master("/tester")

        def serves():
            return any(topic == "/move_base/status" for topic, _ in master.getSystemState()[0])
        self.assertTrue(serves())
        self.set_fault(goal="no_server")
        ros_client.wait_until(lambda: not serves(), what="the end of the server")
        self.clear_faults()
        ros_client.wait_until(serves, what="the server's return")
        ros_client.wait_until(self.client.action_client.wait_for_server, what="the server")

    def test_a_lost_result_shows_in_the_status_alone(self):
        self.set_fault(goal="result_lost")
        with Topic("/move_base/result", MoveBaseActionResult) as results:
            goal_id = self.send(goal_at(*NEAR))
            self.wait_for_status(goal_id, SUCCEEDED)
            self.statuses_of(goal_id, 3)
            self.assertEqual(results.count, 0)

    def test_a_lost_cancel_stops_nothing(self):
        self.set_fault(goal="cancel_lost")
        goal_id = self.send(goal_at(*FAR))
        self.odometry.next(lambda message: not stands(message))
        self.client.cancel_goal()
        self.wait_for_status(goal_id, SUCCEEDED)


class OtherFaults(RobotCase):
    def links(self, count, parent="map"):
        with Topic("/tf", TFMessage) as frames:
            return [link for message in frames.next_many(count) for link in message.transforms
                    if link.header.frame_id == parent]

    def test_a_missing_tf_has_no_map_frame(self):
        self.set_fault(tf="missing")
        with Topic("/tf", TFMessage) as frames:
            frames.next(lambda message: [link.header.frame_id for link in message.transforms] == ["odom"])
        self.assertEqual(self.links(20), [])

    def test_a_stale_tf_grows_old(self):
        with Topic("/tf", TFMessage) as frames:
            frames.first()
            self.set_fault(tf="stale")
            self.odometry.next_many(3)
            count = frames.count
            self.odometry.next_many(15)
            self.assertEqual(frames.count, count)

    def test_a_jumped_map_frame(self):
        before = self.pose_in("map", of="odom")
        self.set_fault(tf="jumped", tf_jump_x_m=0.4, tf_jump_y_m=-0.2, tf_jump_yaw_deg=30.0)
        with Topic("/tf", TFMessage) as frames:
            jumped = frames.next(lambda message: any(
                link.header.frame_id == "map" and abs(link.transform.translation.x - before[0] - 0.4) < 1e-6
                for link in message.transforms))
        link = next(one for one in jumped.transforms if one.header.frame_id == "map")
        self.assertAlmostEqual(link.transform.translation.y, before[1] - 0.2)
        self.assertAlmostEqual(2 * numpy.degrees(numpy.arcsin(link.transform.rotation.z)), 30.0, places=4)

    def test_the_clock_is_off(self):
        for offset in (2.0, -2.0):
            self.set_fault(clock_offset_s=offset)
            self.odometry.next(lambda message: abs((message.header.stamp - rospy.Time.now()).to_sec() - offset) < 0.9)
            link = self.links(1)[0]
            self.assertAlmostEqual((link.header.stamp - rospy.Time.now()).to_sec(), offset, delta=0.9)
            with Topic("/camera/color/image_raw/compressed", CompressedImage) as photos:
                self.assertAlmostEqual((photos.next().header.stamp - rospy.Time.now()).to_sec(), offset, delta=0.9)

    def photos_with(self, fault, holds, raw_holds=None):
        with Topic("/camera/color/image_raw/compressed", CompressedImage) as photos, \
                Topic("/camera/color/image_raw", Image) as raws:
            photos.first()
            self.set_fault(camera=fault)
            photos.next(holds)
            if raw_holds:
                raws.next(raw_holds)
            self.clear_faults()
            photos.next(lambda photo: not holds(photo) and mean_of(photo) > 5)

    def test_a_silent_camera(self):
        with Topic("/camera/color/image_raw/compressed", CompressedImage) as photos:
            photos.first()
            self.set_fault(camera="silent")
            self.odometry.next_many(5)
            count = photos.count
            self.odometry.next_many(20)
            self.assertEqual(photos.count, count)
            self.clear_faults()
            photos.next()

    def test_a_frozen_camera_repeats_a_picture_under_new_stamps(self):
        with Topic("/camera/color/image_raw/compressed", CompressedImage) as photos:
            photos.first()
            self.set_fault(camera="frozen")
            photos.next()
            one, other = photos.next_many(2)
        self.assertEqual(one.data, other.data)
        self.assertLess(one.header.stamp, other.header.stamp)

    def test_a_black_camera(self):
        self.photos_with("black", lambda photo: mean_of(photo) < 1, lambda raw: max(raw.data) == 0)

    def test_a_corrupt_jpeg(self):
        self.photos_with("corrupt", lambda photo: photo.data[-2:] != b"\xff\xd9",
                         lambda raw: len(raw.data) < raw.step * raw.height)

    def test_a_wrong_encoding(self):
        self.photos_with("wrong_encoding",
                         lambda photo: "compressedDepth" in photo.format and photo.data[:2] != b"\xff\xd8",
                         lambda raw: raw.encoding == "32FC1" and raw.step != 4 * raw.width)

    def test_a_huge_picture(self):
        self.photos_with("huge", lambda photo: size_in_header(photo.data) == (65500, 65500) and len(photo.data) < 1e6,
                         lambda raw: raw.width == 65500 and len(raw.data) < raw.step * raw.height)

    def test_clouds(self):
        step, points = 32, small_room.MAP_POINTS
        checks = {
            "none": lambda cloud: len(cloud.data) == step * points and cloud.row_step == step * points,
            "nan": lambda cloud: numpy.isnan(xyz(cloud)).any(axis=1).sum() == points / 3,
            "empty": lambda cloud: cloud.width == 0 and len(cloud.data) == 0,
            "missing_fields": lambda cloud: "z" not in [field.name for field in cloud.fields],
            "wrong_row_step": lambda cloud: cloud.row_step != cloud.width * cloud.point_step,
            "truncated": lambda cloud: len(cloud.data) < cloud.row_step * cloud.height,
        }
        with Topic("/rtabmap/cloud_map", PointCloud2) as clouds:
            ros_client.wait_until(clouds.is_connected, what="a connection to the cloud")
            for fault, holds in checks.items():
                with self.subTest(fault=fault):
                    self.set_fault(cloud=fault)
                    self.assertTrue(holds(clouds.after(self.publish_map)[0]))
            self.set_fault(cloud="silent")
            count = clouds.count
            self.publish_map()
            self.odometry.next_many(10)
            self.assertEqual(clouds.count, count)

    @staticmethod
    def publish_map():
        rospy.ServiceProxy("/rtabmap/publish_map", PublishMap)(True, True, False)

    def test_the_cost_map_is_silent(self):
        self.set_fault(costmap="silent")
        with Topic("/move_base/global_costmap/costmap", OccupancyGrid) as full, \
                Topic("/move_base/global_costmap/costmap_updates", OccupancyGridUpdate) as updates:
            ros_client.wait_until(full.is_connected, what="a connection to the cost map")
            self.odometry.next_many(15)
            self.assertEqual((full.count, updates.count), (0, 0))

    def test_the_cost_map_has_the_wrong_size(self):
        self.set_fault(costmap="wrong_size")
        with Topic("/move_base/global_costmap/costmap", OccupancyGrid) as full:
            grid = full.first()
        self.assertLess(len(grid.data), grid.info.width * grid.info.height)

    def test_an_update_lies_outside_of_the_cost_map(self):
        self.set_fault(costmap="update_outside")
        with Topic("/move_base/global_costmap/costmap", OccupancyGrid) as full, \
                Topic("/move_base/global_costmap/costmap_updates", OccupancyGridUpdate) as updates:
            grid = full.first()
            updates.next(lambda update: update.x + update.width > grid.info.width)

    def test_failing_and_missing_services(self):
        self.set_fault(services="failing")
        with self.assertRaises(rospy.ServiceException):
            rospy.ServiceProxy("/rtabmap/set_mode_mapping", Empty)()
        with self.assertRaises(rospy.ServiceException):
            self.publish_map()
        self.set_fault(services="missing")
        master = rosgraph.Master("/tester")

        def offers():
            return any(name.startswith("/rtabmap/") for name, _ in master.getSystemState()[2])
        ros_client.wait_until(lambda: not offers(), what="the end of the services")
        self.clear_faults()
        ros_client.wait_until(offers, what="the services' return")

    def test_the_odometry_is_silent(self):
        self.set_fault(odometry="silent")
        with Topic("/tf", TFMessage) as frames:
            frames.next_many(3)
            count = self.odometry.count
            frames.next_many(15)
            self.assertEqual(self.odometry.count, count)

    def test_an_unknown_fault_changes_nothing(self):
        rospy.set_param("/robot_simulator/faults/camera", "grumpy")
        self.robot.wait_for_line("no such fault")
        with Topic("/camera/color/image_raw/compressed", CompressedImage) as photos:
            self.assertGreater(mean_of(photos.next()), 5)


def mean_of(photo):
    image = cv2.imdecode(numpy.frombuffer(photo.data, numpy.uint8), cv2.IMREAD_COLOR)
    return -1 if image is None else image.mean()


def size_in_header(jpeg):
    """@return width and height by the frame header"""
    at = 2
    while at + 9 < len(jpeg):
        if 0xC0 <= jpeg[at + 1] <= 0xC2:
            return int.from_bytes(jpeg[at + 7:at + 9], "big"), int.from_bytes(jpeg[at + 5:at + 7], "big")
        at += 2 + int.from_bytes(jpeg[at + 2:at + 4], "big")
    return None


def xyz(cloud):
    return numpy.frombuffer(cloud.data, numpy.float32).reshape(cloud.width, cloud.point_step // 4)[:, :3]


if __name__ == "__main__":
    Site.open(sys.argv.pop(1))
    try:
        unittest.main(verbosity=1, exit=False, warnings="ignore").result.wasSuccessful() or sys.exit(1)
    finally:
        Site.close()
