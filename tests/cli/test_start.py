"""How plastron starts: what it imports, its help, its completion, and how it ends."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import click
import pytest
from click.testing import CliRunner
from command_line import BROKEN, PLASTRON, TALKER, Run

from plastron_tui.cli.group import cli

PAGE = Path(__file__).parents[2] / "docs" / "commands.md"

COMMANDS = (
    *("check", "completion", "describe", "fmt", "generate", "graph", "inspect", "run", "serve"),
    *("shell", "types", "wizard"),
)


def imported_by(here: Path, *arguments: str) -> set[str]:
    code = (
        "import sys; from plastron_tui.cli.group import cli\n"
        "try: cli.main(sys.argv[1:], prog_name='plastron', standalone_mode=False)\n"
        "finally: print('\\n' + ' '.join(sys.modules))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, cwd=here, check=True
    )
    return set(result.stdout.decode().split("\n")[-2].split())


@pytest.mark.parametrize("program", [TALKER, BROKEN])
def test_check_imports_only_what_it_needs(here: Path, program: str) -> None:
    (here / "a.plastron").write_text(program)
    modules = imported_by(here, "check", "a.plastron")
    heavy = {"textual", "jinja2", "importlib.metadata", "importlib.resources"}
    heavy |= {"tree_sitter_cpp", "tree_sitter_python"}
    assert not modules & heavy
    assert "plastron_tui.model.interpreter" in modules


def test_check_of_a_right_program_renders_nothing(here: Path) -> None:
    (here / "a.plastron").write_text(TALKER)
    modules = imported_by(here, "check", "a.plastron")
    unneeded = {"json", "difflib", "plastron_tui.diagnostics.render", "plastron_tui.output.plan"}
    assert not modules & unneeded


def test_check_seldom_looks_for_cycles_among_its_modules(here: Path) -> None:
    (here / "a.plastron").write_text(TALKER)
    code = (
        "import atexit, gc\n"
        "from plastron_tui.cli import main\n"
        "seen = []\n"
        "gc.callbacks.append(lambda phase, _: seen.append(phase))\n"
        "atexit.register(lambda: print(seen.count('start')))\n"
        "main()"
    )
    command = [sys.executable, "-c", code, "check", "a.plastron"]
    environ = {**os.environ, "PYTHONDONTWRITEBYTECODE": ""}
    # What is compiled anew makes many objects: the second time nothing is.
    found = [
        subprocess.run(command, capture_output=True, cwd=here, env=environ, check=True).stdout
        for _ in range(2)
    ]
    assert int(found[1]) == 0


def test_help_and_completion_import_no_command(here: Path) -> None:
    modules = imported_by(here, "--help")
    assert not {name for name in modules if name.startswith("plastron_tui.cli.")} - {
        "plastron_tui.cli.group",
        "plastron_tui.cli.entry",
        "plastron_tui.cli.streams",
    }
    assert "tree_sitter" not in modules


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("flag", ["--help", "-h"])
def test_help_has_an_example(command: str, flag: str) -> None:
    result = CliRunner().invoke(cli, [command, flag])
    assert result.exit_code == 0, result.output
    assert "Example: " in result.output
    assert f"plastron {command}" in result.output


def test_help_lists_every_command_with_a_line() -> None:
    result = CliRunner().invoke(cli, ["--help"])
    for command in COMMANDS:
        (line,) = (line for line in result.output.split("\n") if line.startswith(f"  {command} "))
        assert len(line.split()) > 2


@pytest.mark.parametrize("name", COMMANDS)
def test_the_choices_on_the_page_of_commands_are_those_there_are(name: str) -> None:
    command = cli.get_command(click.Context(cli), name)
    assert command is not None
    types = [parameter.type for parameter in command.params]
    choices = {"|".join(type_.choices) for type_ in types if isinstance(type_, click.Choice)}
    _, overview, *_ = PAGE.read_text(encoding="utf-8").split("```")
    (usage,) = re.findall(rf"^plastron {name}\b.*", overview, re.MULTILINE)
    assert set(re.findall(r"\b[a-z0-9]+(?:\|[a-z0-9]+)+", usage)) <= choices


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "Usage: plastron"),
        (["chekc"], "did you mean 'check'?"),
        (["a.plastron"], "plastron check a.plastron"),
        (["wizard", "a.plastron"], "the studio needs a terminal"),
        (["--nonsense"], "--nonsense"),
        (["check"], "Missing argument"),
        (["check", "--format", "xml", "a"], "'xml'"),
        (["check", "--target", "rosjs", "a"], "'rosjs'"),
        (["generate", "-o", "", "a"], "the name of the folder is empty"),
        (["types", "a", "b"], "unexpected extra argument"),
        (["types", "-d", "indigo"], "'indigo'"),
        (["inspect"], "Missing argument"),
        (["completion", "tcsh"], "'tcsh'"),
    ],
)
def test_wrong_usage_is_2(run: Run, arguments: list[str], said: str) -> None:
    result = run(*arguments)
    assert result.returncode == 2
    assert said in result.stderr.decode()
    assert result.stdout == b""


def test_version(run: Run) -> None:
    result = run("--version")
    assert (result.returncode, result.stdout[:9]) == (0, b"plastron,")


def test_console_script_is_main() -> None:
    script = Path(sys.executable).with_name("plastron")
    result = subprocess.run([script, "--version"], capture_output=True)
    assert (result.returncode, result.stdout[:9]) == (0, b"plastron,")


def complete(here: Path, *lines: tuple[str, ...]) -> list[list[str]]:
    """Complete the last word of each line as bash does: source the script, call what it registers.

    Returns what is offered for each.
    """
    script = [
        'eval "$(plastron completion bash)"',
        "compopt() { :; }",
        "complete_line() {",
        '  COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()',
        "  _plastron_completion plastron",
        '  echo "${COMPREPLY[@]}"',
        "}",
        *(f"complete_line plastron {shlex.join(words)}" for words in lines),
    ]
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    result = subprocess.run(
        ["bash", "-c", "\n".join(script)],
        capture_output=True,
        cwd=here,
        env={**os.environ, "PATH": path},
    )
    assert result.stderr == b"", result.stderr.decode()
    return [line.split() for line in result.stdout.decode().splitlines()]


def test_bash_completes_commands_options_and_choices(here: Path) -> None:
    a_command, commands, option, a_format, wizard, generate = complete(
        here,
        ("ge",),
        ("",),
        ("generate", "--d"),
        ("graph", "--format", "m"),
        ("wizard", "--target", "rclp"),
        ("generate", "--target", "rosp"),
    )
    assert a_command == ["generate"]
    assert set(COMMANDS) <= set(commands)
    assert "--dry-run" in option
    assert a_format == ["mermaid"]
    assert (wizard, generate) == (["rclpy"], ["rospy"])


def test_bash_leaves_file_names_to_the_shell(here: Path) -> None:
    script = (
        'eval "$(plastron completion bash)"\n'
        "compopt() { echo $*; }\n"
        "COMP_WORDS=(plastron check tal); COMP_CWORD=2; _plastron_completion plastron"
    )
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    result = subprocess.run(
        ["bash", "-c", script], capture_output=True, cwd=here, env={**os.environ, "PATH": path}
    )
    assert result.stdout.split() == [b"-o", b"default"]


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_script_names_plastron(run: Run, shell: str) -> None:
    result = run("completion", shell)
    assert result.returncode == 0
    assert b"_PLASTRON_COMPLETE" in result.stdout


def test_a_result_goes_to_any_encoding(run: Run, here: Path) -> None:
    name = os.fsdecode(b"b\xe4\xff.plastron")
    (here / name).write_text("create_node  'a'  as a")
    for encoding in ("ascii", "latin-1", "utf-8"):
        result = run("fmt", "--check", name, env={"PYTHONIOENCODING": encoding})
        assert result.returncode == 1
        assert result.stdout.startswith(b"would reformat b")


def test_full_standard_output_is_2(here: Path) -> None:
    with Path("/dev/full").open("wb") as full:
        result = subprocess.run(
            [*PLASTRON, "types", "-d", "noetic"], stdout=full, stderr=subprocess.PIPE
        )
    assert result.returncode == 2
    assert result.stderr == b"error: no space left on device\n"


def test_reader_that_leaves_is_no_error(here: Path) -> None:
    with subprocess.Popen(
        [*PLASTRON, "types", "-d", "noetic"], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        process.stdout.close()
        assert process.wait(60) == 0
        assert process.stderr is not None
        assert process.stderr.read() == b""


def test_working_folder_that_is_gone(tmp_path: Path) -> None:
    gone = tmp_path / "gone"
    gone.mkdir()
    code = f"import os; os.chdir({str(gone)!r}); os.rmdir({str(gone)!r}); {PLASTRON[2]}"
    result = subprocess.run(
        [sys.executable, "-c", code, "shell"], input=b"create_node 'a' as a\n", capture_output=True
    )
    assert result.returncode == 2
    assert b"Traceback" not in result.stderr
    assert b"error: " in result.stderr
