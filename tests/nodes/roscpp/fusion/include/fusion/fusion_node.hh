#pragma once
#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

class Fusion
{
public:
	Fusion();

private:
	typedef message_filters::Subscriber<sensor_msgs::PointCloud2> CloudSubscriber;
	typedef message_filters::TimeSynchronizer<sensor_msgs::Image, sensor_msgs::PointCloud2> Sync;

	void both(const sensor_msgs::ImageConstPtr& image, const sensor_msgs::PointCloud2ConstPtr& cloud);

	ros::NodeHandle nh_;
	boost::shared_ptr<message_filters::Subscriber<sensor_msgs::Image> > image_;
	boost::shared_ptr<CloudSubscriber> cloud_;
	message_filters::Subscriber<nav_msgs::Odometry> odom_;
	boost::shared_ptr<Sync> sync_;
	ros::Publisher fused_;
};
