import time

import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node

from example_interfaces.action import Fibonacci


class FibonacciServer(Node):

    def __init__(self):
        super().__init__('fibonacci_action_server')
        self._goal_handle = None
        self._action_server = ActionServer(
            self,
            Fibonacci,
            'fibonacci',
            execute_callback=self.execute,
            goal_callback=self.on_goal,
            handle_accepted_callback=self.accepted,
            cancel_callback=self.cancel,
            callback_group=ReentrantCallbackGroup())

    def destroy(self):
        self._action_server.destroy()
        super().destroy_node()

    def on_goal(self, goal_request):
        return GoalResponse.ACCEPT

    def accepted(self, goal_handle):
        goal_handle.execute()

    def cancel(self, goal):
        return CancelResponse.ACCEPT

    async def execute(self, goal_handle):
        feedback = Fibonacci.Feedback()
        feedback.sequence = [0, 1]
        for i in range(1, goal_handle.request.order):
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                return Fibonacci.Result()
            feedback.sequence.append(feedback.sequence[i] + feedback.sequence[i - 1])
            goal_handle.publish_feedback(feedback)
            time.sleep(1)
        goal_handle.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(FibonacciServer(), executor=MultiThreadedExecutor())
