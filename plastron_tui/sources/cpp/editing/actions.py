"""Serving actions from files that exist, and sending goals to them.

Sources: `rclcpp_action/server.hpp` and `client.hpp` of Jazzy; `actionlib/server/
simple_action_server.h` and `client/simple_action_client.h` of Noetic.
"""

from __future__ import annotations

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import ActionClient, ActionServer
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import Interface, InterfaceKind
from plastron_tui.ros.names import name_as_written

from .. import literals
from ..scopes import CppFile
from .adding import Addition
from .calling import waits
from .computing import computing_for
from .functions import write_function
from .handles import handle_for, is_constant
from .hearing import bind_manner, existing
from .interfaces import refuse
from .logging import log_line
from .manner import method_naming
from .members import hold, is_local, type_of
from .timers import capture, node_captures, period_of, run_at, timer_name

K = EndpointKind

_SOON = 10.0


def _class(added: Addition, interface: Interface) -> str:
    class_ = added.interfaces.class_of(interface.name, InterfaceKind.ACTION)
    return class_ if added.is_ros2 else class_.removesuffix("Action")


def serve_action(added: Addition, server: ActionServer, interface: Interface) -> None:
    """Let a node serve an action, with a function of its own that works on the goals."""
    class_ = _class(added, interface)
    wanted = server.callback
    is_there = wanted is not None and existing(added, wanted) is not None
    name = wanted or added.free(method_naming(added.analysis, "execute").name(added.topic))
    added.taken.add(name)
    if added.is_ros2:
        _serve_in_ros2(added, class_, name, is_there)
        added.expect(K.ACTION_SERVER, server.name, interface.name, "")
    else:
        _serve_in_ros1(added, class_, name, is_there)
        added.expect(K.ACTION_SERVER, server.name, interface.name, name)


def _serve_in_ros2(added: Addition, class_: str, name: str, is_there: bool) -> None:
    type_ = type_of(added, K.ACTION_SERVER, class_)
    variable, file = hold(added, K.ACTION_SERVER, type_)
    _include_action(added, file)
    if not is_there:
        handle = f"rclcpp_action::ServerGoalHandle<{class_}>"
        style = added.style(added.place.file)
        body = [
            log_line(added, f"{added.prose}: goal", "to_yaml(*goal_handle->get_goal())"),
            f"auto feedback = std::make_shared<{class_}::Feedback>();",
            f"auto result = std::make_shared<{class_}::Result>();",
            "rclcpp::Rate rate(1.0);",
            *style.block(
                "for (int step = 0; step < 10 && rclcpp::ok(); ++step)",
                [
                    *style.block(
                        "if (goal_handle->is_canceling())",
                        ["goal_handle->canceled(result);", "return;"],
                    ),
                    "goal_handle->publish_feedback(feedback);",
                    "rate.sleep();",
                ],
            ),
            *style.block("if (rclcpp::ok())", ["goal_handle->succeed(result);"]),
        ]
        parameter = f"const std::shared_ptr<{handle}> goal_handle"
        file = write_function(added, name, [parameter], body, _said(added))
        _include_action(added, file)
        added.include(added.place.file, "thread")
    called, taken = f"{name}(goal_handle);", "this" if added.owner is not None else ""
    if not is_there:
        pad = added.style(added.place.file).pad
        handed = f"{{{pad}{name}(goal_handle);{pad}}}"
        both = f"{taken}, goal_handle" if taken else "goal_handle"
        called = f"std::thread([{both}]() {handed}).detach();"
    declared = "auto " if is_local(added) else ""
    text = literals.string(name_as_written(added.endpoint.name, 2))
    pad = added.style(added.place.file).pad
    accepted = f"{{{pad}return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;{pad}}}"
    cancelled = f"{{{pad}return rclcpp_action::CancelResponse::ACCEPT;{pad}}}"
    added.lines += [
        f"{declared}{variable} = rclcpp_action::create_server<{class_}>(",
        f"\v{added.place.node_argument}, {text},",
        f"\v[](const auto &, const auto &) {accepted},",
        f"\v[](const auto &) {cancelled},",
        f"\v[{taken}](const auto & goal_handle) {{",
        f"\v\t{called}",
        "\v});",
    ]


def _serve_in_ros1(added: Addition, class_: str, name: str, is_there: bool) -> None:
    server = f"actionlib::SimpleActionServer<{class_}Action>"
    variable, file = hold(added, K.ACTION_SERVER, f"std::unique_ptr<{server}>")
    where = file or added.place.file
    added.include(where, "actionlib/server/simple_action_server.h")
    if file is not None:
        added.include(file, "memory")
    added.include_types(where)
    # A function of none but itself gets the server that `main` has, as the last parameter.
    there = existing(added, name)
    is_given = is_local(added) and (there is None or len(there.parameters) > 1)
    used = "server" if is_given else variable
    if not is_there:
        style = added.style(added.place.file)
        reference = style.reference
        body = [
            log_line(added, f"{added.prose}: goal", "*goal"),
            f"{class_}Feedback feedback;",
            f"{class_}Result result;",
            "ros::Rate rate(1.0);",
            *style.block(
                "for (int step = 0; step < 10 && ros::ok(); ++step)",
                [
                    *style.block(
                        f"if ({used}->isPreemptRequested())",
                        [f"{used}->setPreempted(result);", "return;"],
                    ),
                    f"{used}->publishFeedback(feedback);",
                    "rate.sleep();",
                ],
            ),
            f"{used}->setSucceeded(result);",
        ]
        parameters = [f"const {class_}GoalConstPtr{reference}goal"]
        if is_given:
            parameters.append(f"{server}{reference.replace('&', '*')}server")
        write_function(added, name, parameters, body, _said(added))
    binder, placeholder = bind_manner(added, 1)
    called = name
    if added.owner is not None:
        called = f"{binder}(&{added.owner.name}::{name}, this, {placeholder}1)"
    elif is_given:
        called = f"{binder}({name}, {placeholder}1, &{variable})"
    is_bound = called != name
    if is_bound and not placeholder.startswith("_") and binder.startswith("boost"):
        added.include(added.place.file, "boost/bind/bind.hpp")
    given = ", ".join((*_named(added), called, "false"))
    if is_local(added):
        added.lines += [f"{server} {variable}({given});", f"{variable}.start();"]
    else:
        added.lines += [f"{variable}.reset(new {server}({given}));", f"{variable}->start();"]


def _said(added: Addition) -> str:
    return f"Works on the goals of {added.prose}."


def _named(added: Addition) -> list[str]:
    """Return what a part of an action of ROS 1 is named by: a handle, unless it is the usual one.

    It takes a handle by reference, which one that is made for it alone cannot be.
    """
    handle, given = handle_for(added.analysis, added.place, added.endpoint.name)
    text = literals.string(given)
    if handle.startswith("ros::NodeHandle("):
        made = handle.removeprefix("ros::NodeHandle").removesuffix(".")
        if made == "()":
            return [text]
        name = added.free("private_nh")
        added.lines.append(f"ros::NodeHandle {name}{made};")
        return [name, text]
    bare = f"*{handle[:-2]}" if handle.endswith("->") else handle.removesuffix(".")
    if bare.endswith(")") or is_constant(added.analysis, added.place, handle):
        # What a function returns may be none that can be referred to.
        name = added.free("action_nh")
        added.lines.append(f"ros::NodeHandle {name}({bare});")
        bare = name
    return [bare, text]


def request_action(added: Addition, client: ActionClient, interface: Interface) -> None:
    """Let a node have the client of an action, and send a goal once somebody serves it."""
    if len(client.goals) > 1:
        message = f"of the goals for `{client.name}` no more than one is written into a loaded file"
        remedy = "send the others by hand, each when the one before is done; "
        remedy += "or let a node of its own send them: `create_node`"
        refuse(codes.EDIT_REFUSED, message, added.span, remedy)
    present = [
        site
        for site in added.sites
        if site.endpoint.kind is K.ACTION_CLIENT and site.endpoint.name == client.name
    ]
    if present:
        line = present[0].endpoint.line
        message = f"the client of `{client.name}` in line {line} may be at work on another goal"
        remedy = "send the goal by hand where that client sends its own"
        refuse(codes.EDIT_REFUSED, message, added.span, remedy)
    class_ = _class(added, interface)
    make = _client_of_ros2 if added.is_ros2 else _client_of_ros1
    variable = make(added, class_)
    added.expect(K.ACTION_CLIENT, client.name, interface.name, "")
    if not client.goals:
        return
    timer = timer_name(added, added.topic)
    computing, conditions = computing_for(added, added.span)
    goal = f"{class_}::Goal" if added.is_ros2 else f"{class_}Goal"
    lines = [f"{goal} goal;"]
    lines += added.interfaces.fill(
        interface, interface.fields, client.goals[0], "goal.", computing, added.span
    )
    is_there = "action_server_is_ready" if added.is_ros2 else "isServerConnected"
    body = waits(added, f"{variable}->{is_there}()", "action")
    body.append(f"{timer}->cancel();" if added.is_ros2 else f"{timer}.stop();")
    send = _send_in_ros2 if added.is_ros2 else _send_in_ros1
    sent = [*lines, *send(added, class_, variable)]
    if conditions:
        sent = added.style(added.place.file).block(f"if ({conditions.text})", sent)
    own = capture(added, variable, is_pointer=added.is_ros2)
    run_at(
        added,
        added.topic,
        "send",
        period_of(added, _SOON),
        [*body, *sent],
        timer=timer,
        captures=(*node_captures(added), own, f"&{timer}"),
    )


def _client_of_ros2(added: Addition, class_: str) -> str:
    variable, file = hold(added, K.ACTION_CLIENT, type_of(added, K.ACTION_CLIENT, class_))
    _include_action(added, file)
    text = literals.string(name_as_written(added.endpoint.name, 2))
    declared = "auto " if is_local(added) else ""
    head = f"{declared}{variable} = rclcpp_action::create_client<{class_}>("
    added.lines.append(f"{head}{added.place.node_argument}, {text});")
    return variable


def _client_of_ros1(added: Addition, class_: str) -> str:
    client = f"actionlib::SimpleActionClient<{class_}Action>"
    type_ = f"std::unique_ptr<{client}>"
    variable, file = hold(added, K.ACTION_CLIENT, type_)
    where = file or added.place.file
    added.include(where, "actionlib/client/simple_action_client.h")
    added.include(where, "memory")
    added.include_types(where)
    made = f"new {client}({', '.join(_named(added))}, true)"
    if is_local(added):
        added.lines.append(f"{type_} {variable}({made});")
    else:
        added.lines.append(f"{variable}.reset({made});")
    return variable


def _send_in_ros2(added: Addition, class_: str, variable: str) -> list[str]:
    taken = "this" if added.owner is not None else ", ".join(node_captures(added))
    feedback = log_line(added, f"{added.prose}: feedback", "to_yaml(*feedback)")
    result = log_line(added, f"{added.prose}: result", "to_yaml(*result.result)")
    rejected = log_line(added, f"{added.prose}: the goal was rejected", "", level="ERROR")
    if added.owner is None and added.place.node not in feedback:
        taken = ""
    style = added.style(added.place.file)
    return [
        f"auto options = rclcpp_action::Client<{class_}>::SendGoalOptions();",
        f"options.goal_response_callback = [{taken}](const auto & goal_handle) {{",
        *(f"\t{each}" for each in style.block("if (!goal_handle)", [rejected])),
        "};",
        f"options.feedback_callback = [{taken}](const auto &, const auto & feedback) {{",
        f"\t{feedback}",
        "};",
        f"options.result_callback = [{taken}](const auto & result) {{",
        f"\t{result}",
        "};",
        f"{variable}->async_send_goal(goal, options);",
    ]


def _send_in_ros1(added: Addition, class_: str, variable: str) -> list[str]:
    taken = "this" if added.owner is not None else ""
    reference = added.style(added.place.file).reference
    done = log_line(added, f"{added.prose}: result", "*result")
    heard = log_line(added, f"{added.prose}: feedback", "*feedback")
    state = log_line(added, f"{added.prose}: state", "state.toString()")
    return [
        f"{variable}->sendGoal(",
        "\tgoal,",
        f"\t[{taken}](const actionlib::SimpleClientGoalState{reference}state, "
        f"const {class_}ResultConstPtr{reference}result) {{",
        f"\t\t{state}",
        *(f"\t\t{each}" for each in added.style(added.place.file).block("if (result)", [done])),
        "\t},",
        f"\tactionlib::SimpleActionClient<{class_}Action>::SimpleActiveCallback(),",
        f"\t[{taken}](const {class_}FeedbackConstPtr{reference}feedback) {{",
        f"\t\t{heard}",
        "\t});",
    ]


def _include_action(added: Addition, file: CppFile | None) -> None:
    where = file or added.place.file
    added.include(where, "rclcpp_action/rclcpp_action.hpp")
    added.interfaces.packages["rclcpp_action"] = None
    added.include_types(where)
