#ifndef CLOUD_NODELET_H_
#define CLOUD_NODELET_H_

#include <boost/bind/bind.hpp>
#include <boost/make_shared.hpp>
#include <message_filters/subscriber.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

namespace cloud
{
  class CloudNodelet : public nodelet::Nodelet
  {
    public:
      CloudNodelet () : use_indices_ (false), max_queue_size_ (3) {};

    protected:
      boost::shared_ptr<ros::NodeHandle> pnh_;
      bool use_indices_;
      message_filters::Subscriber<sensor_msgs::PointCloud2> sub_input_filter_;
      int max_queue_size_;

      virtual void onInit ()
      {
        pnh_.reset (new ros::NodeHandle (getMTPrivateNodeHandle ()));
        pnh_->getParam ("max_queue_size", max_queue_size_);
        pnh_->getParam ("use_indices", use_indices_);
      }
  };
}

#endif
