#ifndef ARM_CONTROL__ARM_NODELET_HPP_
#define ARM_CONTROL__ARM_NODELET_HPP_

#include <actionlib/TestAction.h>
#include <actionlib/TwoIntsAction.h>
#include <actionlib/client/simple_action_client.h>
#include <actionlib/server/simple_action_server.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <functional>
#include <memory>

namespace arm_control
{
class ArmNodelet : public nodelet::Nodelet
{
public:
  ArmNodelet() = default;

private:
  using JointState = sensor_msgs::JointState;
  using MoveServer = actionlib::SimpleActionServer<actionlib::TestAction>;
  using GripClient = actionlib::SimpleActionClient<actionlib::TwoIntsAction>;

  void onInit() override;
  void joints(const JointState::ConstPtr & state);
  void move(const actionlib::TestGoalConstPtr & goal);

  ros::Subscriber joints_;
  ros::Publisher command_;
  std::shared_ptr<MoveServer> server_;
  std::shared_ptr<GripClient> client_;
};
}  // namespace arm_control

#endif  // ARM_CONTROL__ARM_NODELET_HPP_
