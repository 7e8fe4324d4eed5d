#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The small robot of robot_peer.py with faults that can be set while it runs.

Every line of its standard input is a JSON object of settings, which stay until they are set again:
  goals      succeed · lose · reject · abort · preempt · stuck · forget (the server was restarted) · silent
  tf         ok · stopped
  jump       metres that the map frame has moved
  clock      seconds that the robot's clock is ahead
  odometry   ok · none
  camera     ok · silent · stopped · frozen · black · corrupt · encoding · huge · uncalibrated · other-size
  cloud      ok · nan · empty · nothing-finite · no-z · row-step · cut
  {"send": "cloud" | "costmap update" | "foreign goal"} does something once.
What happens is told on standard output as robot_peer.py does it. It ends when its standard input closes.
"""

import json
import struct
import sys
import threading

import numpy
import rospy
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from geometry_msgs.msg import Twist
from map_msgs.msg import OccupancyGridUpdate
from move_base_msgs.msg import MoveBaseActionFeedback, MoveBaseActionGoal, MoveBaseActionResult

from robot_peer import RATE_HZ, Body, Camera, Frames, Room, Services, tell, yaw_of

faults = {"goals": "succeed", "tf": "ok", "jump": 0.0, "clock": 0.0, "odometry": "ok", "camera": "ok", "cloud": "ok"}


def stamp():
    return rospy.Time.from_sec(rospy.get_time() + faults["clock"])


class Navigation:
    """A move_base that works at the level of topics, so that it can do what no server should."""

    def __init__(self, body):
        self.body = body
        self.lock = threading.Lock()
        self.known = {}
        self.current = None
        self.target = None
        self.status = rospy.Publisher("move_base/status", GoalStatusArray, queue_size=10)
        self.result = rospy.Publisher("move_base/result", MoveBaseActionResult, queue_size=10)
        self.feedback = rospy.Publisher("move_base/feedback", MoveBaseActionFeedback, queue_size=10)
        rospy.Subscriber("move_base/goal", MoveBaseActionGoal, self.take, queue_size=10)
        rospy.Subscriber("move_base/cancel", GoalID, self.cancel, queue_size=10)

    def take(self, message):
        pose = message.goal.target_pose.pose
        target = (pose.position.x, pose.position.y, yaw_of(pose.orientation))
        tell("goal", id=message.goal_id.id, frame=message.goal.target_pose.header.frame_id, x=target[0], y=target[1],
             stamp=message.goal_id.stamp.to_sec())
        with self.lock:
            if faults["goals"] in ("lose", "silent"):
                return
            status = GoalStatus(goal_id=message.goal_id, status=GoalStatus.ACTIVE)
            self.known[message.goal_id.id] = status
            if faults["goals"] == "reject":
                self.end(status, GoalStatus.REJECTED, "the goal's quaternion is not upright")
                return
            newer = self.current is None or message.goal_id.stamp >= self.current.goal_id.stamp
            if not newer:
                self.end(status, GoalStatus.RECALLED, "another goal was received")
                return
            if self.current is not None:
                self.end(self.current, GoalStatus.PREEMPTED, "another goal was received")
            self.current, self.target = status, target

    def cancel(self, message):
        tell("cancel", id=message.id)
        with self.lock:
            if self.current is not None and message.id in ("", self.current.goal_id.id):
                self.end(self.current, GoalStatus.PREEMPTED, "")

    def end(self, status, how, text):
        status.status, status.text = how, text
        if status is self.current:
            self.current = self.target = None
            self.body.stand()
        result = MoveBaseActionResult(status=status)
        result.header.stamp = stamp()
        self.result.publish(result)

    def step(self, seconds):
        with self.lock:
            if self.current is None:
                return False
            mode = faults["goals"]
            if mode == "forget":
                self.known, self.current, self.target = {}, None, None
                self.body.stand()
            elif mode == "abort":
                self.end(self.current, GoalStatus.ABORTED, "Failed to find a valid plan.")
            elif mode == "preempt":
                self.end(self.current, GoalStatus.PREEMPTED, "")
            elif mode == "stuck":
                self.body.velocity = (0.05, 0.0)
            elif self.body.step_towards(self.target, seconds):
                tell("arrived", id=self.current.goal_id.id)
                self.end(self.current, GoalStatus.SUCCEEDED, "Goal reached.")
            return True

    def send_status(self):
        if faults["goals"] == "silent":
            return
        message = GoalStatusArray()
        message.header.stamp = stamp()
        with self.lock:
            message.status_list = list(self.known.values())
        self.status.publish(message)


class FaultyFrames(Frames):
    def send(self):
        publish, self.odometry = self.odometry, self
        try:
            self.sent = None
            broadcaster, self.broadcaster = self.broadcaster, self
            try:
                super().send()
            finally:
                self.broadcaster = broadcaster
        finally:
            self.odometry = publish
        if faults["odometry"] == "ok":
            self.sent.header.stamp = stamp()
            publish.publish(self.sent)
        if faults["tf"] == "ok":
            for each in self.transforms:
                each.header.stamp = stamp()
            self.transforms[0].transform.translation.x += faults["jump"]
            self.broadcaster.sendTransform(self.transforms)

    # Stand in for the publishers while the peer fills its messages in.
    def publish(self, message):
        self.sent = message

    def sendTransform(self, transforms):
        self.transforms = transforms


class FaultyCamera(Camera):
    def __init__(self, file):
        super().__init__(file)
        self.publishers = self.info, self.raw, self.compressed
        self.info = self.raw = self.compressed = None
        self.frozen = None
        self.stopped_at = None

    def send(self):
        sent = []
        self.info, self.raw, self.compressed = (Recorder(sent) for _ in range(3))
        super().send()
        mode = faults["camera"]
        info, raw, small = sent
        if mode == "silent":
            return
        self.stopped_at = (self.stopped_at or stamp()) if mode == "stopped" else None
        self.frozen = (self.frozen or small.data) if mode == "frozen" else None
        if mode == "frozen":
            small.data = self.frozen
        elif mode == "black":
            import cv2
            small.data = cv2.imencode(".jpg", numpy.zeros_like(self.image))[1].tobytes()
        elif mode == "corrupt":
            small.data = small.data[:len(small.data) // 2]
        elif mode == "encoding":
            small.format, small.data = "32FC1; compressedDepth png", b"\0" * 12 + b"no photo"
        elif mode == "huge":
            small.data = small.data[:2] + huge_frame_header() + small.data[2:]
        elif mode == "uncalibrated":
            info.K = [0.0] * 9
        elif mode == "other-size":
            info.width, info.height = 2 * info.width, 2 * info.height
        for publisher, message in zip(self.publishers, (info, raw, small)):
            message.header.stamp = self.stopped_at or stamp()
            publisher.publish(message)


def huge_frame_header():
    """A JPEG frame of 65 535 × 65 535 before the real one."""
    return b"\xff\xc0" + struct.pack(">HBHHB", 17, 8, 65535, 65535, 3) + b"\x01\x11\0\x02\x11\0\x03\x11\0"


class Recorder:
    def __init__(self, sent):
        self.sent = sent

    def publish(self, message):
        self.sent.append(message)


class FaultyRoom(Room):
    def send_cloud(self):
        publisher, sent = self.cloud, []
        self.cloud = Recorder(sent)
        try:
            super().send_cloud()
        finally:
            self.cloud = publisher
        cloud, mode = sent[0], faults["cloud"]
        data = numpy.frombuffer(bytearray(cloud.data), numpy.float32).reshape(-1, 8)
        if mode == "nan":
            data[::10, 0] = numpy.nan
        elif mode == "nothing-finite":
            data[:, 2] = numpy.inf
        cloud.data = data.tobytes()
        if mode == "empty":
            cloud.width = cloud.row_step = 0
            cloud.data = b""
        elif mode == "no-z":
            cloud.fields = [field for field in cloud.fields if field.name != "z"]
        elif mode == "row-step":
            cloud.row_step //= 2
        elif mode == "cut":
            cloud.data = cloud.data[:-100]
        publisher.publish(cloud)


class Orders(threading.Thread):
    def __init__(self, room):
        super().__init__(daemon=True)
        self.room = room
        self.goals = rospy.Publisher("move_base/goal", MoveBaseActionGoal, queue_size=1)

    def run(self):
        for line in sys.stdin:
            order = json.loads(line)
            what = order.pop("send", None)
            unknown = set(order) - set(faults)
            if unknown:
                tell("error", text=f"unknown settings {sorted(unknown)}")
            faults.update(order)
            if what == "cloud":
                self.room.send_cloud()
            elif what == "costmap update":
                self.send_update()
            elif what == "foreign goal":
                self.send_foreign_goal()
            tell("done", order=line.strip())
        rospy.signal_shutdown("standard input closed")

    def send_update(self):
        update = OccupancyGridUpdate(x=2, y=3, width=2, height=1, data=[100, 100])
        update.header.frame_id = "map"
        self.room.updates.publish(update)

    def send_foreign_goal(self):
        goal = MoveBaseActionGoal()
        goal.goal_id.id, goal.goal_id.stamp = "somebody-else-1", rospy.Time.from_sec(stamp().to_sec() + 1.0)
        goal.goal.target_pose.header.frame_id = "map"
        goal.goal.target_pose.pose.orientation.w = 1.0
        self.goals.publish(goal)


class Driven:
    def __init__(self, body):
        rospy.Subscriber("cmd_vel", Twist, self.hear, queue_size=10)
        self.body = body
        self.told = None

    def hear(self, message):
        velocity = (message.linear.x, message.angular.z)
        self.body.velocity = velocity
        if velocity != self.told:
            self.told = velocity
            tell("velocity", linear=velocity[0], angular=velocity[1])


def main():
    rospy.init_node("faulty_robot", log_level=rospy.FATAL, disable_signals=True)
    body = Body([0.0, 0.0, 0.0], 2.0)
    room = FaultyRoom(4.0, 3.0, body)
    frames, camera = FaultyFrames(body), FaultyCamera(None)
    Services(room)
    Driven(body)
    navigation = Navigation(body)
    Orders(room).start()
    tell("ready")
    rate, ticks = rospy.Rate(RATE_HZ), 0
    while not rospy.is_shutdown():
        if not navigation.step(1.0 / RATE_HZ):
            body.roll(1.0 / RATE_HZ)
        frames.send()
        if ticks % 2 == 0:
            camera.send()
        if ticks % 4 == 0:
            navigation.send_status()
        ticks += 1
        try:
            rate.sleep()
        except rospy.ROSInterruptException:
            break


if __name__ == "__main__":
    main()
