#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Empty.h>

class ScanRelay {
public:
    ScanRelay() : pnh_("~") {
        std::string cloud;
        pnh_.param<std::string>("scan_topic", scan_topic_, "scan");
        pnh_.param("cloud_topic", cloud, std::string("cloud"));
        const std::string service = pnh_.param<std::string>("service", "clear");
        if (!pnh_.getParam("other", other_)) {
            ROS_ERROR("~other is required");
            return;
        }
        sub_ = nh_.subscribe(scan_topic_, 10, &ScanRelay::callback, this);
        pub_ = nh_.advertise<sensor_msgs::PointCloud2>(cloud, 10);
        pub2_ = nh_.advertise<sensor_msgs::LaserScan>(scan_topic_ + "_filtered", 10);
        pub3_ = nh_.advertise<sensor_msgs::LaserScan>(other_, 10);
        client_ = nh_.serviceClient<std_srvs::Empty>(service);
    }

private:
    void callback(const sensor_msgs::LaserScan::ConstPtr& scan) { pub2_.publish(scan); }

    ros::NodeHandle nh_, pnh_;
    ros::Subscriber sub_;
    ros::Publisher pub_, pub2_, pub3_;
    ros::ServiceClient client_;
    std::string scan_topic_, other_;
};

int main(int argc, char** argv) {
    ros::init(argc, argv, "scan_relay");
    ScanRelay relay;
    ros::spin();
}
