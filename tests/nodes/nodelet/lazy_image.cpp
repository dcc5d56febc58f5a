#include <boost/thread/mutex.hpp>
#include <image_transport/image_transport.h>
#include <mutex>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

class LazyImage : public nodelet::Nodelet
{
  boost::shared_ptr<image_transport::ImageTransport> it_;
  boost::mutex mutex_;
  image_transport::Publisher pub_;
  image_transport::Subscriber sub_;

  void onInit() override
  {
    it_.reset(new image_transport::ImageTransport(getNodeHandle()));
    image_transport::SubscriberStatusCallback connect = boost::bind(&LazyImage::connectCb, this);
    std::lock_guard<boost::mutex> lock(mutex_);
    pub_ = it_->advertise("image_mono", 1, connect, connect);
  }

  // Handles (un)subscribing when clients (un)subscribe
  void connectCb()
  {
    std::lock_guard<boost::mutex> lock(mutex_);
    if (pub_.getNumSubscribers() == 0)
      sub_.shutdown();
    else if (!sub_)
    {
      image_transport::TransportHints hints("raw", ros::TransportHints(), getPrivateNodeHandle());
      sub_ = it_->subscribe("image_raw", 1, &LazyImage::imageCb, this, hints);
    }
  }

  void imageCb(const sensor_msgs::ImageConstPtr& raw) { pub_.publish(raw); }
};

PLUGINLIB_EXPORT_CLASS(LazyImage, nodelet::Nodelet)
