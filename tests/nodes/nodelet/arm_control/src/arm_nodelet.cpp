#include "arm_control/arm_nodelet.hpp"

#include <pluginlib/class_list_macros.hpp>

namespace arm_control
{
void ArmNodelet::onInit()
{
  joints_ = getNodeHandle().subscribe<JointState>(
    "joint_states", 1, std::bind(&ArmNodelet::joints, this, std::placeholders::_1));
  server_ = std::make_shared<MoveServer>(
    getPrivateNodeHandle(), "move", std::bind(&ArmNodelet::move, this, std::placeholders::_1), false);
  client_ = std::make_shared<GripClient>("grip", true);
  command_ = getNodeHandle().advertise<JointState>("joint_commands", 1);
  server_->start();
}

void ArmNodelet::joints(const JointState::ConstPtr & state) {command_.publish(state);}
void ArmNodelet::move(const actionlib::TestGoalConstPtr &) {server_->setSucceeded();}
}  // namespace arm_control

PLUGINLIB_EXPORT_CLASS(arm_control::ArmNodelet, nodelet::Nodelet)
