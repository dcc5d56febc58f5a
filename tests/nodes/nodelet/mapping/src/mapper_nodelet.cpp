#include "mapping/mapper_nodelet.h"
#include <pluginlib/class_list_macros.hpp>

using namespace mapping;

void MapperNodelet::onInit()
{
    base_type::onInit();
    map_ = nh_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
    scan_.reset(new ScanSubscriber(nh_, "scan", 5));
    pose_.subscribe(nh_, "pose", 5);
    sync_.reset(new Synchronizer(Policy(10), *scan_, pose_));
    sync_->registerCallback(boost::bind(&MapperNodelet::update, this, boost::placeholders::_1, boost::placeholders::_2));
    get_map_ = pnh_.advertiseService("get_map", &MapperNodelet::getMap, this);
}

void MapperNodelet::update(const sensor_msgs::LaserScanConstPtr& scan, const geometry_msgs::PoseStampedConstPtr& pose)
{
    grid_.header = scan->header;
    map_.publish(grid_);
}

bool MapperNodelet::getMap(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response)
{
    response.map = grid_;
    return true;
}

PLUGINLIB_EXPORT_CLASS(mapping::MapperNodelet, nodelet::Nodelet)
