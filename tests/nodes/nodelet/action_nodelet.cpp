#include <actionlib/TestAction.h>
#include <actionlib/TwoIntsAction.h>
#include <actionlib/client/simple_action_client.h>
#include <actionlib/server/simple_action_server.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>

class ActionNodelet : public nodelet::Nodelet
{
  using Server = actionlib::SimpleActionServer<actionlib::TestAction>;
  using Client = actionlib::SimpleActionClient<actionlib::TwoIntsAction>;

  std::shared_ptr<Server> server_;
  std::unique_ptr<Client> client_;

  void onInit() override
  {
    server_ = std::make_shared<Server>(getNodeHandle(), "run", boost::bind(&ActionNodelet::run, this, boost::placeholders::_1), false);
    client_ = std::make_unique<Client>(getNodeHandle(), "sum", false);
    server_->start();
  }

  void run(const actionlib::TestGoalConstPtr&)
  {
    if (client_->isServerConnected())
      client_->sendGoal(actionlib::TwoIntsGoal(), Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                        boost::bind(&ActionNodelet::feedback, this, boost::placeholders::_1));
    server_->setSucceeded();
  }

  void feedback(const actionlib::TwoIntsFeedbackConstPtr&) {}
};

PLUGINLIB_EXPORT_CLASS(ActionNodelet, nodelet::Nodelet)
