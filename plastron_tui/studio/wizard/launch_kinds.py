"""Launch files: their names, and what they start."""

from __future__ import annotations

from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.model.launches import Launch
from plastron_tui.ros.launch_names import launch_language

from ..folder_files import found_files, path_text
from .ask import Ask, Choice
from .context import free_name
from .kind import OF_THE_LIST, Kind
from .trials import first_that_works

_SUFFIXES = frozenset({".launch", ".xml", ".py", ".yaml", ".yml"})


def _is_launch(name: str) -> bool:
    return launch_language(name) is not None


class LaunchNameKind(Kind):
    """The name of a new launch file."""

    def suggest(self, ask: Ask) -> str:
        """Return the word that most packages have for what starts all."""
        return free_name("bringup", {each.name for each in ask.scene.workspace.launches.values()})

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            return "a launch file needs a name, such as `bringup`"
        if any(each.name == text for each in ask.scene.workspace.launches.values()):
            return f"a launch file is called `{text}` already: choose another name"
        return None


class LaunchKind(Kind):
    """A launch file of the program."""

    def suggest(self, ask: Ask) -> str:
        """Return the last one for which the statement makes sense."""
        names = list(reversed(ask.scene.workspace.launches))
        return first_that_works(ask, names) or next(iter(names), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all, the last one first."""
        launches = ask.scene.workspace.launches
        return [Choice(name, launches[name].name) for name in reversed(launches)]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not ask.scene.workspace.launches:
            return "there is no launch file yet: make one first"
        launches = ask.scene.workspace.launches
        return None if text in launches else f"no such launch file: {OF_THE_LIST}"


class LaunchFileKind(Kind):
    """A launch file that exists."""

    def suggest(self, ask: Ask) -> str:
        """Return the first that is found."""
        return next((each.text for each in self.choices(ask, "")), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those below the program's folder."""
        folder = ask.scene.session.folder
        found = ask.scene.surroundings.once(
            "launches", lambda: found_files(_SUFFIXES, folder, _is_launch)
        )
        return [Choice(path_text(path, folder)) for path in found]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text else "no launch file is beside the program: write the path of one"


class StartedKind(Kind):
    """What is started: a node of the program, or an executable of some package."""

    def suggest(self, ask: Ask) -> str:
        """Return the first node that is not started yet."""
        names = _unstarted(ask)
        return first_that_works(ask, names) or next(iter(names), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the nodes."""
        nodes = ask.scene.workspace.nodes
        return [Choice(name, f"'{nodes[name].name}'") for name in _unstarted(ask)]

    def written(self, ask: Ask, text: str) -> str:
        """Return it as the program has it: what is no node is in quotes."""
        return text if text in ask.scene.workspace.nodes else f"'{text}'"

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if text in ask.scene.workspace.nodes or text.strip("/").count("/") == 1:
            return None
        return "it is a node of the program, or `package/executable`"


def _unstarted(ask: Ask) -> list[str]:
    """Return the nodes, those that the launch file starts already last."""
    launch = _launch(ask)
    held = set() if launch is None else {each.run_name for each in launch.starts.values()}
    nodes = ask.scene.workspace.nodes
    return sorted(nodes, key=lambda name: name in held or nodes[name].name in held)


class RunNameKind(Kind):
    """The name that a node is started by."""

    def suggest(self, ask: Ask) -> str:
        """Return the last that is started, for one that is to be no longer."""
        if ask.form.declaration.type is not st.NoLongerStarts:
            return ""
        return next((each.text for each in reversed(self.choices(ask, ""))), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return what is started, for one that is to be no longer."""
        launch = _launch(ask)
        if launch is None or ask.form.declaration.type is not st.NoLongerStarts:
            return []
        return [Choice(name) for name in launch.by_shortest_name]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text else "the launch file starts nothing yet"


class ArgumentKind(Kind):
    """An argument of a launch file."""

    def suggest(self, ask: Ask) -> str:
        """Return a name; of those that it has, the last one."""
        names = list(getattr(_launch(ask), "arguments", ()))
        if ask.form.declaration.undoes is not None:
            return names[-1] if names else ""
        return free_name("robot", names)

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those that it has, for one that is taken away."""
        if ask.form.declaration.undoes is None:
            return []
        return [Choice(name) for name in getattr(_launch(ask), "arguments", ())]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if text:
            return None
        if ask.form.declaration.undoes is None:
            return "an argument needs a name, such as `robot`"
        return "the launch file has no argument that could be taken away"


class IncludedKind(Kind):
    """A launch file of some package."""

    def suggest(self, ask: Ask) -> str:
        """Return the one that is included, for one that is to be no longer."""
        if ask.form.declaration.undoes is not None:
            return next((each.text for each in reversed(self.choices(ask, ""))), "")
        # What the program's own packages have is known, and another file of them refused.
        names = {each.name for each in ask.scene.workspace.packages.values()}
        return f"{free_name('my_robot', names)}/bringup.launch.xml"

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those that are included, for one that is to be no longer."""
        if ask.form.declaration.undoes is None:
            return []
        return [Choice(name) for name in getattr(_launch(ask), "includes", ())]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if text.strip("/").count("/") >= 1:
            return None
        return "it is a package and a file in it, such as `rover/sensors.launch.xml`"


class RemapsKind(Kind):
    """Names of a node, and those that they get."""

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        parts = [each.strip() for each in text.split(",")]
        if all(each.count("'") == 4 and " to " in each for each in parts):
            return None
        return "it is like `'scan' to 'laser'`, with commas between several"


class SettingsKind(Kind):
    """Parameters of a node, or arguments of a robot's file, and their values."""

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if text.startswith("'") and "=" in text:
            return None
        return "it is like `'speed' = 0.5`, with commas between several"


def _launch(ask: Ask) -> Launch | None:
    return ask.scene.workspace.launches.get(ask.text(SlotKind.LAUNCH))
