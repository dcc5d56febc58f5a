#include <cinttypes>
#include <ros/ros.h>
#include <std_msgs/UInt64.h>
#include <std_msgs/Int64.h>
#include <std_msgs/Empty.h>

#ifndef EXTRA
#define EXTRA 1
#endif

static void onTicks(const std_msgs::UInt64::ConstPtr &msg)
{
	ROS_INFO("ticks %" PRIu64 " of %" PRId64, msg->data, (int64_t)42);
	printf("%" PRId64 "\n", (int64_t)msg->data);
}

int main(int argc, char *argv[])
{
	ros::init(argc, argv, "branches");
	ros::NodeHandle nh;
	ros::Subscriber ticks = nh.subscribe("ticks", 1, onTicks);
#if EXTRA
	ros::Publisher extra = nh.advertise<std_msgs::Int64>("extra", 1);
#else
	ros::Publisher extra = nh.advertise<std_msgs::UInt64>("extra_unsigned", 1);
#endif
#if 0
	ros::Publisher dead = nh.advertise<std_msgs::Int64>("dead", 1);
#endif
#ifdef NEVER_DEFINED
	ros::Publisher debug = nh.advertise<std_msgs::Empty>("debug", 1);
#endif
	if (argc > 1) {
		ros::Publisher maybe = nh.advertise<std_msgs::Empty>("maybe", 1);
		ros::spin();
	} else
		ros::spin();
	return 0;
}
