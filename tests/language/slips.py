"""Lines as beginners write them: below each statement the lines that have a fix that writes it."""

from __future__ import annotations

_MENDED = """
create_message go of message_type Twist and input linear.x=0.3, angular.z=0.5
    create_message go of message_type Twist and input linear.x=0.3 angular.z=0.5
    create_message go of message_type Twist and input linear.x=0.3; angular.z=0.5
    create_message go of message_type Twist and input linear.x=0.3 and angular.z=0.5
create_message go of message_type Twist and input linear.x=0.3
    create_message go of type Twist and input linear.x=0.3
    create_message go of message_type Twist with input linear.x=0.3
    create_message go message_type Twist and input linear.x=0.3
    create_message go Twist linear.x=0.3
    create_message go of Twist and input linear.x=0.3
    create_message go of message_type Twist input linear.x=0.3
    create_message go of message_type Twist and linear.x=0.3
    create_message go of message_type Twist linear.x=0.3
    create_message go of message_type Twist and input linear.x: 0.3
    create_message go with message_type Twist and input linear.x=0.3
    create_message go as message_type Twist and input linear.x=0.3
    create_message go of of message_type Twist and input linear.x=0.3
    create_message go of message_type message_type Twist and input linear.x=0.3
    create_message go of message_type Twist and and input linear.x=0.3
    create_message go of message_type Twist and input input linear.x=0.3
    create_message go message_type of Twist and input linear.x=0.3
    create_message go of message_type Twist input and linear.x=0.3
    create_message go of message_type Twist and inputs linear.x=0.3
    create_message go of message_type Twist and values linear.x=0.3
    message go of message_type Twist and input linear.x=0.3
    make_message go of message_type Twist and input linear.x=0.3
    create_msg go of message_type Twist and input linear.x=0.3
    create go of message_type Twist and input linear.x=0.3
create_message go of message_type Point and input 1, 2, 3
    create_message go of message_type Point and input 1 2 3
create_node 'pilot' as pilot
    create_node 'pilot' pilot
    create_node 'pilot' is pilot
    create_node 'pilot' = pilot
    create_node 'pilot' as as pilot
    create_node named 'pilot' as pilot
    create_node create_node 'pilot' as pilot
    node 'pilot' as pilot
    new_node 'pilot' as pilot
    make_node 'pilot' as pilot
create_node 'pilot' as pilot using rclpy
    create_node 'pilot' as pilot with rclpy
    create_node 'pilot' as pilot in rclpy
    create_node 'pilot' as pilot rclpy
    create_node 'pilot' as pilot using using rclpy
load 'a.py' as pilot
    load 'a.py' pilot
    load 'a.py' to pilot
    import 'a.py' as pilot
pilot publish go to '/cmd_vel' of message_type Twist at 20 hz
    pilot publish go to '/cmd_vel' of message_type Twist at 20
pilot publish go to '/cmd_vel' of message_type Twist at 10 hz
    pilot publish go to '/cmd_vel' of message_type Twist at 10 Hz
    pilot publish go to '/cmd_vel' of message_type Twist at 10 hertz
    pilot publish go to '/cmd_vel' of message_type Twist every 0.1
    pilot publish go to '/cmd_vel' of message_type Twist 10 hz
    pilot publish go to '/cmd_vel' of message_type Twist with 10 hz
    pilot publish go to '/cmd_vel' of message_type Twist at rate 10 hz
    pilot publish go to '/cmd_vel' of message_type Twist at at 10 hz
    pilot publish go to '/cmd_vel' of message_type Twist at 10 hz hz
    pilot publish go to '/cmd_vel' of message_type Twist at hz 10
    pilot publish go to '/cmd_vel' of type Twist at 10 hz
    pilot publish go to '/cmd_vel' of Twist at 10 hz
    pilot publish go to '/cmd_vel' Twist at 10 hz
    pilot publish go '/cmd_vel' of message_type Twist at 10 hz
    pilot publish go on '/cmd_vel' of message_type Twist at 10 hz
    pilot publish go at '/cmd_vel' of message_type Twist at 10 hz
    pilot publish go to to '/cmd_vel' of message_type Twist at 10 hz
    pilot publish go to topic '/cmd_vel' of message_type Twist at 10 hz
    pilot publish go of message_type Twist to '/cmd_vel' at 10 hz
    pilot publish go to '/cmd_vel' with message_type Twist at 10 hz
    pilot publish publish go to '/cmd_vel' of message_type Twist at 10 hz
    pilot publishes go to '/cmd_vel' of message_type Twist at 10 hz
    pilot send go to '/cmd_vel' of message_type Twist at 10 hz
    pilot sends go to '/cmd_vel' of message_type Twist at 10 hz
    pilot go to '/cmd_vel' of message_type Twist at 10 hz
    publish pilot go to '/cmd_vel' of message_type Twist at 10 hz
    pilot publish go '/cmd_vel' Twist 10 hz
pilot publish go to '/cmd_vel' of message_type Twist for_each '/scan' when received.x < 1
    pilot publish go to '/cmd_vel' of message_type Twist on '/scan' when received.x < 1
    pilot publish go to '/cmd_vel' of message_type Twist for_each '/scan' where received.x < 1
    pilot publish go to '/cmd_vel' of message_type Twist for '/scan' when received.x < 1
pilot publish go to '/cmd_vel' of message_type Twist for_each '/scan' when received.x = 1
    pilot publish go to '/cmd_vel' of message_type Twist for_each '/scan' when received.x is 1
pilot publish go to '/cmd_vel' of message_type Twist with qos reliable
    pilot publish go to '/cmd_vel' of message_type Twist qos reliable
    pilot publish go to '/cmd_vel' of message_type Twist with reliable
pilot publish go to '/cmd_vel' of message_type Twist with qos reliable, latched
    pilot publish go to '/cmd_vel' of message_type Twist with qos reliable latched
    pilot publish go to '/cmd_vel' of message_type Twist with qos reliable and latched
pilot publish go to '/cmd_vel' of message_type Twist with qos depth 5
    pilot publish go to '/cmd_vel' of message_type Twist with qos depth=5
subscribe base to '/cmd_vel' of message_type Twist
    subscribe base '/cmd_vel' of message_type Twist
    subscribe base on '/cmd_vel' of message_type Twist
    subscribe base from '/cmd_vel' of message_type Twist
    subscribe base to '/cmd_vel' of type Twist
    subscribe base to '/cmd_vel' Twist
    listen base to '/cmd_vel' of message_type Twist
    base to '/cmd_vel' of message_type Twist
    base subscribes to '/cmd_vel' of message_type Twist
    base listens to '/cmd_vel' of message_type Twist
subscribe base to '/cmd_vel' of message_type Twist calling on_cmd
    subscribe base to '/cmd_vel' of message_type Twist call on_cmd
    subscribe base to '/cmd_vel' of message_type Twist calling calling on_cmd
unsubscribe base from '/cmd_vel'
    unsubscribe base to '/cmd_vel'
    unsubscribe base '/cmd_vel'
base stop_publishing to '/cmd_vel'
    base stop_publishing '/cmd_vel'
    base stop_publishing from '/cmd_vel'
adder provides_service 'add' of service_type AddTwoInts
    adder provides_service 'add' service_type AddTwoInts
    adder provides_service 'add' of message_type AddTwoInts
    adder provides_service 'add' of type AddTwoInts
    adder provides 'add' of service_type AddTwoInts
    adder service 'add' of service_type AddTwoInts
    adder offers_service 'add' of service_type AddTwoInts
adder provides_service 'add' of service_type AddTwoInts answering sum=5
    adder provides_service 'add' of service_type AddTwoInts answer sum=5
    adder provides_service 'add' of service_type AddTwoInts answering sum: 5
caller client_requests 'add' of service_type AddTwoInts with input 5, 6
    caller client_requests 'add' of service_type AddTwoInts and input 5, 6
    caller client_requests 'add' of service_type AddTwoInts input 5, 6
    caller client_requests 'add' of service_type AddTwoInts with 5, 6
    caller client_requests 'add' of service_type AddTwoInts with inputs 5, 6
    caller client_requests 'add' of service_type AddTwoInts with input 5 6
    caller requests 'add' of service_type AddTwoInts with input 5, 6
    caller calls 'add' of service_type AddTwoInts with input 5, 6
caller client_requests 'add' of service_type AddTwoInts with input 5, 6 at 2 hz
    caller client_requests 'add' of service_type AddTwoInts with input 5, 6 at 2
driver has_parameter 'speed' of parameter_type float with default 0.3
    driver has_parameter 'speed' of parameter_type float default 0.3
    driver has_parameter 'speed' of parameter_type float with 0.3
    driver has_parameter 'speed' of parameter_type float and default 0.3
    driver has_parameter 'speed' of parameter_type float = 0.3
    driver has_parameter 'speed' of parameter_type float with default = 0.3
    driver has_parameter 'speed' of type float with default 0.3
    driver has_parameter 'speed' float with default 0.3
    driver has_parameter 'speed' of float with default 0.3
    driver has_parameter 'speed' with default 0.3 of parameter_type float
    driver has_param 'speed' of parameter_type float with default 0.3
    driver parameter 'speed' of parameter_type float with default 0.3
driver has_parameter 'speed' of parameter_type float with default 0.3 between 0 and 1
    driver has_parameter 'speed' of parameter_type float with default 0.3 between 0 to 1
    driver has_parameter 'speed' of parameter_type float with default 0.3 from 0 to 1
    driver has_parameter 'speed' of parameter_type float with default 0.3 between 0 1
    driver has_parameter 'speed' of parameter_type float with default 0.3 between 0, 1
driver has_parameter 'speed' of parameter_type float with default 0.3 described_as "x"
    driver has_parameter 'speed' of parameter_type float with default 0.3 description "x"
rover no_longer_has_link 'arm'
    rover has_no_link 'arm'
    rover lacks_link 'arm'
    rover remove_link 'arm'
demo no_longer_contains pilot
    demo dont_contain pilot
bring no_longer_starts 'pilot'
    bring not_starts 'pilot'
blinker repeats blink at 2 hz
    blinker repeats blink every 2 hz
    blinker repeats blink 2 hz
    blinker repeats blink at 2
    blinker repeats blink every 0.5
    blinker repeats blink every 0.5 s
    blinker repeats 'blink' at 2 hz
    blinker repeat blink at 2 hz
    blinker calls blink at 2 hz
counter provides_action 'count' of action_type Fibonacci
    counter provides_action 'count' of type Fibonacci
    counter provides_action 'count' Fibonacci
asker sends_goal to 'count' of action_type Fibonacci with input order=5
    asker sends_goal 'count' of action_type Fibonacci with input order=5
    asker sends_goal to 'count' of action_type Fibonacci and input order=5
    asker sends_goal to 'count' of action_type Fibonacci input order=5
    asker send_goal to 'count' of action_type Fibonacci with input order=5
driver renames topic 'scan' to 'front/scan'
    driver renames topic 'scan' 'front/scan'
    driver renames topic 'scan' as 'front/scan'
    driver rename topic 'scan' to 'front/scan'
generate_node pilot using rclpy
    generate_node pilot with rclpy
    generate_node pilot rclpy
generate_node pilot
    generate_node the pilot
    write_node pilot
create_message_type Wheel with float64 left, float64 right
    create_message_type Wheel float64 left, float64 right
    create_message_type Wheel with float64 left float64 right
    create_message_type Wheel with float64 left; float64 right
    create_message_type Wheel with float64 left and float64 right
create_message_type Wheel with float64 left
    create_message_type Wheel of float64 left
create_service_type Reset with bool hard returning bool done
    create_service_type Reset with bool hard return bool done
    create_service_type Reset bool hard returning bool done
create_action_type Dock with int32 bay returning bool docked reporting float32 left
    create_action_type Dock with int32 bay returning bool docked float32 left
    create_action_type Dock with int32 bay returning bool docked and reporting float32 left
load_type 'msg/A.msg' as A
    load_type 'msg/A.msg' A
Wheel has_field "float64 slip"
    Wheel has_field float64 slip
Wheel has_field "float64 slip" in request
    Wheel has_field "float64 slip" of request
"""

_WITHOUT = """
create 'pilot' as pilot
pilot publish go to '/cmd_vel' of message_type Twist every 0.3
subscribe base to '/cmd_vel' of message_type Twist with on_cmd
subscribe base to '/cmd_vel' of message_type Twist with function on_cmd
stop base publishing to '/cmd_vel'
driver renames 'scan' to 'front/scan'
generate pilot
subscribe base to '/cmd_vel' of message_type Twist on_cmd
adder provides_service to 'add' of service_type AddTwoInts
delete_node 'n'
kill_node pilot
remove_package demo
unload 'a.py' as pilot
create_node 'n' as n unmanaged
create_node 'n' as n not managed
bring excludes 'x/y.launch.py'
drop pilot
drop_robot rover
create_message_type Mark without float64 x
create_message go of message_type Point and input 1 - 2 3
create_message go of message_type Point and input 1 + 2 3
create_message go of message_type Point and input 5-3, 1, 2
create_message go of message_type String and input "a" + "b"
create_message go of message_type Point and no input
adder provides_service 'add' of service_type AddTwoInts answering received.a x 2
generate_node pilot and base
demo contains pilot and base
bring starts pilot and base
pilot publish go to '/cmd_vel' of message_type Twist for 10 seconds
pilot publish go to '/cmd_vel' of message_type Twist until 5 s
pilot publish go to '/cmd_vel' of message_type Twist in 5 seconds
pilot publish go to '/cmd_vel' of message_type Twist at 2 khz
pilot publish go to '/cmd_vel' of message_type Twist at once
pilot publish go to '/cmd_vel' of message_type Twist one time
pilot publish go to '/cmd_vel' of message_type Twist at half hz
pilot publish go to '/cmd_vel' of message_type Twist at 2 hz once
pilot publish go to '/cmd_vel' of message_type Twist not at 2 hz
pilot publish go to '/cmd_vel' of message_type Twist with qos not latched
pilot publish go to '/cmd_vel' of message_type Twist at 2 hz for_each 'scan'
pilot publish go and stay to '/cmd_vel' of message_type Twist
pilot publish '/cmd_vel' to go of message_type Twist
subscribe base to '/cmd_vel' of message_type Twist not calling on_cmd
unsubscribe '/cmd_vel' from base
driver renames topic to 'b' from 'a'
driver renames topic 'b' for 'a'
driver renames topic 'a' <- 'b'
rover has_joint 'j' of joint_type fixed 'arm' on 'base'
rover has_joint 'j' of joint_type fixed to 'arm'
rover has_link 'w' shaped sphere 5 at x=1
"""
"""Lines that several statements may be meant by, or one that cannot be told."""


def _by_slip() -> dict[str, str | None]:
    found: dict[str, str | None] = dict.fromkeys(_WITHOUT.strip().splitlines())
    right = ""
    for line in _MENDED.strip().splitlines():
        if line.startswith(" "):
            found[line.strip()] = right
        else:
            right = line
    return found


SLIPS = _by_slip()
