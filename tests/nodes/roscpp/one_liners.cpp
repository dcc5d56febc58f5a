#include <ros/ros.h>
#include <std_msgs/Char.h>
#include <std_msgs/Byte.h>
using namespace ros;using namespace std;
struct N{NodeHandle n;Publisher p;Subscriber s;Timer t;
N():p(n.advertise<std_msgs::Char>("c",1)),s(n.subscribe("b",1,&N::f,this)){t=n.createTimer(Duration(.5),&N::g,this);}
void f(const std_msgs::Byte&m){p.publish(std_msgs::Char());}void g(const TimerEvent&e){}};
int main(int c,char**v){init(c,v,"one");N n;spin();return 0;}
