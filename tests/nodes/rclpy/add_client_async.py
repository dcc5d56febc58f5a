import asyncio
import sys

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.node import Node


class AddClient(Node):

    def __init__(self):
        super().__init__('add_two_ints_client')
        self.cli = self.create_client(AddTwoInts, 'add_two_ints')
        while not self.cli.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('waiting')
        self.req = AddTwoInts.Request()

    async def ask(self, a, b):
        self.req.a, self.req.b = a, b
        other = self.create_client(AddTwoInts, 'add_three_ints')
        await other.call_async(self.req)
        return await self.cli.call_async(self.req)

    async def tick(self):
        await self.ask(1, 2)


def main():
    rclpy.init()
    client = AddClient()
    client.create_timer(1.0, client.tick)
    future = client.ask(int(sys.argv[1]), int(sys.argv[2]))
    asyncio.run(future)


if __name__ == '__main__':
    main()
