"""Every code that a diagnostic can have.

The list is the source of `docs/diagnostics.md`. The codes of mistakes in a program are in modules
of their own; here are those of files, of ROS and of its graph.
"""

from __future__ import annotations

from .code import Code
from .program_codes import PROGRAM_CODES
from .value_codes import VALUE_CODES

__all__ = ["CODES", "IO_CODES", "Code"]

CODES: dict[str, Code] = {
    code.name: code
    for code in (
        *PROGRAM_CODES,
        *VALUE_CODES,
        Code(
            "unusable-type",
            "A type has a field whose name is a keyword of Python. ROS 2 generates a Python module "
            "for it that Python cannot read, so that no Python node can use the type, nor one that "
            "it is part of. Give the field another name, or write the node in another language.",
        ),
        Code(
            "template-error",
            "A template in the project's template folder has a mistake, asks for something that a "
            "node does not have, lies outside of the folder, or takes more time, memory or text "
            "than a node needs. Correct it, or take it away to use Plastron's own.",
        ),
        Code(
            "cannot-write",
            "The operating system refuses to write a file, or something that is no file is in its "
            "place. Nothing was changed. Free some space, or choose another output folder.",
        ),
        Code(
            "outside-output",
            "A file would be written outside of the output folder: its name, or a symbolic link, "
            "leads out; or the output folder itself is a link out of the project. Remove the link, "
            "or name the folder with `-o`.",
        ),
        Code(
            "file-conflict",
            "A file in the output folder holds what Plastron did not write. It is left alone; "
            "`load` it in the program, or overwrite it with `--force`, which keeps a backup.",
        ),
        Code(
            "changed-on-disk",
            "A file was changed by somebody else between reading and writing it. Run it again.",
        ),
        Code(
            "interrupted-write",
            "Plastron was killed, or the machine stopped, while files were replaced. The next run "
            "made all of them new, or all old again, and says which; or it could not: you may not "
            "write there, or have changed one of them since. Compare the files that are named with "
            "what `plastron generate --diff` says.",
        ),
        Code(
            "leftover-file",
            "A temporary file of Plastron's (`.plastron-…`) cannot be removed, which the next run "
            "tries again; or it held the only copy of a text, which is `.plastron-kept` now. Look "
            "at it, and remove it.",
        ),
        Code(
            "not-kept",
            "A file was replaced, and something that is no part of its text did not come along: an "
            "extended attribute, or other names of the file (hard links), which keep the old text.",
        ),
        Code(
            "bad-definition",
            "A `.msg`, `.srv` or `.action` file has a mistake, or cannot be read; its type counts "
            "as not there. Correct the line, or the file.",
        ),
        Code(
            "same-file",
            "Two nodes of a program would be written to one file. Give one of them another name.",
        ),
        Code(
            "bad-manifest",
            "The output folder's `.plastron.json` cannot be read, so that every file that is in "
            "the way counts as written by hand. The next `generate` replaces it, with a backup.",
        ),
        Code(
            "no-node",
            "A file holds no node that Plastron can read: it is no text, or uses neither rospy nor "
            "rclpy. Name the file of the node itself.",
        ),
        Code(
            "file-too-large",
            "A file is larger than any node that a person writes, or has more comments in a row "
            "or more classes, and is not read.",
        ),
        Code(
            "endpoint-in-use",
            "An endpoint cannot be taken out of a hand-written file, because code beyond plain "
            "publishing uses it; the message lists the lines. Change these lines by hand first.",
        ),
        Code(
            "edit-refused",
            "A change of a hand-written file is not possible, or would have changed more than was "
            "asked for; the message says why. Nothing was written. Make the change by hand.",
        ),
        Code(
            "no-ros",
            "No ROS of the wanted version is on this machine. The help line has the command that "
            "installs one.",
        ),
        Code(
            "half-a-ros",
            "A ROS is installed in part: a client library without a middleware or a master, or a "
            "sourced ROS without a client library. The help line says how to add the rest.",
        ),
        Code(
            "missing-ros-package",
            "The program uses messages or services of a package that the ROS on this machine does "
            "not have. The help line has the command that installs it.",
        ),
        Code(
            "no-master",
            "No ROS 1 master answers at `ROS_MASTER_URI`, or none could be started there. Correct "
            "the variable, or unset it: `plastron run` then starts a master of its own.",
        ),
        Code(
            "remote-master",
            "`ROS_MASTER_URI` names another machine, but nodes speak on this machine only unless "
            "`--network` is given; a master on this machine is used instead.",
        ),
        Code(
            "no-graph",
            "The running graph could not be read; the message says why.",
        ),
        Code(
            "unreadable-file",
            "A file cannot be read as text: it is not there, a folder, too large, not UTF-8, has "
            "NUL bytes, or the operating system refuses. Save it as UTF-8, or name another file.",
        ),
        Code(
            "bad-project",
            "The project file `plastron.yaml` has a mistake: it is no YAML, or a key or a value of "
            "it means nothing. What is wrong counts as not written.",
        ),
        Code(
            "outside-project",
            "A `load`, or a path in `plastron.yaml`, leads out of the project, by `..`, an "
            "absolute path, `~` or a symbolic link; or into what is hidden (`.git`) or "
            "installed (`site-packages`). Or a link leads there from a program that is to be "
            "written, or from the definition of a type. Somebody else may have written it. Move "
            "what is meant into the project, or trust the project once with `plastron trust`; "
            "an output folder may also be named with `-o`.",
        ),
        Code(
            "foreign-project",
            "`plastron.yaml`, or the folder that it is in, belongs to another user. It is not read "
            "until you trust the project with `plastron trust`.",
        ),
        Code(
            "untrusted-templates",
            "The project has templates of its own, which decide what is in the nodes. Until you "
            "trust the project with `plastron trust`, Plastron's own are shown instead, and "
            "nothing is generated.",
        ),
        Code(
            "runs-by-itself",
            "A node file would get a name that Python, pytest, a shell or git runs without being "
            "asked (`usercustomize.py`, `conftest.py`, `.bashrc`), or that other nodes would "
            "import in the place of a module of Python's or of ROS (`rospy.py`). Give the file "
            "another name, or write it over the one that it comes from with `--in-place`.",
        ),
        Code(
            "unsafe-trust-store",
            "What `plastron trust` remembers among your own files could have been written by "
            "somebody else, or is broken, and counts for nothing. Remove it, and trust your "
            "folders again.",
        ),
        Code(
            "unsupported-target",
            "Plastron cannot do this for the client library yet: use `rospy` or `rclpy`. Or the "
            "client library is another distribution's, which cannot be loaded; the message says "
            "why.",
            "create_node 'a' as a using nodelet\n"
            "subscribe a to 'chatter' of message_type String\n"
            "generate_node a\n",
            "create_node 'a' as a using rospy\n"
            "subscribe a to 'chatter' of message_type String\n"
            "generate_node a\n",
        ),
        Code(
            "nothing-to-generate",
            "A program generates no node. End it with `generate_node` and the variable of a node.",
        ),
        Code(
            "port-by-hand",
            "A node goes from one ROS to the other (`generate_node` of a loaded node, `using` "
            "another client library), and this line means nothing there, or something else. It is "
            "carried over as it is, under a comment `# port by hand: …`; change it in the new "
            "file.",
        ),
        Code(
            "merged-by-hand",
            "A generated file was changed by hand. It is kept, and what changed in the "
            "program since the file was written is changed in it. A warning of its own names each "
            "place where file and program now differ. `generate --force` writes it anew and "
            "keeps a backup.",
        ),
        Code(
            "left-behind",
            "A node does other things than before, so that its file has another name; the old file "
            "is still there and can still be started. What was written in it by hand went into the "
            "new file. Compare the two, and remove the old one.",
        ),
        Code(
            "hidden-file",
            "`load NAME` finds a file in the output folder, and another of the same name in the "
            "program's folder. Nothing tells that Plastron wrote the first (its `.plastron.json` "
            "is gone, perhaps), so that changes which an earlier run made would be made again. "
            "Remove the first, or load the other by its path.",
        ),
        Code(
            "changes-undone",
            "A file that other programs had loaded and changed is made anew, without their "
            "changes, because the program that it came from has changed. Generate the others "
            "again.",
        ),
    )
}

IO_CODES = frozenset({"cannot-write", "outside-output"})
"""The codes of files that cannot be read or written: a command then exits with 2, not 1."""
