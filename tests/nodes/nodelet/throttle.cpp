#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/PointCloud2.h>

class CThrottle : public nodelet::Nodelet
{
public:
	CThrottle() : m_dMaxRate(0.0)
	{
	}

private:
	virtual void onInit();
	void OnCloud(const sensor_msgs::PointCloud2::ConstPtr & pCloud);

	ros::Publisher  m_pub;
	ros::Subscriber m_sub;
	ros::Time       m_last;
	double          m_dMaxRate;
};

void CThrottle::onInit()
{
	ros::NodeHandle & nh         = getNodeHandle();
	ros::NodeHandle & private_nh = getPrivateNodeHandle();

	private_nh.getParam("max_rate", m_dMaxRate);

	m_pub = nh.advertise<sensor_msgs::PointCloud2>("cloud_out", 10);
	m_sub = nh.subscribe<sensor_msgs::PointCloud2>("cloud_in", 10, &CThrottle::OnCloud, this);
}

void CThrottle::OnCloud(const sensor_msgs::PointCloud2::ConstPtr & pCloud)
{
	if (m_dMaxRate > 0.0 && m_last + ros::Duration(1.0 / m_dMaxRate) > ros::Time::now())
	{
		return;
	}
	m_last = ros::Time::now();
	m_pub.publish(pCloud);
}

PLUGINLIB_EXPORT_CLASS(CThrottle, nodelet::Nodelet)
