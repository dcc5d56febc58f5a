from __future__ import annotations

_NODE = """\
create_node 'node_{i}' as node{i}
create_message point{i} of message_type Point and input {i},6,7.5
create_message text{i} of message_type String and input "hello {i}"
subscribe node{i} to 'heard{i}' of message_type String
node{i} publish point{i} to 'point{i}' of message_type Point at 5 hz
node{i} publish text{i} to 'text{i}' of message_type String
node{i} provides_service 'add{i}' of service_type AddTwoInts
node{i} client_requests 'switch{i}' of service_type SetBool with input True
unsubscribe node{i} from 'heard{i}'
generate_node node{i}
"""


def program(statements: int) -> bytes:
    """A program of so many statements, ten a node, all kinds but `load` in use."""
    nodes = -(-statements // 10)
    lines = "".join(_NODE.format(i=i) for i in range(nodes)).splitlines()
    return ("\n".join(lines[:statements]) + "\n").encode()


def many_nodes(count: int) -> bytes:
    """A program that generates so many publishers."""
    return "".join(
        f"create_node 'node_{i}' as node{i}\n"
        f'create_message text{i} of message_type String and input "hello {i}"\n'
        f"node{i} publish text{i} to 'text{i}' of message_type String\n"
        f"generate_node node{i}\n"
        for i in range(count)
    ).encode()
