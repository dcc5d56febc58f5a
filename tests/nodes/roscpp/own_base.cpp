#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_msgs/Float32.h>

class RobotNode {
public:
    RobotNode() : nh_(), priv_("~") {
        status_ = nh_.advertise<std_msgs::String>("status", 10);
    }
    virtual ~RobotNode() {}
    virtual void tick() = 0;

protected:
    void say(const std::string& text) { std_msgs::String s; s.data = text; status_.publish(s); }
    ros::NodeHandle nh_;
    ros::NodeHandle priv_;

private:
    ros::Publisher status_;
};

class Cleaner final : public RobotNode {
public:
    Cleaner() {
        dirt_ = nh_.subscribe("dirt", 1, &Cleaner::onDirt, this);
        power_ = priv_.advertise<std_msgs::Float32>("power", 1);
        priv_.param("limit", limit_, 0.5f);
    }
    void tick() override { say("clean"); }

private:
    void onDirt(const std_msgs::Float32ConstPtr& m) { if (m->data > limit_) power_.publish(*m); }
    float limit_;
    ros::Subscriber dirt_;
    ros::Publisher power_;
};

int main(int argc, char** argv) {
    ros::init(argc, argv, "cleaner");
    Cleaner cleaner;
    ros::Rate rate(1);
    while (ros::ok()) { cleaner.tick(); ros::spinOnce(); rate.sleep(); }
}
