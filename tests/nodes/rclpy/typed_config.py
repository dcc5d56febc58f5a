from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar, Final, Generic, TypeVar

import rclpy
from geometry_msgs.msg import PoseWithCovarianceStamped as Estimate
from rclpy.node import Node

if TYPE_CHECKING:
    from rclpy.publisher import Publisher
    from rclpy.subscription import Subscription
    from rclpy.timer import Timer

T = TypeVar('T')
POSE: Final = 'pose'


@dataclass(frozen=True)
class Config:
    rate: float = 10.0
    frames: list[str] = field(default_factory=lambda: ['map', 'odom'])


class Localizer(Node, Generic[T]):
    initial: ClassVar[str] = 'initialpose'
    _pub: Publisher
    _sub: Subscription | None = None

    def __init__(self, config: Config | None = None, /, **kwargs: object) -> None:
        super().__init__('localizer', **kwargs)
        self._config: Config = config or Config()
        self._pub: Publisher = self.create_publisher(Estimate, POSE, 10)
        self._sub = self.create_subscription(Estimate, self.initial, self._on_pose, 10)
        self._timer: Timer = self.create_timer(1 / self._config.rate, self._tick)
        self._latest: Estimate | None = None

    def _on_pose(self, msg: Estimate) -> None:
        self._latest = msg

    def _tick(self) -> None:
        if (latest := self._latest) is not None:
            self._pub.publish(latest)


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    match args:
        case None | []:
            node = Localizer()
        case _:
            node = Localizer(Config(rate=1.0))
    rclpy.spin(node)
    return 0
