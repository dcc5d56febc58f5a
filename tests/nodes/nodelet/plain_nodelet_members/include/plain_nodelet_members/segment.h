#ifndef CLOUD_SEGMENT_H_
#define CLOUD_SEGMENT_H_

#include <geometry_msgs/PoseArray.h>
#include <message_filters/time_synchronizer.h>
#include <std_msgs/Float32MultiArray.h>
#include <std_msgs/Int32MultiArray.h>

#include "plain_nodelet_members/cloud_nodelet.h"

namespace cloud
{
  using boost::bind;

  /** \brief @b Segment finds a model in a cloud. */
  class Segment : public CloudNodelet
  {
    public:
      Segment () : model_type_ (0), threshold_ (0.1) {};

    protected:
      ros::Publisher pub_indices_;
      ros::Publisher pub_model_;
      ros::Subscriber sub_input_;
      message_filters::Subscriber<geometry_msgs::PoseArray> sub_indices_filter_;
      boost::shared_ptr<message_filters::TimeSynchronizer<sensor_msgs::PointCloud2, geometry_msgs::PoseArray> > sync_;

      virtual void onInit ();
      void input_callback (const sensor_msgs::PointCloud2ConstPtr &cloud);

    private:
      int model_type_;
      double threshold_;
  };
}

#endif
