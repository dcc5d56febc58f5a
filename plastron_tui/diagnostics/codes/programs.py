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
