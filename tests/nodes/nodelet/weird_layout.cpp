#   include <nodelet/nodelet.h>
#   include <ros/ros.h>
#   include <pluginlib/class_list_macros.hpp>
#   include <std_msgs/ColorRGBA.h>

class W
    : public
      nodelet :: Nodelet
{
    ros :: Publisher   pub ;
    ros :: Subscriber  sub ;

    void
    onInit ( )
    {
        pub =
            getNodeHandle ( )
                . advertise
                < std_msgs :: ColorRGBA >
                ( "colour" ,
                  1 ) ;
        sub = getNodeHandle().
            subscribe( "wish"
                     , 1
                     , & W :: wish
                     , this
                     ) ;
    }

    void
    wish ( std_msgs :: ColorRGBA :: ConstPtr const & c )
    {
        pub . publish ( c ) ;
    }
} ;

PLUGINLIB_EXPORT_CLASS ( W , nodelet :: Nodelet )
