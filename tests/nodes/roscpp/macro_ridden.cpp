#include <ros/ros.h>
#include <std_msgs/Int8.h>

#define Q_OBJECT
#define Q_SLOTS
#define PANEL_EXPORT __attribute__((visibility("default")))
#define PANEL_UNUSED(x) (void)(x)
#define DISALLOW_COPY(C) C(const C&) = delete; void operator=(const C&) = delete

class QThing {};

class PANEL_EXPORT Panel : public QThing
{
    Q_OBJECT

public:
    Panel();
    PANEL_EXPORT void start();

public Q_SLOTS:
    void refresh() {}

private:
    DISALLOW_COPY(Panel);
    void handle(const std_msgs::Int8& m) { PANEL_UNUSED(m); }
    ros::NodeHandle node;
    ros::Publisher clicks;
    ros::Subscriber lights;
};

Panel::Panel()
{
    clicks = node.advertise<std_msgs::Int8>("clicks", 3);
}

PANEL_EXPORT void Panel::start()
{
    lights = node.subscribe("lights", 3, &Panel::handle, this);
}

int main(int argc, char** argv)
{
    ros::init(argc, argv, "panel");
    Panel panel;
    panel.start();
    ros::spin();
}
