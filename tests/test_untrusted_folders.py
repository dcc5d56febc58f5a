"""What somebody else's folder cannot do before the user trusts it: each attack, one by one."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from machine import skip_or_fail

from plastron_tui.diagnostics import Diagnostic, Severity, has_errors
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.trust import TrustStore

NODE = """\
import rospy
from std_msgs.msg import String


def heard(message):
    pass


rospy.init_node('robot')
rospy.Subscriber('alarm', String, heard)
rospy.spin()
"""
TALKER = """\
create_node 'talker' as n
create_message hello of message_type String and input "hello"
n publish hello to 'chatter' of message_type String
generate_node n
"""
NOBODY = 65534


def changing(source: str) -> str:
    return f"load {source} as n\nsubscribe n to 'more' of message_type String\ngenerate_node n\n"


@dataclass(frozen=True)
class Attack:
    """What is in somebody's repository.

    Attributes:
        program: its program.
        project: its `plastron.yaml`.
        nodes: its node files.
        links: its symbolic links, and where they lead from the folder above.
        expected: the code of the diagnostic that refuses it.
        in_place: whether the user generates with `--in-place`.
    """

    program: str = TALKER
    project: str = ""
    nodes: tuple[str, ...] = ()
    links: dict[str, str] = field(default_factory=dict)
    expected: str = "outside-project"
    in_place: bool = False


ATTACKS = {
    # The folder beside the repository is `home`, where Python and shells find what they run.
    "output: absolute": Attack(project="output: {home}/site"),
    "output: ~": Attack(project="output: ~/site"),
    "output: ..": Attack(project="output: ../home/site"),
    "output: in and out": Attack(project="output: nodes/../../home/site"),
    "output: a link": Attack(project="output: nodes", links={"nodes": "home/site"}),
    "output: below a link": Attack(project="output: nodes/site", links={"nodes": "home"}),
    "output: git's hooks": Attack(project="output: .git/hooks"),
    "output: a link to git's hooks": Attack(project="output: hooks", links={"hooks": "repo/.git"}),
    "output: installed packages": Attack(project="output: env/lib/site-packages"),
    "output: none, a link": Attack(links={"output": "home/site"}, expected="outside-output"),
    "output: none, a link to git's hooks": Attack(
        links={"output": "repo/.git/hooks"}, expected="outside-output"
    ),
    "types: absolute": Attack(project="types: [{home}]"),
    "types: ..": Attack(project="types: ../home"),
    "types: a link": Attack(project="types: msgs", links={"msgs": "home"}),
    "templates: absolute": Attack(project="templates: {home}"),
    "templates: a link": Attack(project="templates: t", links={"t": "home"}),
    "load: ..": Attack(changing("'../home/site/usercustomize.py'"), in_place=True),
    "load: absolute": Attack(changing("'{home}/site/driver.py'"), in_place=True),
    "load: ~": Attack(changing("'~/site/driver.py'"), in_place=True),
    "load: a link": Attack(
        changing("'driver.py'"), links={"driver.py": "home/site/driver.py"}, in_place=True
    ),
    "load: below a link": Attack(changing("'x/driver.py'"), links={"x": "home/site"}),
    "load: a name that is a link": Attack(
        changing("driver"), links={"driver.py": "home/site/driver.py"}, in_place=True
    ),
    "load: a name in the output folder": Attack(
        changing("driver"), links={"output/driver.py": "home/site/driver.py"}
    ),
    "load: nothing there": Attack(changing("'../home/nothing.py'")),
    "load: git's hooks": Attack(changing("'.git/hooks/pre-commit'"), in_place=True),
}  # fmt: skip


@dataclass(frozen=True)
class Bench:
    """A repository of somebody else's, and the user's own folder beside it."""

    folder: Path

    @property
    def repository(self) -> Path:
        return self.folder / "repo"

    @property
    def home(self) -> Path:
        return self.folder / "home"

    def make(self, attack: Attack) -> None:
        for name in ("home/site", "repo/.git/hooks", "repo/nodes_", "repo/env/lib/site-packages"):
            (self.folder / name).mkdir(parents=True)
        for name in ("site/usercustomize.py", "site/driver.py", ".bashrc"):
            (self.home / name).write_text(NODE)
        (self.repository / ".git" / "hooks" / "pre-commit").write_text(NODE)
        (self.repository / "a.plastron").write_text(self._filled(attack.program))
        if attack.project:
            (self.repository / "plastron.yaml").write_text(self._filled(attack.project))
        for name in attack.nodes:
            path = self.repository / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(NODE)
        for name, target in attack.links.items():
            path = self.repository / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.symlink_to(self.folder / target)

    def _filled(self, text: str) -> str:
        return text.replace("{home}", str(self.home))

    def session(self, **options: object) -> Session:
        file = self.repository / "a.plastron"
        return Session(file.read_bytes(), file, Options(**options), environ={})  # type: ignore[arg-type]

    def generate(self, **options: object) -> list[Diagnostic]:
        """Generate as the command does, and return what is wrong."""
        session = self.session(is_writing=True, **options)
        found = session.diagnostics
        if has_errors(found):
            return list(found)
        plan, problems = session.plan()
        if not has_errors(problems) and not plan.conflicts:
            problems = (*problems, *write(plan).diagnostics)
        return [*found, *problems, *plan.conflicts]

    def state(self) -> dict[str, bytes]:
        """Return all that is in the user's folder and in what is run by itself."""
        places = (self.home, self.repository / ".git", self.repository / "env")
        return {
            str(path): path.read_bytes()
            for place in places
            for path in place.rglob("*")
            if path.is_file()
        }


@pytest.fixture
def bench(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Bench:
    made = Bench(tmp_path)
    monkeypatch.setenv("HOME", str(made.home))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    return made


def errors(found: list[Diagnostic]) -> list[str]:
    return [each.code for each in found if each.severity is Severity.ERROR]


@pytest.mark.parametrize("attack", ATTACKS.values(), ids=ATTACKS)
def test_what_leads_out_is_refused_and_says_how_to_trust(bench: Bench, attack: Attack) -> None:
    bench.make(attack)
    before = bench.state()
    found = bench.generate(in_place=attack.in_place)
    assert errors(found) == [attack.expected]
    assert f"`plastron trust {bench.repository}`" in (found[0].help or "")
    assert bench.state() == before


@pytest.mark.parametrize("attack", ATTACKS.values(), ids=ATTACKS)
def test_what_leads_out_is_the_users_wish_once_it_is_trusted(bench: Bench, attack: Attack) -> None:
    bench.make(attack)
    store = TrustStore()
    store.add(bench.repository)
    assert attack.expected not in errors(bench.generate(in_place=attack.in_place))
    store.remove(bench.repository)
    assert errors(bench.generate(in_place=attack.in_place)) == [attack.expected]


@pytest.mark.parametrize("name", [name for name in ATTACKS if name.startswith("output")])
def test_an_output_folder_that_the_command_line_names_is_the_users_word(
    bench: Bench, name: str
) -> None:
    bench.make(ATTACKS[name])
    assert errors(bench.generate(output=bench.home / "nodes")) == []
    assert (bench.home / "nodes" / "talker_pub.py").is_file()


def test_what_is_in_the_named_output_folder_may_be_loaded(bench: Bench) -> None:
    bench.make(Attack(changing("driver")))
    assert errors(bench.generate(output=bench.home / "site")) == []


def test_a_name_that_is_found_in_the_working_folder_alone_leads_out(
    bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    bench.make(Attack(changing("usercustomize")))
    monkeypatch.chdir(bench.home / "site")
    before = bench.state()
    assert errors(bench.generate(in_place=True)) == ["outside-project"]
    assert bench.state() == before


def test_a_manifest_leads_to_no_file_outside(bench: Bench) -> None:
    bench.make(Attack(changing("'src/driver.py'"), nodes=("src/driver.py",)))
    assert errors(bench.generate()) == []
    # What was loaded is now a link, and what is loaded is what was made of it.
    (bench.repository / "src" / "driver.py").unlink()
    (bench.repository / "src" / "driver.py").symlink_to(bench.home / "site" / "driver.py")
    (bench.home / "site" / "driver.py").write_text(NODE.replace("alarm", "secret"))
    (bench.repository / "a.plastron").write_text(changing("driver"))
    before = bench.state()
    for in_place in (False, True):
        bench.generate(in_place=in_place)
        assert "secret" not in (bench.repository / "output" / "driver.py").read_text()
    assert bench.state() == before


def test_a_whole_project_simply_works(bench: Bench) -> None:
    program = changing("'src/driver.py'") + TALKER.replace("n publish", "m publish").replace(
        "as n", "as m").replace("generate_node n", "generate_node m")  # fmt: skip
    bench.make(Attack(program, "output: nodes\ntypes: msgs\n", ("src/driver.py",)))
    (bench.repository / "msgs").mkdir()
    assert bench.generate() == []
    assert {path.name for path in (bench.repository / "nodes").glob("*.py")} == {
        "driver.py", "talker_pub.py",
    }  # fmt: skip


RUN_BY_THEMSELVES = [
    "usercustomize.py", "sitecustomize.py", "conftest.py", "__init__.py", "__main__.py",
    "setup.py", "noxfile.py", "tasks.py", "test_robot.py", "robot_test.py", ".bashrc", ".profile",
    ".zshrc", "UserCustomize.py", "pre-commit", "rospy.py", "std_msgs.py", "threading.py",
    "random.py", "x.pth", "rosgraph_msgs.py", "rcl_interfaces.py", "typing_extensions.py",
    "_rclpy_pybind11.py",
]  # fmt: skip


@pytest.mark.parametrize("name", RUN_BY_THEMSELVES)
def test_no_loaded_node_gets_a_name_that_runs_by_itself(bench: Bench, name: str) -> None:
    is_hidden = name.startswith(".")
    bench.make(Attack(changing(f"'src/{name}'"), nodes=(f"src/{name}",)))
    if is_hidden:
        TrustStore().add(bench.repository)
    for output in (None, bench.home):
        assert errors(bench.generate(output=output)) == ["runs-by-itself"]
    assert not (bench.repository / "output").exists()
    assert (bench.home / ".bashrc").read_text() == NODE
    assert errors(bench.generate(in_place=True)) == []
    assert "more" in (bench.repository / "src" / name).read_text()


@pytest.mark.parametrize("name", ["robot.py", "robot", "latest.py", "contest.py", "turtle.py"])
def test_other_names_are_fine(bench: Bench, name: str) -> None:
    bench.make(Attack(changing(f"'src/{name}'"), nodes=(f"src/{name}",)))
    assert bench.generate() == []


def test_a_ported_node_gets_no_such_name_either(bench: Bench) -> None:
    program = "load 'src/conftest.py' as n\ngenerate_node n using rclpy\n"
    bench.make(Attack(program, nodes=("src/conftest.py",)))
    assert errors(bench.generate(in_place=True)) == ["runs-by-itself"]


def test_a_node_of_plastrons_own_may_be_called_a_test(bench: Bench) -> None:
    bench.make(Attack(TALKER.replace("'talker'", "'test_talker'")))
    assert bench.generate() == []
    assert (bench.repository / "output" / "test_talker_pub.py").is_file()


def _chown(path: Path) -> None:
    if os.geteuid() != 0:
        skip_or_fail("only root can give a file to another user")
    os.chown(path, NOBODY, NOBODY)


@pytest.mark.parametrize("given", ["plastron.yaml", "."])
def test_a_project_file_of_another_user_counts_for_nothing(bench: Bench, given: str) -> None:
    bench.make(Attack(project="output: nodes\ntarget: rclpy\n"))
    _chown(bench.repository / given)
    session = bench.session()
    assert (session.library, session.project.output) == ("rospy", None)
    assert errors(bench.generate()) == ["foreign-project"]
    assert not (bench.repository / "output").exists()
    TrustStore().add(bench.repository)
    assert bench.generate() == []
    assert (bench.repository / "nodes" / "talker_pub.py").is_file()


def test_whoever_runs_it_counts_as_the_user(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    bench.make(Attack(project="output: nodes\n"))
    monkeypatch.setattr(os, "geteuid", lambda: NOBODY)
    assert errors(bench.generate()) == ["foreign-project"]


TEMPLATES = Attack(project="templates: mine\n", nodes=("mine/rospy/node.py.j2",))


def test_templates_wait_for_trust(bench: Bench) -> None:
    bench.make(TEMPLATES)
    session = bench.session()
    (warning,) = session.diagnostics
    assert (warning.code, warning.severity) == ("untrusted-templates", Severity.WARNING)
    made = session.generated()[0].files
    assert made is not None
    assert b"talker" in made.files.main
    assert not has_errors(session.plan_of(session.generated(), is_preview=True)[1])
    assert has_errors(session.plan()[1])
    assert errors(bench.generate()) == ["untrusted-templates"]
    assert errors(bench.generate(output=bench.home / "nodes")) == ["untrusted-templates"]
    assert not (bench.repository / "output").exists()


def test_trusted_templates_are_used_at_once(bench: Bench) -> None:
    bench.make(TEMPLATES)
    session = bench.session()
    assert session.diagnostics
    TrustStore().add(bench.repository)
    session.trust_changed()
    assert session.diagnostics == ()
    made = session.generated()[0].files
    assert made is not None
    assert made.files.main.decode().strip() == NODE.strip()


@pytest.mark.parametrize(
    "spoil",
    [lambda store: store.chmod(0o777), lambda store: next(store.iterdir()).write_text("/")],
    ids=["store", "entry"],
)
def test_a_spoilt_store_trusts_nothing(bench: Bench, spoil: Callable[[Path], object]) -> None:
    bench.make(TEMPLATES)
    store = TrustStore()
    store.add(bench.repository)
    assert bench.generate() == []
    spoil(store.folder)
    assert errors(bench.generate()) == ["untrusted-templates"]


@pytest.mark.parametrize("path", [".", "./", "./a.plastron"])
def test_nothing_is_tidied_up_above_the_project(bench: Bench, path: str) -> None:
    bench.make(Attack(f"load '{path}' as node\ngenerate_node node\n"))
    for folder in (bench.folder, bench.repository):
        (folder / ".plastron-0.new").write_text("left by a write that was killed")
    assert has_errors(bench.session().diagnostics)
    assert (bench.folder / ".plastron-0.new").exists()
