"""A template of the user's, which may come with a repository of somebody else's."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest
from file_sets import one
from made_nodes import SPAN, catalog
from templates_here import render_here

from plastron_tui.model.workspace import Node
from plastron_tui.targets import find_target, template_process
from plastron_tui.targets.base import Rendered

SECRET = "a line of a file that is none of the project's"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Give a template folder beside a file that is not its own."""
    (tmp_path / "secret").write_text(SECRET)
    (tmp_path / "mine" / "rospy").mkdir(parents=True)
    return tmp_path / "mine"


def render(folder: Path, template: str | None = None) -> Rendered:
    if template is not None:
        (folder / "rospy" / "node.py.j2").write_text(template)
    target = find_target("rospy", folder)
    assert target is not None
    return target.render(Node("robot", "robot", SPAN), catalog("rospy"))


def refusal(folder: Path, template: str | None = None) -> str:
    rendered = render(folder, template)
    assert rendered.files is None
    (diagnostic,) = rendered.diagnostics
    assert diagnostic.code == "template-error"
    assert len(diagnostic.message) < 600
    return diagnostic.message


@pytest.mark.parametrize(
    ("template", "reason"),
    [
        pytest.param(
            "{% for a in range(99999) %}{% for b in range(99999) %}{% endfor %}{% endfor %}",
            "it works for more than 2 s",
            id="loops",
            marks=pytest.mark.long,
        ),
        pytest.param('{{ "a" * 3000000000 }}', "it needs more than 512 MB of memory", id="repeat"),
        pytest.param('{{ "a"|center(3000000000) }}', "it needs more than 512 MB", id="filter"),
        pytest.param('{{ "a" * 2000000 }}', "it writes more than 1 MB", id="text"),
        pytest.param('{{ "(" * 9999 }}{{ ")" * 9999 }}', "recursion", id="nesting"),
        pytest.param('{{ "\\ud800" }}', "surrogates not allowed", id="surrogate"),
        pytest.param("{% include 'a' * 999999 %}", "cannot be used", id="message"),
        pytest.param("{% include 'node.py.j2' %}", "recursion", id="itself"),
    ],
)
def test_a_template_without_end_is_a_diagnostic(folder: Path, template: str, reason: str) -> None:
    assert reason in refusal(folder, template)


def test_templates_are_read_inside_of_their_folder(folder: Path) -> None:
    (folder / "parts").mkdir()
    (folder / "parts" / "head.j2").write_text("# ours\n")
    (folder / "rospy" / "head.j2").symlink_to("../parts/head.j2")
    assert render(folder, "{% include 'head.j2' %}").files == one(b"# ours\n")


# Each way to use another template, and each place that a link may lead to.
@pytest.mark.parametrize(
    ("use", "target"),
    [
        ("{% include 'x' %}", "../../secret"),
        ("{% import 'x' as x %}", "x"),
        ("{% extends 'x' %}", "/dev/zero"),
    ],
)
def test_no_template_leads_out_of_the_folder(folder: Path, use: str, target: str) -> None:
    (folder / "rospy" / "x").symlink_to(target)
    message = refusal(folder, use)
    assert SECRET not in message
    assert message.startswith("the template rospy/x cannot be used: ")


def test_the_template_itself_is_no_link_that_leads_out(folder: Path) -> None:
    (folder / "rospy" / "node.py.j2").symlink_to("../../secret")
    assert "a link that leads out of the template folder" in refusal(folder)


def test_the_folder_of_a_library_is_no_link_that_leads_out(folder: Path) -> None:
    (folder.parent / "node.py.j2").write_text(SECRET)
    (folder / "rospy").rmdir()
    (folder / "rospy").symlink_to("..")
    assert "a link that leads out of the template folder" in refusal(folder)


@pytest.mark.parametrize("name", ["../../secret", "/../../secret", "/etc/passwd"])
def test_no_name_leads_out_of_the_folder(
    folder: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    render_here(monkeypatch)
    rendered = render(folder, f"{{% include '{name}' %}}")
    (diagnostic,) = rendered.diagnostics
    assert SECRET not in diagnostic.message
    assert diagnostic.file is None or diagnostic.file.is_relative_to(folder)


def test_what_a_template_misses_is_no_template(folder: Path) -> None:
    rendered = render(folder, "{{ 5|xmlattr }}")
    (diagnostic,) = rendered.diagnostics
    assert diagnostic.file == folder / "rospy" / "node.py.j2"
    assert "rospy/node.py.j2" in diagnostic.message


@pytest.mark.parametrize(
    ("template", "reason"),
    [
        ("{% for a in range(99999) %}{% for b in range(99999) %}{% endfor %}{% endfor %}", "2 s"),
        ('{{ "a" * 3000000000 }}', "512 MB"),
    ],
)
@pytest.mark.long
def test_a_template_that_was_stopped_is_not_begun_again(
    folder: Path, monkeypatch: pytest.MonkeyPatch, template: str, reason: str
) -> None:
    assert reason in refusal(folder, template)
    monkeypatch.setattr(sys, "executable", "/nowhere")
    assert reason in refusal(folder)
    monkeypatch.undo()
    assert render(folder, "text\n").files == one(b"text\n")


def test_a_template_is_a_regular_file_that_is_not_too_large(folder: Path) -> None:
    template = folder / "rospy" / "node.py.j2"
    os.mkfifo(template)
    assert "is not a regular file" in refusal(folder)
    template.unlink()
    template.mkdir()
    assert "is a directory" in refusal(folder)
    template.rmdir()
    template.touch()
    os.truncate(template, 2**40)
    assert "is larger than 1 MB" in refusal(folder)
    template.unlink()
    template.symlink_to("node.py.j2")
    assert "cannot be used" in refusal(folder)


def test_no_module_is_taken_from_the_current_folder(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("jinja2", "markupsafe", "pickle", "plastron_tui"):
        (folder / f"{name}.py").write_text("raise SystemExit('taken')\n")
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PYTHONPATH", os.fspath(folder))
    monkeypatch.setattr(sys, "path", ["", ".", *sys.path])
    assert render(folder, "{{ node.name }}").files == one(b'"robot"')


@pytest.mark.parametrize(
    ("reply", "reason"),
    [
        ("import os; os.kill(os.getpid(), 9)", "its process ended with signal 9"),
        ("sys.exit(3)", "its process ended with status 3"),
        ("print('a\\n7x\\nb'); sys.exit(3)", "rospy/a cannot be used: b"),
        ("sys.stdout.buffer.write(b'\\xff')", "its process ended with status 0"),
        ("print('a' * 3_000_000)", "its process ended with status 0"),
        ("import time; time.sleep(99)", "it did not end within 1 s"),
    ],
)
def test_what_a_process_answers_is_text_only(
    folder: Path, monkeypatch: pytest.MonkeyPatch, reply: str, reason: str
) -> None:
    """As a template might that has got out of the sandbox."""
    monkeypatch.setattr(template_process, "_START", f"import sys\n{reply}")
    if "sleep" in reply:
        monkeypatch.setattr(template_process, "LONGEST_WAIT", 1)
    assert reason in refusal(folder, "")


def test_limits_that_are_tighter_stay() -> None:
    program = (
        "import resource\n"
        "from plastron_tui.targets import template_process\n"
        "resource.setrlimit(resource.RLIMIT_CPU, (2, 9))\n"
        "template_process.limit_itself(template_process._limits())\n"
        "print(resource.getrlimit(resource.RLIMIT_CPU), resource.getrlimit(resource.RLIMIT_AS)[0])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout == f"(2, 9) {template_process.MOST_MEMORY}\n"


def test_the_limits_are_those_of_the_process_alone(folder: Path) -> None:
    kinds = (resource.RLIMIT_AS, resource.RLIMIT_CPU)
    before = [resource.getrlimit(kind) for kind in kinds]
    assert render(folder, "{{ node.name }}").files is not None
    assert before == [resource.getrlimit(kind) for kind in kinds]


def test_a_part_that_is_mended_lets_a_stopped_template_begin_again(folder: Path) -> None:
    (folder / "parts").mkdir()
    part = folder / "parts" / "head.j2"
    part.write_text('{{ "a" * 3000000000 }}')
    (folder / "rospy" / "head.j2").symlink_to("../parts/head.j2")
    assert "512 MB" in refusal(folder, "{% include 'head.j2' %}")
    part.write_text("# ours\n")
    assert render(folder).files == one(b"# ours\n")


@pytest.mark.parametrize("library", ["roscpp", "nodelet", "rclcpp", "component"])
def test_a_node_in_cpp_is_written_by_a_template_of_the_users(tmp_path: Path, library: str) -> None:
    own = tmp_path / library
    own.mkdir()
    (own / "node.cpp.j2").write_text(
        "// {{ node.label }}, {{ headers | length }} headers\n{% include 'members.j2' %}\n"
    )
    (own / "members.j2").write_text("int ours;")
    target = find_target(library, tmp_path)
    assert target is not None
    rendered = target.render(Node("robot", "robot", SPAN), catalog("rospy"))
    assert rendered.files is not None, rendered.diagnostics
    texts = dict(rendered.files.texts)
    assert texts["{}.cpp"].endswith(b" headers\nint ours;\n")
    # The header, of which there is no template of the user's, is Plastron's own.
    assert all(b"class RobotNode" in text for name, text in texts.items() if name != "{}.cpp")


def test_a_part_of_a_node_in_cpp_is_the_users(tmp_path: Path) -> None:
    (tmp_path / "rclcpp").mkdir()
    (tmp_path / "rclcpp" / "node.cpp.j2").write_text("{% extends 'source.j2' %}")
    (tmp_path / "rclcpp" / "main.j2").write_text("// no main function\n")
    target = find_target("rclcpp", tmp_path)
    assert target is not None
    rendered = target.render(Node("robot", "robot", SPAN), catalog("rclpy"))
    assert rendered.files is not None, rendered.diagnostics
    assert rendered.files.main.decode().endswith("};\n\n// no main function\n")
