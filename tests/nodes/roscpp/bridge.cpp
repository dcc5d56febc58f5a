// Talks to a server of another protocol that has the same words.
#include <functional>
#include <map>
#include <memory>
#include <string>

#include <ros/ros.h>
#include <std_msgs/String.h>

namespace mqtt {
struct Client {
  using Callback = std::function<void(const std::string&)>;
  explicit Client(const std::string& url) : url(url) {}
  void subscribe(const std::string& topic, int qos, Callback callback) { callbacks[topic] = callback; (void)qos; }
  void subscribe(const std::string& topic, int qos) { (void)topic; (void)qos; }
  void publish(const std::string& topic, const std::string& payload) { (void)topic; (void)payload; }
  template <class T> T param(const char*, T value) const { return value; }
  bool getParam(const std::string&, std::string&) const { return false; }
  std::string url;
  std::map<std::string, Callback> callbacks;
};
struct Server { template <class Request> void advertiseService(const char*, Request) {} };
struct Timer {};
}

class Bridge {
 public:
  Bridge() : nh("~"), client("tcp://localhost"), remote(std::make_shared<mqtt::Client>("tcp://remote")) {
    client.subscribe("from/mqtt", 1, [this](const std::string& text) { forward(text); });
    remote->subscribe("remote", 1);
    remote->param("keepalive", 60);
    client.getParam("name", name);
    server.advertiseService("mqtt_service", 3);
    get().subscribe("get", 0);
    pub = nh.advertise<std_msgs::String>("from_mqtt", 10);
    sub = nh.subscribe("to_mqtt", 10, &Bridge::send, this);
  }

 private:
  mqtt::Client& get() { return client; }
  void forward(const std::string& text) {
    std_msgs::String s;
    s.data = text;
    pub.publish(s);
  }
  void send(const std_msgs::String::ConstPtr& s) { client.publish("to/mqtt", s->data); }

  ros::NodeHandle nh;
  mqtt::Client client;
  std::shared_ptr<mqtt::Client> remote;
  mqtt::Server server;
  std::string name;
  ros::Publisher pub;
  ros::Subscriber sub;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "bridge");
  Bridge bridge;
  ros::spin();
}
