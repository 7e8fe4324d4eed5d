# SPDX-License-Identifier: MIT
"""What tests over a real roscore share: programs that are ended with the test, and topics that are waited for.

Waiting is for an event, with a deadline, never for time to pass."""

import os
import subprocess
import sys
import threading
import time

SKIPPED = 77
WITHIN_S = 30.0


def skip_without_ros(*programs):
    """Ends the test program as skipped, with a message, where ROS or a program built with it is absent."""
    try:
        import actionlib, cv2, rospy, tf2_ros  # noqa: F401
    except ImportError as problem:
        print(f"skipped: ROS 1 for Python is not installed ({problem}); see packaging/dependencies.txt")
        sys.exit(SKIPPED)
    for program in programs:
        if not program or not os.access(program, os.X_OK):
            print("skipped: ROS 1 was not found when Fodscope was configured; see packaging/dependencies.txt")
            sys.exit(SKIPPED)


def wait_until(condition, within_s=WITHIN_S, what="the condition", every_s=0.02):
    """For what tells nobody when it changes, as the master's tables. @return the condition's value once it is true"""
    deadline = time.monotonic() + within_s
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > deadline:
            raise AssertionError(f"{what} did not come within {within_s:g} s")
        time.sleep(every_s)


class Program:
    """A program under test. It ends with the `with` block; what it wrote is kept for the failure message."""

    def __init__(self, command, environment):
        self.process = subprocess.Popen(command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, text=True)
        self.lines = []
        self._changed = threading.Condition()
        threading.Thread(target=self._read, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def _read(self):
        for line in self.process.stdout:
            with self._changed:
                self.lines.append(line)
                self._changed.notify_all()
        with self._changed:
            self._changed.notify_all()

    def wait_for_line(self, text, within_s=WITHIN_S):
        with self._changed:
            found = self._changed.wait_for(
                lambda: any(text in line for line in self.lines) or self.process.poll() is not None, within_s)
            if not found or not any(text in line for line in self.lines):
                raise AssertionError(f"'{text}' was not said within {within_s:g} s, but:\n" + "".join(self.lines))

    def wait_for_end(self, within_s=WITHIN_S):
        return self.process.wait(within_s)

    def stop(self):
        if self.process.poll() is None:
            self.process.terminate()
        try:
            self.process.wait(WITHIN_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdin.close()


class Topic:
    """A subscription that keeps what came."""

    def __init__(self, name, kind, keep=2000):
        import rospy
        self.name = name
        self.messages = []
        self.count = 0
        self._keep = keep
        self._changed = threading.Condition()
        self._subscriber = rospy.Subscriber(name, kind, self._hear, queue_size=100)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._subscriber.unregister()

    def _hear(self, message):
        with self._changed:
            self.messages.append(message)
            del self.messages[:-self._keep]
            self.count += 1
            self._changed.notify_all()

    def is_connected(self):
        return self._subscriber.get_num_connections() > 0

    def next(self, holds=lambda message: True, within_s=WITHIN_S):
        """@return the first message from now on for which it holds"""
        return self.next_many(1, holds, within_s)[0]

    def next_many(self, count, holds=lambda message: True, within_s=WITHIN_S):
        return self.after(lambda: None, count, holds, within_s)

    def after(self, act, count=1, holds=lambda message: True, within_s=WITHIN_S):
        """@return the first messages for which it holds since just before the act"""
        with self._changed:
            begin = self.count
        act()

        def found():
            fresh = self.messages[len(self.messages) - min(self.count - begin, len(self.messages)):]
            return [message for message in fresh if holds(message)]
        with self._changed:
            if not self._changed.wait_for(lambda: len(found()) >= count, within_s):
                raise AssertionError(f"{self.name}: {self.count - begin} messages within {within_s:g} s, "
                                     f"{len(found())} as wanted")
            return found()[:count]

    def first(self, within_s=WITHIN_S):
        """@return the first message since the subscription"""
        with self._changed:
            if not self._changed.wait_for(lambda: self.messages, within_s):
                raise AssertionError(f"{self.name}: nothing within {within_s:g} s")
            return self.messages[0]
