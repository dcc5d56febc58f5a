#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <example_interfaces/action/fibonacci.hpp>

using Fib = example_interfaces::action::Fibonacci;

class FibonacciClient : public rclcpp::Node {
public:
    FibonacciClient() : Node("fibonacci_client"), client_(rclcpp_action::create_client<Fib>(this, "fibonacci")) {
        start_ = create_wall_timer(std::chrono::milliseconds(500), std::bind(&FibonacciClient::send, this));
    }

private:
    void send() {
        start_->cancel();
        if (!client_->wait_for_action_server(std::chrono::seconds(10)))
            return;
        auto options = rclcpp_action::Client<Fib>::SendGoalOptions();
        options.feedback_callback = std::bind(&FibonacciClient::feedback, this, std::placeholders::_1, std::placeholders::_2);
        options.result_callback = std::bind(&FibonacciClient::result, this, std::placeholders::_1);
        client_->async_send_goal(Fib::Goal(), options);
    }
    void feedback(rclcpp_action::ClientGoalHandle<Fib>::SharedPtr, std::shared_ptr<const Fib::Feedback>) {}
    void result(const rclcpp_action::ClientGoalHandle<Fib>::WrappedResult&) { rclcpp::shutdown(); }

    rclcpp_action::Client<Fib>::SharedPtr client_;
    rclcpp::TimerBase::SharedPtr start_;
};

int main(int argc, char** argv) {
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<FibonacciClient>());
}
