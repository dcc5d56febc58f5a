"""Actions that a node provides, and goals that it sends to those of others."""

from __future__ import annotations

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import ActionClient, ActionServer
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources import naming

from .plan import ActionServerPlan, ClientPlan, NodePlan, WorkPlan
from .writing import Writing


def add_action_servers(writing: Writing, plan: NodePlan) -> None:
    """Plan the actions that a node provides."""
    for server in writing.node.of(ActionServer).values():
        type_ = writing.known(server.type, InterfaceKind.ACTION, server.name, server.span)
        name = naming.words(server.name)
        method = server.callback or writing.attributes.new(f"execute_{name}")
        if method in {
            *(each.method for each in plan.action_servers),
            *(each.name for each in writing.methods.values()),
        }:
            message = f"`{method}` cannot work on `{server.name}` and do its other work"
            writing.refuse(codes.INVALID_FUNCTION, message, server.span, "give it another name")
        plan.action_servers.append(
            ActionServerPlan(
                attribute=writing.attributes.new(f"{name}_{writing.serving}"),
                name=writing.name(server),
                label=naming.label(server.name, method),
                type=writing.class_of(type_, InterfaceKind.ACTION),
                method=method,
                feedback=writing.empty(type_, InterfaceKind.ACTION, "Feedback"),
                server=writing.held(f"{name}_server"),
                result=writing.empty(type_, InterfaceKind.ACTION, "Result"),
            )
        )


def add_action_client(writing: Writing, plan: NodePlan, client: ActionClient) -> None:
    """Plan an action that a node has done, with its goals."""
    type_ = writing.known(client.type, InterfaceKind.ACTION, client.name, client.span)
    name = naming.words(client.name)
    attribute = writing.attributes.new(f"{name}_client")
    class_ = writing.class_of(type_, InterfaceKind.ACTION)
    plan.action_clients.append(ClientPlan(attribute, writing.name(client), class_))
    if client.goals:
        plan.works.append(
            WorkPlan(
                writing.attributes.new(f"send_{name}"),
                attribute,
                writing.name(client),
                naming.label(client.name, "the action"),
                tuple(writing.goal(type_, each, client.span) for each in client.goals),
                is_goals=True,
                task=writing.sending(f"{name}_goals", is_repeated=False),
            )
        )
