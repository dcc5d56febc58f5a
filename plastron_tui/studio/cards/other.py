"""What is said about messages, parameters, packages, launch files, libraries and statements."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from plastron_tui.language import Slot
from plastron_tui.language.declaration import Declaration, Element
from plastron_tui.model.values import MessageValue

from ..editor.card import CardRow
from ..panels.endpoint_text import endpoint_text
from .known import Known

if TYPE_CHECKING:
    from plastron_tui.model.kinds import Parameter
    from plastron_tui.model.kinds.publisher import Message
    from plastron_tui.model.launches import Launch
    from plastron_tui.model.libraries import ClientLibrary
    from plastron_tui.model.packages import Package


def message_rows(message: Message, known: Known) -> Iterator[CardRow]:
    """Yield the type of a message, its values, and who sends it where."""
    yield CardRow("type", str(message.value.type))
    yield from (CardRow(name, value) for name, value in _values(message.value))
    from plastron_tui.model.kinds import Publisher

    label = "sent by"
    for node in known.workspace.nodes.values():
        for topic, publisher in node.of(Publisher).items():
            sent = (each.message.variable for each in publisher.publications)
            if message.variable in sent:
                yield CardRow(label, f"{node.name} to {topic}")
                label = ""
    if label:
        yield CardRow("nobody sends it", is_warning=True)


def _values(value: MessageValue, before: str = "") -> Iterator[tuple[str, str]]:
    for name, inner in value.fields.items():
        if isinstance(inner, MessageValue):
            yield from _values(inner, f"{before}{name}.")
        else:
            yield before + name, f'"{inner}"' if isinstance(inner, str) else str(inner)


def parameter_rows(parameter: Parameter, owner: str) -> Iterator[CardRow]:
    """Yield what a parameter of a node holds."""
    yield CardRow("node", owner)
    yield CardRow("value", endpoint_text(parameter, is_guess=False))


def package_rows(package: Package) -> Iterator[CardRow]:
    """Yield what a package is and has in it."""
    if package.variable != package.name:
        yield CardRow("in the program", package.variable)
    if package.source is not None:
        yield CardRow("loaded from", package.source.folder.name)
    if package.description:
        yield CardRow(package.description)
    for label, text in (("license", package.license), ("maintainer", package.maintainer)):
        if text:
            yield CardRow(label, text)
    for variable, held in package.contents.items():
        yield CardRow("contains", variable, "" if held.name == variable else held.name)


def launch_rows(launch: Launch) -> Iterator[CardRow]:
    """Yield what a launch file starts and asks for."""
    if launch.source is not None:
        yield CardRow("loaded from", launch.source.path.name)
    for start in launch.starts.values():
        where = "" if start.node is not None else f"{start.package}/{start.executable}"
        yield CardRow("starts", start.full_name, where)
    for name in launch.includes:
        yield CardRow("includes", name)
    for argument in launch.arguments.values():
        default = "has to be given" if argument.default is None else f"{argument.default}"
        yield CardRow("argument", argument.name, default)


def library_rows(library: ClientLibrary) -> Iterator[CardRow]:
    """Yield what a client library is for."""
    yield CardRow("language", library.language)
    yield CardRow("ROS", str(library.ros_version))
    if library.purpose:
        yield CardRow(library.purpose)


def statement_rows(declaration: Declaration, element: Element | None) -> Iterator[CardRow]:
    """Yield what a statement does, how it is written, and an example."""
    yield CardRow(declaration.summary)
    if declaration.about:
        yield CardRow(declaration.about)
    yield CardRow("written", declaration.usage)
    if isinstance(element, Slot):
        yield CardRow(element.placeholder, element.help)
    yield CardRow("example", declaration.example)
