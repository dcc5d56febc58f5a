#include <lidar_filter/lidar_filter_nodelet.h>
#include <pluginlib/class_list_macros.hpp>

LidarFilterNodelet::LidarFilterNodelet() : frame_("lidar")
{
}

void LidarFilterNodelet::onInit()
{
	m_nh = &getNodeHandle();
	m_pnh = &getPrivateNodeHandle();
	m_pnh->getParam("frame", frame_);
	m_sub = m_nh->subscribe<sensor_msgs::PointCloud2>("points", 1, &LidarFilterNodelet::callback, this);
	m_pub = m_nh->advertise<sensor_msgs::PointCloud2>("points_filtered", 1);
	m_info = m_pnh->advertise<std_msgs::UInt32>("count", 1);
}

void LidarFilterNodelet::callback(sensor_msgs::PointCloud2::ConstPtr const &cloud)
{
	std_msgs::UInt32 n;
	n.data = cloud->width * cloud->height;
	m_info.publish(n);
	m_pub.publish(cloud);
}

PLUGINLIB_EXPORT_CLASS(LidarFilterNodelet, nodelet::Nodelet)
