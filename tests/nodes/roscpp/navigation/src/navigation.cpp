#include <navigation/navigation.h>

namespace navigation {

  Navigation::Navigation() :
    as_(NULL),
    running_(false) {
    as_ = new NavigationServer(ros::NodeHandle(), "navigation", boost::bind(&Navigation::executeCb, this, _1), false);

    ros::NodeHandle private_nh("~");
    ros::NodeHandle nh;

    //get some parameters that will be global to the node
    private_nh.param("base_frame", base_frame_, std::string("base_link"));
    private_nh.param("frequency", frequency_, 0.0);

    //for commanding the base
    vel_pub_ = nh.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    current_goal_pub_ = private_nh.advertise<geometry_msgs::PoseStamped>("current_goal", 0 );

    ros::NodeHandle action_nh("navigation");
    action_goal_pub_ = action_nh.advertise<actionlib::TestActionGoal>("goal", 1);

    //like nav_view and rviz do
    ros::NodeHandle simple_nh("navigation_simple");
    goal_sub_ = simple_nh.subscribe<geometry_msgs::PoseStamped>("goal", 1, boost::bind(&Navigation::goalCB, this, _1));

    scan_filter_sub_ = new message_filters::Subscriber<sensor_msgs::LaserScan>(nh, "scan", 5);
    scan_filter_sub_->registerCallback(boost::bind(&Navigation::scanCb, this, _1));

    make_plan_srv_ = private_nh.advertiseService("make_plan", &Navigation::planService, this);
    as_->start();
  }

  Navigation::~Navigation() {
    delete scan_filter_sub_;
    delete as_;
  }

  void Navigation::goalCB(const geometry_msgs::PoseStamped::ConstPtr& goal) {
    actionlib::TestActionGoal action_goal;
    action_goal.header.stamp = goal->header.stamp;
    action_goal_pub_.publish(action_goal);
  }

  bool Navigation::planService(nav_msgs::GetPlan::Request &req, nav_msgs::GetPlan::Response &resp) {
    resp.plan.poses.push_back(req.start);
    return true;
  }

  void Navigation::executeCb(const actionlib::TestGoalConstPtr&) { as_->setSucceeded(); }

  void Navigation::scanCb(const sensor_msgs::LaserScan::ConstPtr&) {}
}

int main(int argc, char** argv){
  ros::init(argc, argv, "navigation");
  navigation::Navigation navigation;
  ros::spin();
  return(0);
}
