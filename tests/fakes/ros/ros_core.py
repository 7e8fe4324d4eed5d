#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A roscore of one's own on loopback, on a port that is free when it starts.

As a module: `with RosCore() as core: ... core.environment ...`.
As a program: prints one line "ROS_MASTER_URI=http://127.0.0.1:PORT/" when the master answers, and ends the roscore when
its standard input closes. With --port a master comes back where one was.
"""

import argparse
import ctypes
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import xmlrpc.client


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def _die_with_parent():
    """Runs in the new process: a test that crashes leaves no master behind. A shell that runs tests in the background
    has SIGINT ignored, and rosmaster would not hear it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    ctypes.CDLL(None).prctl(1, signal.SIGINT)


def _descendants(pid):
    """roscore gives master and rosout sessions of their own, so no group holds them all."""
    parents = {}
    for name in os.listdir("/proc"):
        if name.isdigit():
            try:
                with open(f"/proc/{name}/stat", encoding="utf-8", errors="replace") as stat:
                    parents[int(name)] = int(stat.read().rsplit(")", 1)[1].split()[1])
            except OSError:
                pass
    found = [pid]
    for one in found:
        found += [child for child, parent in parents.items() if parent == one]
    return found


class RosCore:
    def __init__(self, port=None, start_within_s=30.0):
        self.port = port or free_port()
        self.uri = f"http://127.0.0.1:{self.port}/"
        self._start_within_s = start_within_s
        self._home = tempfile.TemporaryDirectory(prefix="fodscope-ros-")
        self._process = None
        #: What a node needs to find this master, and to leave no trace in the user's home.
        self.environment = {
            **os.environ,
            "ROS_MASTER_URI": self.uri,
            "ROS_IP": "127.0.0.1",
            "ROS_HOME": self._home.name,
            "ROS_LOG_DIR": os.path.join(self._home.name, "log"),
        }
        self.environment.pop("ROS_HOSTNAME", None)

    def __enter__(self):
        self.start()
        return self

    def __exit__(self, *_):
        self.close()

    def start(self):
        self._process = subprocess.Popen(
            ["/usr/bin/python3", "/usr/bin/roscore", "-p", str(self.port)],
            env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            start_new_session=True, preexec_fn=_die_with_parent)
        deadline = time.monotonic() + self._start_within_s
        while not self.answers():
            if self._process.poll() is not None:
                raise RuntimeError(f"roscore on port {self.port} ended with {self._process.returncode}")
            if time.monotonic() > deadline:
                self.stop()
                raise RuntimeError(f"roscore on port {self.port} did not answer within {self._start_within_s:g} s")
            time.sleep(0.05)

    def answers(self):
        """A roscore is there when it has a run_id: its master answers earlier."""
        try:
            code, _, found = xmlrpc.client.ServerProxy(self.uri).hasParam("/fodscope_tests", "/run_id")
            return code == 1 and found
        except OSError:
            return False

    def kill(self):
        """Ends it as a crash or a power cut does: nobody is told."""
        if self._process is None:
            return
        for pid in _descendants(self._process.pid):
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self._process.wait()
        self._process = None

    def stop(self):
        if self._process is None:
            return
        self._process.send_signal(signal.SIGINT)
        try:
            self._process.wait(timeout=15)
            self._process = None
        except subprocess.TimeoutExpired:
            self.kill()

    def close(self):
        self.stop()
        self._home.cleanup()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--port", type=int, help="instead of a free one")
    with RosCore(parser.parse_args().port) as core:
        print(f"ROS_MASTER_URI={core.uri}", flush=True)
        sys.stdin.buffer.read()


if __name__ == "__main__":
    main()
