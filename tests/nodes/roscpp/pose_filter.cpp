// Smooths a pose with a first order filter.
#include <string>

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>

namespace {

constexpr double kDefaultGain = 0.2;
constexpr int kQueueSize = 5;

class PoseFilter {
 public:
  PoseFilter(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
      : nh_(nh), private_nh_(private_nh) {
    private_nh_.param<double>("gain", gain_, kDefaultGain);
    private_nh_.param("frame_id", frame_id_, std::string("map"));
    pose_pub_ =
        nh_.advertise<geometry_msgs::PoseStamped>("pose_filtered", kQueueSize);
    pose_sub_ = nh_.subscribe("pose", kQueueSize, &PoseFilter::PoseCallback,
                              this);
  }

 private:
  void PoseCallback(const geometry_msgs::PoseStampedConstPtr& pose) {
    state_.header = pose->header;
    state_.pose.position.x += gain_ * (pose->pose.position.x - state_.pose.position.x);
    pose_pub_.publish(state_);
  }

  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  ros::Publisher pose_pub_;
  ros::Subscriber pose_sub_;
  geometry_msgs::PoseStamped state_;
  std::string frame_id_;
  double gain_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "pose_filter");
  PoseFilter filter(ros::NodeHandle(), ros::NodeHandle("~"));
  ros::spin();
  return 0;
}
