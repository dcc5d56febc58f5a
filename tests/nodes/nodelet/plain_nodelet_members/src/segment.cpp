#include <pluginlib/class_list_macros.hpp>
#include "plain_nodelet_members/segment.h"

//////////////////////////////////////////////////////////////////////////////////////////////
void
cloud::Segment::onInit ()
{
  // Call the super onInit ()
  CloudNodelet::onInit ();

  // ---[ Mandatory parameters
  if (!pnh_->getParam ("model_type", model_type_))
  {
    NODELET_ERROR ("[%s::onInit] Need a 'model_type' parameter to be set before continuing!", getName ().c_str ());
    return;
  }
  pnh_->getParam ("threshold", threshold_);

  pub_indices_ = pnh_->advertise<std_msgs::Int32MultiArray> ("inliers", max_queue_size_);
  pub_model_   = pnh_->advertise<std_msgs::Float32MultiArray> ("model", max_queue_size_);

  if (use_indices_)
  {
    // Subscribe to the input using a filter
    sub_input_filter_.subscribe (*pnh_, "input", max_queue_size_);
    sub_indices_filter_.subscribe (*pnh_, "indices", max_queue_size_);
    sync_ = boost::make_shared<message_filters::TimeSynchronizer<sensor_msgs::PointCloud2, geometry_msgs::PoseArray> > (sub_input_filter_, sub_indices_filter_, max_queue_size_);
  }
  else
    // Subscribe in an old fashion to input only (no filters)
    sub_input_ = pnh_->subscribe<sensor_msgs::PointCloud2> ("input", max_queue_size_, bind (&Segment::input_callback, this, boost::placeholders::_1));
}

void
cloud::Segment::input_callback (const sensor_msgs::PointCloud2ConstPtr &cloud)
{
  pub_model_.publish (boost::make_shared<std_msgs::Float32MultiArray> ());
}

typedef cloud::Segment Segment;
PLUGINLIB_EXPORT_CLASS(Segment, nodelet::Nodelet);
