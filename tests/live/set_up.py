"""Run a node, and say when its main thread has set up all that it is asked to.

A client library registers what is set up at once: what the graph does not know then, is not there.
"""

import runpy
import sys
import threading


def telling(function):
    def tell(*arguments):
        # A timer of rospy sleeps in a thread of its own, and may do so early.
        if threading.current_thread() is threading.main_thread():
            print("all is set up", flush=True)
        return function(*arguments)

    return tell


try:
    import rospy
except ImportError:
    import rclpy

    rclpy.spin = telling(rclpy.spin)
else:
    rospy.spin = telling(rospy.spin)
    rospy.sleep = telling(rospy.sleep)
    rospy.Rate.sleep = telling(rospy.Rate.sleep)

if __name__ == "__main__":
    del sys.argv[0]
    runpy.run_path(sys.argv[0], run_name="__main__")
