#include<rclcpp/rclcpp.hpp>
#include<std_msgs/msg/int8.hpp>
using namespace std;using I=std_msgs::msg::Int8;
class N:public rclcpp::Node{public:N():Node("n"){p=create_publisher<I>("p",1);s=create_subscription<I>("s",1,[this](const I&i){p->publish(i);});t=create_wall_timer(chrono::seconds(1),bind(&N::f,this));}
void f(){}rclcpp::Publisher<I>::SharedPtr p;rclcpp::Subscription<I>::SharedPtr s;rclcpp::TimerBase::SharedPtr t;};
int main(int c,char**v){rclcpp::init(c,v);rclcpp::spin(make_shared<N>());}
