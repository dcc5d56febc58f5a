#ifndef _LIDAR_FILTER_NODELET_H_
#define _LIDAR_FILTER_NODELET_H_

#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/UInt32.h>

class LidarFilterNodelet : public nodelet::Nodelet
{
public:
	LidarFilterNodelet();
	virtual ~LidarFilterNodelet() {}
	virtual void onInit();

protected:
	void callback(sensor_msgs::PointCloud2::ConstPtr const &cloud);

private:
	ros::NodeHandle *m_nh;
	ros::NodeHandle *m_pnh;
	ros::Subscriber m_sub;
	ros::Publisher m_pub, m_info;
	std::string frame_;
};

#endif // _LIDAR_FILTER_NODELET_H_
