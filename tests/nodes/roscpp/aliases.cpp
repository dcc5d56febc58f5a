#include <ros/ros.h>
#include <nav_msgs/Odometry.h>
#include <geometry_msgs/Twist.h>
#include <geometry_msgs/TwistStamped.h>
#include <std_srvs/SetBool.h>
#include <std_msgs/Bool.h>

typedef nav_msgs::Odometry Odom;
typedef boost::shared_ptr<Odom const> OdomPtr;
using Twist = geometry_msgs::Twist;
using std_msgs::Bool;
namespace gm = geometry_msgs;
using namespace std_srvs;

struct Mux {
    using Switch = SetBool;

    ros::NodeHandle nh;
    ros::Publisher odom, twist, stamped, on;
    ros::Subscriber a, b, c;
    ros::ServiceServer which;
    ros::ServiceClient other;

    Mux() {
        odom = nh.advertise<Odom>("odom", 1);
        twist = nh.advertise<Twist>("twist", 1);
        stamped = nh.advertise<gm::TwistStamped>("twist_stamped", 1);
        on = nh.advertise<Bool>("on", 1, true);
        a = nh.subscribe("odom_a", 1, &Mux::first, this);
        b = nh.subscribe("odom_b", 1, &Mux::second, this);
        c = nh.subscribe("cmd", 1, &Mux::command, this);
        which = nh.advertiseService("which", &Mux::choose, this);
        other = nh.serviceClient<Switch>("other/which");
    }

    void first(const OdomPtr& m) { if (!use_second) odom.publish(m); }
    void second(const Odom::ConstPtr& m) { if (use_second) odom.publish(m); }
    void command(const gm::Twist& m) { twist.publish(m); }
    bool choose(Switch::Request& q, Switch::Response& r) { use_second = q.data; return r.success = true; }

    bool use_second = false;
};

int main(int argc, char** argv) {
    ros::init(argc, argv, "odometry_mux");
    Mux mux;
    ros::spin();
}
