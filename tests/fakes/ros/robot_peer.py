#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A small ROS 1 robot in Python round actionlib's SimpleActionServer.

It shares no code with Fodscope, so that what both sides could get wrong alike shows. It drives straight lines in an
empty room and has the topics and services of the robot that Fodscope expects, under their default names.

What happens is told on standard output, one JSON object a line with the key "event":
  ready · goal {id, frame, x, y, yaw_deg, stamp} · arrived {id} · aborted {id} · preempted {id} ·
  velocity {linear, angular} (when it changes) · service {name}
It ends when its standard input closes.
"""

import argparse
import json
import math
import struct
import sys
import threading

import actionlib
import cv2
import genpy
import numpy
import rospy
import tf2_ros
from geometry_msgs.msg import PoseStamped, TransformStamped, Twist
from map_msgs.msg import OccupancyGridUpdate
from move_base_msgs.msg import MoveBaseAction, MoveBaseFeedback, MoveBaseResult
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, PointCloud2, PointField
from std_srvs.srv import Empty, EmptyResponse

RATE_HZ = 20.0
RESOLUTION_M = 0.05
CAMERA_HEIGHT_M = 0.20
WIDTH_PX, HEIGHT_PX, FOCAL_PX = 320, 180, 233.0


class PublishMapRequest(genpy.Message):
    """rtabmap's PublishMap, which no Debian package has: three bools."""

    _md5sum = "6213f9f13cced23f4d224b22f59d839c"
    _type = "rtabmap_msgs/PublishMapRequest"
    __slots__ = ["is_global", "is_optimized", "is_graph_only"]
    _slot_types = ["bool", "bool", "bool"]

    def serialize(self, buff):
        buff.write(struct.pack("<3B", self.is_global, self.is_optimized, self.is_graph_only))

    def deserialize(self, data):
        self.is_global, self.is_optimized, self.is_graph_only = map(bool, struct.unpack("<3B", data[:3]))
        return self


class PublishMapResponse(genpy.Message):
    _md5sum = "d41d8cd98f00b204e9800998ecf8427e"
    _type = "rtabmap_msgs/PublishMapResponse"
    __slots__ = []
    _slot_types = []

    def serialize(self, buff):
        pass

    def deserialize(self, data):
        return self


class PublishMap:
    _type = "rtabmap_msgs/PublishMap"
    _md5sum = "6213f9f13cced23f4d224b22f59d839c"
    _request_class = PublishMapRequest
    _response_class = PublishMapResponse


_output_lock = threading.Lock()


def tell(event, **details):
    with _output_lock:
        print(json.dumps({"event": event, **details}), flush=True)


def quaternion_of(yaw):
    return {"z": math.sin(yaw / 2), "w": math.cos(yaw / 2)}


def yaw_of(q):
    return math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))


def turned(angle):
    return math.atan2(math.sin(angle), math.cos(angle))


class Body:
    """Where the robot is, in the map frame. The odom frame lies where it started."""

    def __init__(self, start, speed):
        self.start = tuple(start)
        self.x, self.y, self.yaw = start
        self.speed = speed
        self.velocity = (0.0, 0.0)
        self.lock = threading.Lock()

    def pose(self):
        with self.lock:
            return self.x, self.y, self.yaw

    def roll(self, seconds):
        with self.lock:
            linear, angular = self.velocity
            self.yaw = turned(self.yaw + angular * seconds)
            self.x += linear * seconds * math.cos(self.yaw)
            self.y += linear * seconds * math.sin(self.yaw)

    def step_towards(self, goal, seconds):
        """@return whether it is there"""
        x, y, yaw = goal
        with self.lock:
            dx, dy = x - self.x, y - self.y
            left, step = math.hypot(dx, dy), self.speed * seconds
            if left > step:
                self.yaw = math.atan2(dy, dx)
                self.x += dx / left * step
                self.y += dy / left * step
                self.velocity = (self.speed, 0.0)
                return False
            self.x, self.y, self.yaw = x, y, yaw
            self.velocity = (0.0, 0.0)
            return True

    def stand(self):
        with self.lock:
            self.velocity = (0.0, 0.0)


class MoveBase:
    def __init__(self, body, behaviour):
        self.body = body
        self.behaviour = behaviour
        self.server = actionlib.SimpleActionServer("move_base", MoveBaseAction, self.execute, auto_start=False)
        self.server.start()

    def execute(self, goal):
        target = goal.target_pose
        pose = (target.pose.position.x, target.pose.position.y, yaw_of(target.pose.orientation))
        goal_id = self.server.current_goal.get_goal_id()
        tell("goal", id=goal_id.id, frame=target.header.frame_id, x=pose[0], y=pose[1],
             yaw_deg=math.degrees(pose[2]), stamp=goal_id.stamp.to_sec())
        rate = rospy.Rate(RATE_HZ)
        begun = rospy.get_time()
        while not rospy.is_shutdown():
            if self.server.is_preempt_requested():
                self.body.stand()
                tell("preempted", id=goal_id.id)
                self.server.set_preempted(MoveBaseResult(), "preempted")
                return
            if self.behaviour == "abort" and rospy.get_time() - begun > 0.5:
                self.body.stand()
                tell("aborted", id=goal_id.id)
                self.server.set_aborted(MoveBaseResult(), "Failed to find a valid plan.")
                return
            arrived = self.behaviour != "stuck" and self.body.step_towards(pose, 1.0 / RATE_HZ)
            self.server.publish_feedback(self.feedback())
            if arrived:
                tell("arrived", id=goal_id.id)
                self.server.set_succeeded(MoveBaseResult(), "Goal reached.")
                return
            rate.sleep()

    def feedback(self):
        x, y, yaw = self.body.pose()
        feedback = MoveBaseFeedback()
        feedback.base_position.header.frame_id = "map"
        feedback.base_position.header.stamp = rospy.Time.now()
        fill_pose(feedback.base_position.pose, x, y, yaw)
        return feedback


def fill_pose(pose, x, y, yaw):
    pose.position.x, pose.position.y = x, y
    pose.orientation.z, pose.orientation.w = quaternion_of(yaw).values()


def transform(parent, child, x, y, yaw, stamp):
    t = TransformStamped()
    t.header.frame_id, t.child_frame_id, t.header.stamp = parent, child, stamp
    t.transform.translation.x, t.transform.translation.y = x, y
    t.transform.rotation.z, t.transform.rotation.w = quaternion_of(yaw).values()
    return t


class Frames:
    def __init__(self, body):
        self.body = body
        self.odometry = rospy.Publisher("odom", Odometry, queue_size=10)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.fixed = tf2_ros.StaticTransformBroadcaster()
        optical = transform("base_link", "camera_color_optical_frame", 0.0, 0.0, 0.0, rospy.Time.now())
        optical.transform.translation.z = CAMERA_HEIGHT_M
        r = optical.transform.rotation
        r.x, r.y, r.z, r.w = -0.5, 0.5, -0.5, 0.5
        self.fixed.sendTransform([transform("base_footprint", "base_link", 0, 0, 0, rospy.Time.now()), optical])

    def send(self):
        stamp = rospy.Time.now()
        x0, y0, yaw0 = self.body.start
        x, y, yaw = self.body.pose()
        dx, dy, c, s = x - x0, y - y0, math.cos(yaw0), math.sin(yaw0)
        in_odom = (c * dx + s * dy, c * dy - s * dx, yaw - yaw0)
        self.broadcaster.sendTransform([transform("map", "odom", x0, y0, yaw0, stamp),
                                        transform("odom", "base_footprint", *in_odom, stamp)])
        message = Odometry()
        message.header.frame_id, message.header.stamp, message.child_frame_id = "odom", stamp, "base_footprint"
        fill_pose(message.pose.pose, *in_odom)
        message.twist.twist.linear.x, message.twist.twist.angular.z = self.body.velocity
        self.odometry.publish(message)


def picture(file):
    if file:
        image = cv2.imread(file)
        if image is None:
            sys.exit(f"error: {file}: no picture that OpenCV reads; give a JPEG or PNG")
        return image
    image = numpy.full((HEIGHT_PX, WIDTH_PX, 3), 90, numpy.uint8)
    cv2.rectangle(image, (120, 70), (200, 130), (30, 60, 200), -1)
    return image


class Camera:
    """Every frame differs a little from the one before, as a real sensor's do."""

    def __init__(self, file):
        self.image = picture(file)
        self.count = 0
        self.raw = rospy.Publisher("camera/color/image_raw", Image, queue_size=2)
        self.compressed = rospy.Publisher("camera/color/image_raw/compressed", CompressedImage, queue_size=2)
        self.info = rospy.Publisher("camera/color/camera_info", CameraInfo, queue_size=2)

    def send(self):
        self.count += 1
        image = self.image.copy()
        image[self.count % image.shape[0], :, :] //= 2
        stamp, frame = rospy.Time.now(), "camera_color_optical_frame"
        height, width = image.shape[:2]

        raw = Image(height=height, width=width, encoding="rgb8", step=3 * width)
        raw.data = cv2.cvtColor(image, cv2.COLOR_BGR2RGB).tobytes()
        small = CompressedImage(format="rgb8; jpeg compressed bgr8", data=cv2.imencode(".jpg", image)[1].tobytes())
        focal = FOCAL_PX * width / WIDTH_PX
        info = CameraInfo(height=height, width=width, distortion_model="plumb_bob", D=[0.0] * 5)
        info.K = [focal, 0, width / 2, 0, focal, height / 2, 0, 0, 1]
        info.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
        info.P = [focal, 0, width / 2, 0, 0, focal, height / 2, 0, 0, 0, 1, 0]
        for publisher, message in ((self.info, info), (self.raw, raw), (self.compressed, small)):
            message.header.stamp, message.header.frame_id = stamp, frame
            publisher.publish(message)


class Room:
    """An empty room: its grid, cost map and map cloud."""

    def __init__(self, length, width, body):
        self.length, self.width, self.body = length, width, body
        self.grids = [rospy.Publisher(topic, OccupancyGrid, queue_size=1, latch=True)
                      for topic in ("map", "rtabmap/grid_map")]
        self.cost_map = rospy.Publisher("move_base/global_costmap/costmap", OccupancyGrid, queue_size=1, latch=True)
        self.updates = rospy.Publisher("move_base/global_costmap/costmap_updates", OccupancyGridUpdate, queue_size=5)
        self.cloud = rospy.Publisher("rtabmap/cloud_map", PointCloud2, queue_size=1, latch=True)
        self.path = rospy.Publisher("rtabmap/mapPath", Path, queue_size=1, latch=True)
        for grid in self.grids:
            grid.publish(self.grid_message(100))
        self.cost_map.publish(self.grid_message(99))

    def grid_message(self, border):
        columns, rows = round(self.length / RESOLUTION_M), round(self.width / RESOLUTION_M)
        cells = numpy.zeros((rows, columns), numpy.int8)
        cells[[0, -1], :] = cells[:, [0, -1]] = border
        message = OccupancyGrid()
        message.header.frame_id, message.header.stamp = "map", rospy.Time.now()
        message.info.resolution, message.info.width, message.info.height = RESOLUTION_M, columns, rows
        message.info.origin.position.x = -self.length / 2
        message.info.origin.position.y = -self.width / 2
        message.info.origin.orientation.w = 1.0
        message.data = cells.flatten().tolist()
        return message

    def send_update(self):
        """A cell of the wall changes, as one does when the sensor sees it again."""
        update = OccupancyGridUpdate(x=0, y=0, width=1, height=1, data=[100])
        update.header.frame_id, update.header.stamp = "map", rospy.Time.now()
        self.updates.publish(update)

    def send_cloud(self):
        """rtabmap's layout: x, y, z and rgb in 32 bytes a point. The floor and one wall, 2 cm apart."""
        points = []
        for x in numpy.arange(-self.length / 2, self.length / 2, 0.02):
            points += [(x, y, 0.0) for y in numpy.arange(-self.width / 2, self.width / 2, 0.02)]
            points += [(x, self.width / 2, z) for z in numpy.arange(0.02, 0.5, 0.02)]
        layout = numpy.dtype({"names": ["x", "y", "z", "rgb"], "formats": ["<f4", "<f4", "<f4", "<u4"],
                              "offsets": [0, 4, 8, 16], "itemsize": 32})
        data = numpy.zeros(len(points), layout)
        data["x"], data["y"], data["z"] = numpy.array(points).T
        data["rgb"] = 0x808080
        message = PointCloud2(height=1, width=len(points), point_step=32, row_step=32 * len(points), is_dense=True)
        message.header.frame_id, message.header.stamp = "map", rospy.Time.now()
        message.fields = [PointField(name, offset, PointField.FLOAT32, 1)
                          for name, offset in (("x", 0), ("y", 4), ("z", 8), ("rgb", 16))]
        message.data = data.tobytes()
        self.cloud.publish(message)

    def send_path(self):
        message = Path()
        message.header.frame_id, message.header.stamp = "map", rospy.Time.now()
        for i in range(5):
            pose = PoseStamped(header=message.header)
            fill_pose(pose.pose, self.body.start[0] + 0.1 * i, self.body.start[1], 0.0)
            message.poses.append(pose)
        self.path.publish(message)


class Services:
    def __init__(self, room):
        self.room = room
        for name in ("set_mode_localization", "set_mode_mapping"):
            rospy.Service(f"rtabmap/{name}", Empty, lambda _, name=name: self.answer(name))
        rospy.Service("rtabmap/publish_map", PublishMap, self.publish_map)

    def answer(self, name):
        tell("service", name=name)
        return EmptyResponse()

    def publish_map(self, request):
        tell("service", name="publish_map", graph_only=request.is_graph_only)
        self.room.send_path()
        if not request.is_graph_only:
            self.room.send_cloud()
        return PublishMapResponse()


class Teleoperation:
    def __init__(self, body):
        self.body = body
        rospy.Subscriber("cmd_vel", Twist, self.hear, queue_size=1)

    def hear(self, message):
        velocity = (message.linear.x, message.angular.z)
        with self.body.lock:
            changed, self.body.velocity = velocity != self.body.velocity, velocity
        if changed:
            tell("velocity", linear=velocity[0], angular=velocity[1])


def end_with_standard_input():
    sys.stdin.buffer.read()
    rospy.signal_shutdown("standard input closed")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--start", type=float, nargs=3, default=[0.0, 0.0, 0.0], metavar=("X", "Y", "YAW"),
                        help="where it stands, map frame, metres and radians")
    parser.add_argument("--speed", type=float, default=1.0, help="m/s")
    parser.add_argument("--room", type=float, nargs=2, default=[4.0, 3.0], metavar=("LENGTH", "WIDTH"),
                        help="metres, about the map's origin")
    parser.add_argument("--goals", choices=["succeed", "abort", "stuck"], default="succeed")
    parser.add_argument("--photo", help="picture that the camera shows; default a red square")
    options = parser.parse_args(rospy.myargv()[1:])

    rospy.init_node("robot_peer", log_level=rospy.WARN, disable_signals=True)
    threading.Thread(target=end_with_standard_input, daemon=True).start()
    body = Body(options.start, options.speed)
    room = Room(*options.room, body)
    frames, camera = Frames(body), Camera(options.photo)
    Services(room)
    Teleoperation(body)
    move_base = MoveBase(body, options.goals)
    tell("ready")

    rate, ticks = rospy.Rate(RATE_HZ), 0
    while not rospy.is_shutdown():
        if not move_base.server.is_active():
            body.roll(1.0 / RATE_HZ)
        frames.send()
        if ticks % 4 == 0:
            camera.send()
        if ticks % 20 == 0:
            room.send_update()
        ticks += 1
        try:
            rate.sleep()
        except rospy.ROSInterruptException:
            break


if __name__ == "__main__":
    main()
