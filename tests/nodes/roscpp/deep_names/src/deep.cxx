#include "deep_names/deep.hxx"

using namespace a::b;

c::Deep::Deep(ros::NodeHandle n)
{
    pub = n.advertise<Message>("deep", 1);
    sub = n.subscribe<Message>("shallow", 1, boost::bind(&c::Deep::handle, this, boost::placeholders::_1));
    client = n.serviceClient<Service>("dive");
}

void c::Deep::handle(const Message::ConstPtr& m)
{
    pub.publish(m);
}
