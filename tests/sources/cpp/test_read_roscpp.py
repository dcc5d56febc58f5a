"""What creates an endpoint in roscpp and its friends."""

from __future__ import annotations

import pytest
from reading import ROS1, endpoints, in_main, read

from plastron_tui.model.endpoint_details import TimerDetails

STRING = "std_msgs/String"

CALLS = [
    ('nh.advertise<std_msgs::String>("a", 1);', [f"publisher a {STRING}"]),
    ('nh.subscribe("a", 1, cb);', [f"subscription a {STRING} cb"]),
    ('nh.subscribe<std_msgs::String>("a", 1, [](auto m) {});', [f"subscription a {STRING}"]),
    ('nh.subscribe("a", 1, &C::by_value, &c);', [f"subscription a {STRING} by_value"]),
    ('nh.subscribe("a", 1, boost::bind(&C::event, &c, _1));', [f"subscription a {STRING} event"]),
    (
        'nh.subscribe("a", 1, boost::function<void(const std_msgs::StringConstPtr&)>(f));',
        [f"subscription a {STRING} f"],
    ),
    ('nh.subscribe("a", 1, any<std_msgs::String>);', [f"subscription a {STRING} any"]),
    ('nh.subscribe("a", 1, &H<std_msgs::String>::hold, &h);', [f"subscription a {STRING} hold"]),
    (
        'nh.subscribe("a", 1, &H<int>::both<std_msgs::String>, &h);',
        [f"subscription a {STRING} both"],
    ),
    ('nh.advertiseService("a", serve);', ["service a std_srvs/Empty serve"]),
    ('nh.serviceClient<std_srvs::Empty>("a");', ["client a std_srvs/Empty"]),
    ("nh.createTimer(ros::Duration(1), tick);", ["timer tick"]),
    ('nh.param("a", x, 1);', ["parameter a"]),
    ('ros::param::get("~a", x);', ["parameter ~/a"]),
    ('ros::param::get("~/a", x);', ["parameter ~/a"]),
    ('std_srvs::Empty s; ros::service::call("a", s);', ["client a std_srvs/Empty"]),
    (
        'ros::topic::waitForMessage<std_msgs::String>("a", nh);',
        [f"subscription a {STRING}"],
    ),
    (
        'actionlib::SimpleActionClient<a_msgs::FooAction> c("a", true);',
        ["action client a a_msgs/Foo"],
    ),
    (
        'message_filters::Subscriber<std_msgs::String> s(nh, "a", 1);',
        [f"subscription a {STRING}"],
    ),
    (
        'message_filters::Subscriber<std_msgs::String> s; s.subscribe(nh, "a", 1);',
        [f"subscription a {STRING}"],
    ),
    (
        'realtime_tools::RealtimePublisher<std_msgs::String> p(nh, "a", 1);',
        [f"publisher a {STRING}"],
    ),
    (
        'realtime_tools::RealtimePublisher<std_msgs::String> p; p.init(nh, "a", 1);',
        [f"publisher a {STRING}"],
    ),
    (
        "using P = realtime_tools::RealtimePublisher<std_msgs::String>;"
        ' boost::scoped_ptr<P> p; p.reset(new P(nh, "a", 1));',
        [f"publisher a {STRING}"],
    ),
    ('Device d; d.init(nh, "a", 1);', []),
    (
        'image_transport::ImageTransport it(nh); it.advertiseCamera("b/image", 1);',
        ["publisher b/image sensor_msgs/Image", "publisher b/camera_info sensor_msgs/CameraInfo"],
    ),
    (
        'auto o = ros::AdvertiseOptions::create<std_msgs::String>("a", 1, c, c, {}, 0);'
        " nh.advertise(o);",
        [f"publisher a {STRING}"],
    ),
    ('nh.advertise<a::SoundRequest>("a", 1);', ["publisher a a/SoundRequest"]),
    ('nh.subscribe("a", 1, request);', ["subscription a a/SoundRequest request"]),
    (
        'nh.advertiseService<C, a::FooRequest, a::FooResponse>("a", &C::foo, &c);',
        ["service a a/Foo foo"],
    ),
    ('ros::NodeHandlePtr p(new ros::NodeHandle("n")); p->getParam("a", x);', ["parameter n/a"]),
    (
        "tf2_ros::TransformBroadcaster b;",
        ["publisher /tf tf2_msgs/TFMessage"],
    ),
]

HEAD = """
void cb(const std_msgs::String::ConstPtr& m);
void request(const a::SoundRequestConstPtr& m);
bool serve(std_srvs::Empty::Request& request, std_srvs::Empty::Response& response);
template <class M> void any(const boost::shared_ptr<M const>& m);
template <class M> struct H {
  void hold(const typename M::ConstPtr& m);
  template <class N> void both(const N& m);
};
struct C {
  void by_value(std_msgs::String m);
  void event(const ros::MessageEvent<std_msgs::String const>& m);
} c;
"""


@pytest.mark.parametrize(("body", "expected"), CALLS)
def test_a_call_creates(body: str, expected: list[str]) -> None:
    assert in_main(body, HEAD) == expected


HANDLES = [
    ('ros::NodeHandle h("~");', "~/a"),
    ('ros::NodeHandle h("n");', "n/a"),
    ('ros::NodeHandle h(nh, "n");', "n/a"),
    ('ros::NodeHandle p("~"), h(p, "n");', "~/n/a"),
    ('ros::NodeHandle h = ros::NodeHandle("/n");', "/n/a"),
    ('auto h = std::make_shared<ros::NodeHandle>("~");', "~/a"),
    ('ros::NodeHandle* h = new ros::NodeHandle("~");', "~/a"),
    ('std::unique_ptr<ros::NodeHandle> h; h.reset(new ros::NodeHandle("n"));', "n/a"),
    ("auto& h = nh;", "a"),
    ("ros::NodeHandle h(unknown());", None),
]


@pytest.mark.parametrize(("made", "name"), HANDLES)
def test_a_name_is_in_the_namespace_of_its_handle(made: str, name: str | None) -> None:
    text = (
        f'{ROS1}int main() {{ ros::NodeHandle nh; {made} h->advertise<std_msgs::String>("a", 1); }}'
    )
    assert [each.name for each in read(text).endpoints] == [name]


@pytest.mark.parametrize(
    "body",
    [
        'server.advertise("a", 1);',
        'bus->subscribe("a", 1, cb);',
        'struct Bus { void subscribe(const char*, int); } bus; bus.subscribe("a", 1);',
        '// nh.advertise<std_msgs::String>("a", 1);',
        'log("nh.advertise<std_msgs::String>(1)");',
        '\n#if 0\nnh.advertise<std_msgs::String>("a", 1);\n#endif\n',
        'settings.getParam("a", x);',
        "struct A { actionlib::SimpleActionServer<a::B>* as_; A() : as_(nullptr) {} };",
    ],
)
def test_what_only_looks_like_one_is_none(body: str) -> None:
    assert in_main(body) == []


NODELET = """#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.h>
#include <std_msgs/String.h>
namespace a {
class B : public nodelet::Nodelet {
  void onInit() override {
    pub_ = getPrivateNodeHandle().advertise<std_msgs::String>("c", 1);
    ros::NodeHandle& nh = getMTNodeHandle();
    sub_ = nh.subscribe("d", 1, &B::cb, this);
  }
  void cb(const std_msgs::StringConstPtr& m) {}
  ros::Publisher pub_;
  ros::Subscriber sub_;
};
}
PLUGINLIB_EXPORT_CLASS(a::B, nodelet::Nodelet)
"""


def test_a_nodelet_is_a_node_without_a_name() -> None:
    source = read(NODELET)
    assert source.library == "nodelet"
    assert [(node.name, node.class_name) for node in source.nodes] == [(None, "B")]
    assert endpoints(NODELET) == [f"publisher ~/c {STRING}", f"subscription d {STRING} cb"]


def test_two_names_of_one_node_are_none() -> None:
    inits = [f'void f{name}() {{ ros::init(c, v, "{name}"); }}' for name in "ab"]
    assert [node.name for node in read(ROS1 + inits[0]).nodes] == ["a"]
    assert [node.name for node in read(ROS1 + "".join(inits)).nodes] == [None]


SERVING = [
    (
        "/// Publish to a; called at its rate.",
        "publish_a",
        "message.data = 1; pub.publish(message);",
        True,
    ),
    ("", "publish_a", "std_msgs::String message; message.data = 1; pub.publish(message);", True),
    ("", "publishA", "pub.publish(message); count();", False),
    (
        "/// Publish to a; called at its rate.",
        "publish_a",
        "pub.publish(message); drive(1);",
        False,
    ),
    ("/// Warn as long as nobody listens to a.", "await_a", 'ROS_WARN("a");', True),
    ("/// Give the timers whose rates have changed their new ones.", "follow_rates", "", True),
    ("/// Do what is to be done.", "repeat_it", "pub.publish(last);", True),
    ("/// Publish to a.", "tick", "pub.publish(message);", False),
]


@pytest.mark.parametrize(("description", "name", "body", "serves"), SERVING)
def test_a_timer_may_serve_another_endpoint(
    description: str, name: str, body: str, serves: bool
) -> None:
    source = read(
        f"{ROS1}ros::Publisher pub;\n{description}\n"
        f"void {name}(const ros::TimerEvent&) {{ {body} }}\n"
        f"int main() {{ ros::NodeHandle nh; nh.createTimer(ros::Duration(1), {name}); }}"
    )
    (details,) = (each.details for each in source.endpoints)
    assert isinstance(details, TimerDetails)
    assert details.serves is serves
