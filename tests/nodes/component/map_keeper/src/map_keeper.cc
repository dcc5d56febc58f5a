#include "map_keeper/map_keeper.hh"

MapKeeper::MapKeeper(const rclcpp::NodeOptions& opts)
    : Node("map_keeper", opts),
      poses_(create_publisher<PoseArray>("poses", Latched())),
      add_(create_subscription<Pose>("add", 10, std::bind(&MapKeeper::Add, this, std::placeholders::_1))),
      clear_(create_service<Empty>("clear", std::bind(&MapKeeper::Clear, this, std::placeholders::_1, std::placeholders::_2))) {}

void MapKeeper::Add(const Pose& pose) {
  array_.poses.push_back(pose.pose);
  poses_->publish(array_);
}

void MapKeeper::Clear(Empty::Request::ConstSharedPtr, Empty::Response::SharedPtr) { array_.poses.clear(); }

#include "rclcpp_components/register_node_macro.hpp"
RCLCPP_COMPONENTS_REGISTER_NODE(MapKeeper)
