# SPDX-License-Identifier: MIT
"""One roscore for a test program, and the simulator in the small room for each class of tests."""

import math
import os
import tempfile
import unittest

import actionlib
import rospy
import tf2_ros
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from move_base_msgs.msg import MoveBaseAction, MoveBaseActionResult, MoveBaseGoal
from nav_msgs.msg import Odometry
from std_msgs.msg import String

import ros_client
import small_room
from ros_core import RosCore

ACTIVE, PREEMPTED, SUCCEEDED, ABORTED, REJECTED = (
    GoalStatus.ACTIVE, GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED, GoalStatus.ABORTED, GoalStatus.REJECTED)


class Site:
    """What all tests of a program share."""

    program = None
    core = None
    folder = None

    @classmethod
    def open(cls, program):
        cls.program = program
        cls.folder = tempfile.TemporaryDirectory(prefix="fodscope-room-")
        cls.core = RosCore()
        cls.core.start()
        os.environ.update(cls.core.environment)
        rospy.init_node("tester", disable_signals=True, log_level=rospy.FATAL)

    @classmethod
    def close(cls):
        rospy.signal_shutdown("the tests are over")
        cls.core.close()
        cls.folder.cleanup()


def start_robot(*parameters, environment=None, wait=True):
    """@return the simulator's process; in the small room unless a parameter says otherwise"""
    world = small_room.write_world(Site.folder.name)
    quick = [f"_world:={world}", "_image_width:=320", "_image_height:=180", "_image_rate:=15", "_turn_speed:=6.0",
             "_speed:=1.5", f"_map_file:={small_room.write_map(Site.folder.name)}"]
    program = ros_client.Program([Site.program, *quick, *parameters], environment or Site.core.environment)
    if wait:
        try:
            program.wait_for_line("the robot is ready")
        except AssertionError:
            program.stop()
            raise
    return program


def goal_at(x, y, yaw=0.0, frame="map"):
    goal = MoveBaseGoal()
    goal.target_pose.header.frame_id = frame
    goal.target_pose.header.stamp = rospy.Time.now()
    goal.target_pose.pose.position.x, goal.target_pose.pose.position.y = x, y
    goal.target_pose.pose.orientation.z = math.sin(yaw / 2)
    goal.target_pose.pose.orientation.w = math.cos(yaw / 2)
    return goal


def stands(odometry):
    twist = odometry.twist.twist
    return twist.linear.x == 0 and twist.angular.z == 0


class RobotCase(unittest.TestCase):
    """Tests of one running simulator. Each begins without faults and with the robot standing."""

    parameters = ()

    @classmethod
    def start(cls):
        return start_robot(*cls.parameters)

    @classmethod
    def setUpClass(cls):
        cls.robot = cls.start()
        cls.odometry = ros_client.Topic("/odom", Odometry)
        cls.in_effect = ros_client.Topic("/robot_simulator/faults_in_effect", String)
        cls.status = ros_client.Topic("/move_base/status", GoalStatusArray)
        cls.results = ros_client.Topic("/move_base/result", MoveBaseActionResult)
        cls.client = actionlib.SimpleActionClient("move_base", MoveBaseAction)
        if not cls.client.wait_for_server(rospy.Duration(ros_client.WITHIN_S)):
            raise AssertionError("no move_base server")
        cls.tf = tf2_ros.Buffer()
        cls.tf_listener = tf2_ros.TransformListener(cls.tf)

    @classmethod
    def tearDownClass(cls):
        cls.robot.stop()
        for topic in (cls.odometry, cls.in_effect, cls.status, cls.results):
            topic.__exit__()
        if rospy.has_param("/robot_simulator"):
            rospy.delete_param("/robot_simulator")

    def tearDown(self):
        self.clear_faults()
        self.client.cancel_all_goals()
        self.odometry.next(stands)

    def set_fault(self, **faults):
        """@return when they are in effect"""
        for name, value in faults.items():
            rospy.set_param(f"/robot_simulator/faults/{name}", value)
        self.wait_for_faults(faults)

    def clear_faults(self):
        faults = rospy.get_param("/robot_simulator/faults", {})
        calm = {name: "none" if isinstance(value, str) else 0 for name, value in faults.items()}
        for name, value in calm.items():
            rospy.set_param(f"/robot_simulator/faults/{name}", value)
        if calm:
            self.wait_for_faults(calm)

    def wait_for_faults(self, faults):
        def in_effect():
            told = dict(word.split("=") for word in self.in_effect.messages[-1].data.split()) \
                if self.in_effect.messages else {}
            return all(name in told and (told[name] == value if isinstance(value, str)
                                         else float(told[name]) == float(value)) for name, value in faults.items())
        ros_client.wait_until(in_effect, what=f"{faults} in effect", every_s=0.005)

    def send(self, goal):
        """@return the goal's id"""
        self.client.send_goal(goal)
        return self.client.gh.comm_state_machine.action_goal.goal_id.id

    def drive(self, goal):
        """@return the final state and its text. Listens to the result itself: SimpleActionClient misses one that comes
        before its send_goal() is back."""
        sent = []
        result = self.results.after(lambda: sent.append(self.send(goal)),
                                    holds=lambda message: message.status.goal_id.id == sent[0])[0]
        return result.status.status, result.status.text

    def wait_for_status(self, goal_id, *wanted):
        def found(message):
            return any(one.goal_id.id == goal_id and one.status in wanted for one in message.status_list)
        message = self.status.next(found)
        return next(one for one in message.status_list if one.goal_id.id == goal_id)

    def statuses_of(self, goal_id, count):
        """@return the goal's status in each of the next `count` lists, None where it is not listed"""
        return [next((one.status for one in message.status_list if one.goal_id.id == goal_id), None)
                for message in self.status.next_many(count)]

    def pose_in(self, frame, of="base_footprint"):
        """@return x, y, yaw now"""
        transform = self.tf.lookup_transform(frame, of, rospy.Time(0), rospy.Duration(ros_client.WITHIN_S)).transform
        q = transform.rotation
        return (transform.translation.x, transform.translation.y,
                math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z)))
