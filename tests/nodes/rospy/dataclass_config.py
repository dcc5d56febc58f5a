#!/usr/bin/env python3
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final, Optional

import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped as Estimate
from std_msgs.msg import String

STATUS: Final[str] = 'status'
LATER: str


@dataclass
class Config:
    rate: float = 10.0
    frames: list[str] = field(default_factory=list)

    @classmethod
    def load(cls) -> Config:
        return cls(rate=rospy.get_param('~rate', cls.rate),
                   frames=rospy.get_param('~frames', []))


class Localizer:
    pub: rospy.Publisher
    status_topic: str = STATUS

    def __init__(self, config: Config) -> None:
        self.config: Config = config
        self.latest: Optional[Estimate] = None
        self.pub: rospy.Publisher = rospy.Publisher('pose', Estimate, queue_size=1)
        self.status: rospy.Publisher = rospy.Publisher(
            self.status_topic,  # what people see
            String,
            queue_size=1,
            latch=True,
        )
        self.sub: Optional[rospy.Subscriber] = rospy.Subscriber('initialpose', Estimate, self.on_pose)
        self.timer = rospy.Timer(rospy.Duration.from_sec(1 / config.rate), self.tick)

    def on_pose(self, msg: Estimate) -> None:
        self.latest = msg

    def tick(self, event: rospy.timer.TimerEvent) -> None:
        if self.latest is not None:
            self.pub.publish(self.latest)


def main() -> int:
    rospy.init_node('localizer')
    Localizer(Config.load())
    rospy.spin()
    return 0


if __name__ == '__main__':
    raise SystemExit(main())
