#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

#define TOPIC_A "a"
#define NS "/robot"
#define EMPTY std_msgs::msg::Empty

const std::string TOPIC_B = "b";
static constexpr char const * TOPIC_C = "c";
namespace topics { inline const std::string D{"d"}; }
enum { QUEUE = 9 };

class Constants : public rclcpp::Node
{
    static constexpr const char* kE = "e";
    static const std::string F;
    const std::string g_ = "g";
    std::string h_{"h"};
    std::string changed_ = "one";
    rclcpp::Publisher<EMPTY>::SharedPtr p[12];

public:
    Constants() : Node("constants")
    {
        p[0] = create_publisher<EMPTY>(TOPIC_A, QUEUE);
        p[1] = create_publisher<EMPTY>(TOPIC_B, QUEUE);
        p[2] = create_publisher<EMPTY>(TOPIC_C, QUEUE);
        p[3] = create_publisher<EMPTY>(topics::D, QUEUE);
        p[4] = create_publisher<EMPTY>(kE, QUEUE);
        p[5] = create_publisher<EMPTY>(Constants::F, QUEUE);
        p[6] = create_publisher<EMPTY>(g_, QUEUE);
        p[7] = create_publisher<EMPTY>(this->h_, QUEUE);
        p[8] = create_publisher<EMPTY>(NS "/i", QUEUE);
        p[9] = create_publisher<EMPTY>(TOPIC_B + "/" + std::to_string(3), QUEUE);
        p[10] = create_publisher<EMPTY>(changed_, QUEUE);
        p[11] = create_publisher<EMPTY>(std::string(get_name()) + "/x", QUEUE);
    }
    void change() { changed_ = "two"; }
};
const std::string Constants::F = "f";

int main(int argc, char** argv)
{
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<Constants>());
    rclcpp::shutdown();
}
