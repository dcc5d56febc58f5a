#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>
#include <std_msgs/Empty.h>
#include <std_msgs/Bool.h>

// Before boost 1.60 there was PLUGINLIB_DECLARE_CLASS(old, Watchdog, old::Watchdog, nodelet::Nodelet);
namespace old {
  class Watchdog : public nodelet::Nodelet {
    public:
      Watchdog() {};
      ~Watchdog() {};

      virtual void onInit(void) {
        ros::NodeHandle n = getMTNodeHandle();
        alarm = n.advertise<std_msgs::Bool> ("alarm", 1, true);
        feed  = n.subscribe ("feed", 1, &Watchdog::fed, this);
        timer = n.createWallTimer (ros::WallDuration (0.2), &Watchdog::bark, this);
      };

    private:
      void fed (const std_msgs::EmptyConstPtr &) { last = ros::WallTime::now (); };
      void bark (const ros::WallTimerEvent &e) {
        std_msgs::Bool b;
        b.data = e.current_real - last > ros::WallDuration (1);
        alarm.publish (b);
      };
      ros::WallTime last;
      ros::Publisher alarm;
      ros::Subscriber feed;
      ros::WallTimer timer;
  };
};
PLUGINLIB_EXPORT_CLASS (old::Watchdog, nodelet::Nodelet);
