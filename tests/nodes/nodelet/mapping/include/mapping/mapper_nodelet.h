#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/synchronizer.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

namespace mapping
{

/// Keeps both handles.
class HandleNodelet : public nodelet::Nodelet
{
protected:
    void onInit() override
    {
        nh_ = getNodeHandle();
        pnh_ = getPrivateNodeHandle();
    }

    ros::NodeHandle nh_, pnh_;
};

class MapperNodelet : public HandleNodelet
{
    typedef HandleNodelet base_type;
    typedef message_filters::sync_policies::ApproximateTime<sensor_msgs::LaserScan, geometry_msgs::PoseStamped> Policy;
    typedef message_filters::Synchronizer<Policy> Synchronizer;
    typedef message_filters::Subscriber<sensor_msgs::LaserScan> ScanSubscriber;

public:
    void onInit() override;

private:
    void update(const sensor_msgs::LaserScanConstPtr& scan, const geometry_msgs::PoseStampedConstPtr& pose);
    bool getMap(nav_msgs::GetMap::Request& request, nav_msgs::GetMap::Response& response);

    ros::Publisher map_;
    boost::shared_ptr<ScanSubscriber> scan_;
    message_filters::Subscriber<geometry_msgs::PoseStamped> pose_;
    boost::shared_ptr<Synchronizer> sync_;
    ros::ServiceServer get_map_;
    nav_msgs::OccupancyGrid grid_;
};

}
