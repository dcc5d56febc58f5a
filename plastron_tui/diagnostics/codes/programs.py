"""Programs that the examples of several codes begin with."""

from __future__ import annotations

TALKER = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
"""
TALKING = f"{TALKER}talker publish greeting to 'chatter' of message_type String\n"
LISTENER = """\
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
"""
ADDER = """\
create_node 'adder' as adder
adder provides_service 'add' of service_type AddTwoInts
"""
CALLER = """\
create_node 'caller' as caller
caller client_requests 'add' of service_type AddTwoInts with input 5, 6
"""

DRIVER = "create_node 'driver' as driver\n"
SPEED = f"{DRIVER}driver has_parameter 'speed' of parameter_type float with default 0.5\n"
COUNTER = (
    "create_node 'counter' as counter\ncounter provides_action 'count' of action_type Fibonacci\n"
)
ASKER = (
    "create_node 'asker' as asker\n"
    "asker sends_goal to 'count' of action_type Fibonacci with input order=5\n"
)
BLINKER = "create_node 'blinker' as blinker\nblinker repeats blink at 2 hz\n"
RELAY = (
    "create_node 'relay' as relay\n"
    "subscribe relay to 'in' of message_type String\n"
    "create_message copy of message_type String and input data=received.data\n"
)
