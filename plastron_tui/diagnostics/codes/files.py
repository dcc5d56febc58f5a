"""Files, and what is written to them. No program shows these mistakes."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code
from plastron_tui.diagnostics.severity import Severity

SEVERAL_NODES = Code(
    "several-nodes",
    "A file holds several nodes, and `load` does not say which one is meant: write the name "
    "that it has in the file, as in `load arms node 'left_arm' as left`. Where the file does "
    "not say a node's name, the name of its class stands for it.",
)

TEMPLATE_ERROR = Code(
    "template-error",
    "A template in the project's template folder has a mistake, asks for something that a "
    "node does not have, lies outside of the folder, or takes more time, memory or text "
    "than a node needs. Correct it, or take it away to use Plastron's own.",
)

CANNOT_WRITE = Code(
    "cannot-write",
    "The operating system refuses to write a file, or something that is no file is in its "
    "place. Nothing was changed. Free some space, or choose another output folder.",
    is_io=True,
)

OUTSIDE_OUTPUT = Code(
    "outside-output",
    "A file would be written outside of the output folder: its name, or a symbolic link, "
    "leads out; or the output folder itself is a link out of the project. Remove the link, "
    "or name the folder with `-o`. A header that belongs to a loaded node may be too far up "
    "from its source to lie in the output folder as it does there: use `--in-place`.",
    is_io=True,
)

FILE_CONFLICT = Code(
    "file-conflict",
    "A file in the output folder holds what Plastron did not write. It is left alone; "
    "`load` it in the program, or overwrite it with `--force`, which keeps a backup.",
)

CHANGED_ON_DISK = Code(
    "changed-on-disk",
    "A file was changed by somebody else between reading and writing it. Run it again.",
)

INTERRUPTED_WRITE = Code(
    "interrupted-write",
    "Plastron was killed, or the machine stopped, while files were replaced. The next run "
    "made all of them new, or all old again, and says which; or it could not: you may not "
    "write there, or have changed one of them since. Compare the files that are named with "
    "what `plastron generate --diff` says.",
    severity=Severity.WARNING,
)

LEFTOVER_FILE = Code(
    "leftover-file",
    "A temporary file of Plastron's (`.plastron-…`) cannot be removed, which the next run "
    "tries again; or it held the only copy of a text, which is `.plastron-kept` now. Look "
    "at it, and remove it.",
    severity=Severity.WARNING,
)

NOT_KEPT = Code(
    "not-kept",
    "A file was replaced, and something that is no part of its text did not come along: an "
    "extended attribute, or other names of the file (hard links), which keep the old text.",
    severity=Severity.WARNING,
)

SAME_FILE = Code(
    "same-file",
    "Two texts would be written to one file: two nodes, launch files or packages have one name. "
    "Give one of them another name.",
)

BAD_MANIFEST = Code(
    "bad-manifest",
    "The output folder's `.plastron.json` cannot be read, so that every file that is in "
    "the way counts as written by hand. The next `generate` replaces it, with a backup.",
    severity=Severity.WARNING,
)

NO_NODE = Code(
    "no-node",
    "A file holds no node that Plastron can read: it is no text, or uses neither rospy nor "
    "rclpy. Name the file of the node itself.",
)

FILE_TOO_LARGE = Code(
    "file-too-large",
    "A file is larger than any node that a person writes, or has more comments in a row, "
    "more classes or more brackets within each other, and is not read; or it would be larger "
    "than what is read of a robot, and is not written.",
)

ENDPOINT_IN_USE = Code(
    "endpoint-in-use",
    "An endpoint cannot be taken out of a hand-written file, because code beyond plain "
    "publishing uses it; the message lists the lines. Change these lines by hand first.",
)

EDIT_REFUSED = Code(
    "edit-refused",
    "A change of a hand-written file is not possible, or would have changed more than was "
    "asked for; the message says why. Nothing was written. Make the change by hand.",
)

UNREADABLE_FILE = Code(
    "unreadable-file",
    "A file cannot be read as text: it is not there, a folder, too large, not UTF-8, has "
    "NUL bytes, or the operating system refuses. Save it as UTF-8, or name another file.",
)

BROKEN_PYTHON = Code(
    "broken-python",
    "A file of a workspace has a syntax error, so that Python 3 runs nothing of it. Code of "
    "ROS 1, which may be for Python 2, is not told of.",
)

BAD_PROJECT = Code(
    "bad-project",
    "The project file `plastron.yaml` has a mistake: it is no YAML, or a key or a value of "
    "it means nothing. What is wrong counts as not written.",
)

OUTSIDE_PROJECT = Code(
    "outside-project",
    "A `load`, or a path in `plastron.yaml`, leads out of the project, by `..`, an "
    "absolute path, `~` or a symbolic link; or into what is hidden (`.git`) or "
    "installed (`site-packages`). Or a link leads there from a program that is to be "
    "written, or from the definition of a type. Somebody else may have written it. Move "
    "what is meant into the project, or trust the project once with `plastron trust`; "
    "an output folder may also be named with `-o`.",
)

FOREIGN_PROJECT = Code(
    "foreign-project",
    "`plastron.yaml`, or the folder that it is in, belongs to another user. It is not read "
    "until you trust the project with `plastron trust`.",
)

UNTRUSTED_TEMPLATES = Code(
    "untrusted-templates",
    "The project has templates of its own, which decide what is in the nodes. Until you "
    "trust the project with `plastron trust`, Plastron's own are shown instead, and "
    "nothing is generated.",
    severity=Severity.WARNING,
)

RUNS_BY_ITSELF = Code(
    "runs-by-itself",
    "A node file would get a name that Python, pytest, a shell or git runs without being "
    "asked (`usercustomize.py`, `conftest.py`, `.bashrc`), or that other nodes would "
    "import in the place of a module of Python's or of ROS (`rospy.py`). Give the file "
    "another name, or write it over the one that it comes from with `--in-place`.",
)

UNSAFE_TRUST_STORE = Code(
    "unsafe-trust-store",
    "What `plastron trust` remembers among your own files could have been written by "
    "somebody else, or is broken, and counts for nothing. Remove it, and trust your "
    "folders again.",
)

NOTHING_TO_GENERATE = Code(
    "nothing-to-generate",
    "A program generates no node, package, launch file or type. End it with `generate_node` and "
    "the variable of a node, or with `generate_package`, `generate_launch` or `generate_type`.",
)

PORT_BY_HAND = Code(
    "port-by-hand",
    "A node goes from one ROS to the other (`generate_node` of a loaded node, `using` "
    "another client library), and this line means nothing there, or something else. It is "
    "carried over as it is, under a comment `# port by hand: …`; change it in the new "
    "file.",
    severity=Severity.WARNING,
)

OTHER_TYPE = Code(
    "other-type",
    "An endpoint of a loaded file gets another type, and the function that it called has code in "
    "it for the type that was there before. Where that code cannot do with the new type, a new "
    "function is called in its place, unless a statement says `calling`. Change the function by "
    "hand, or name another one with `calling`.",
    severity=Severity.WARNING,
)

GUESSED_NAME = Code(
    "guessed-name",
    "An endpoint of a loaded file is changed or taken out, and its name is no more than the "
    "default of a parameter of a class or a function that the file itself never calls. Another "
    "file that does may give another name: the endpoint that runs is another one then. Look at "
    "what the other file gives.",
    severity=Severity.WARNING,
)

UNCALLED_FUNCTION = Code(
    "uncalled-function",
    "A statement takes away what called a function of a loaded file, and nothing else in the file "
    "mentions it. A function with your code in it is kept; remove it by hand where no other file "
    "uses it either.",
    severity=Severity.WARNING,
)

STILL_READ = Code(
    "still-read",
    "A statement takes away what called the one function of a loaded file that set an attribute "
    "or a variable, filled a queue or woke who waits. Other functions go on reading it: what they "
    "find is its first value, and what waits for another one waits for ever.",
    severity=Severity.WARNING,
)

IDLE_CODE = Code(
    "idle-code",
    "A statement takes away all that a function of a loaded file did, all that a loop did but to "
    "sleep, all that a node was made for, or all that was done with what a call returns. It is "
    "kept, as something calls it, waits for its end or looks for the node, or as the call may do "
    "something besides; remove it by hand where nothing needs that.",
    severity=Severity.WARNING,
)

UNREAD_PARAMETER = Code(
    "unread-parameter",
    "A loaded file read a parameter for nothing but what a statement takes away, and does not "
    "declare or read it any more. What sets it, as a launch file does, has no effect.",
    severity=Severity.WARNING,
)

WRITTEN_ANEW = Code(
    "written-anew",
    "A statement takes something out of a loaded file and another one writes it anew, under "
    "another name or with another message; what its lines said besides goes with them. "
    "`renames` changes the name and nothing else.",
    severity=Severity.WARNING,
)

READ_ONCE = Code(
    "read-once",
    "What is added to a loaded file has the rate that a parameter says as the node starts. In a "
    "node that Plastron writes the rate follows the parameter; in a file of yours, let it do so by "
    "hand where the parameter changes while the node runs.",
    severity=Severity.WARNING,
)

SHARED_NAME = Code(
    "shared-name",
    "An endpoint is added to a class of a loaded file whose objects are told a name or a namespace "
    "of their own, or what to call their other endpoints. Where there are several objects, each "
    "creates it by the same name; rospy takes no second service of a name.",
    severity=Severity.WARNING,
)

STILL_NAMED = Code(
    "still-named",
    "A loaded file goes on saying the name of something that is removed or called otherwise: in a "
    "text that is the name, in what it logs, or in a comment or a docstring, where a `/` or a `_`, "
    "or the word topic, tells that the name is meant.",
    severity=Severity.WARNING,
)

WAKES_LOOP = Code(
    "wakes-loop",
    "A loop of a loaded file has no rate of its own: it goes on whenever `spin_once` has called "
    "something, or has waited. What is added is called too, so that the loop runs more often.",
    severity=Severity.WARNING,
)

MERGED_BY_HAND = Code(
    "merged-by-hand",
    "A generated file was changed by hand. It is kept, and what changed in the "
    "program since the file was written is changed in it: a note says so. A warning of its own "
    "names each place where file and program now differ. `generate --force` writes it anew and "
    "keeps a backup.",
    severity=Severity.WARNING,
)

HIDDEN_FILE = Code(
    "hidden-file",
    "`load NAME` finds a file in the output folder, and another of the same name in the "
    "program's folder. Nothing tells that Plastron wrote the first (its `.plastron.json` "
    "is gone, perhaps), so that changes which an earlier run made would be made again. "
    "Remove the first, or load the other by its path.",
    severity=Severity.WARNING,
)

CHANGES_UNDONE = Code(
    "changes-undone",
    "A file that other programs had loaded and changed is made anew, without their "
    "changes, because the program that it came from has changed. Generate the others "
    "again.",
    severity=Severity.WARNING,
)

UNUSED_NOQA = Code(
    "unused-noqa",
    "A comment of a workspace says that what breaks a rule of `plastron lint` in its line is "
    "meant, and nothing there breaks the rule, or there is no such rule. Take the comment away: it "
    "would hide what somebody breaks later.",
    severity=Severity.WARNING,
)
