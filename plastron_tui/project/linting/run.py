"""A run of the linter over folders, as a front end wants it."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from plastron_tui.boundary import Boundary, find_boundary
from plastron_tui.diagnostics import Diagnostic, LineIndex, Severity, codes, did_you_mean
from plastron_tui.lint import Found, Rule, lint
from plastron_tui.lint.baseline import LARGEST, baseline_text, only_new, read_baseline
from plastron_tui.lint.engine import in_order
from plastron_tui.lint.programs import ProgramFacts, ReadProgram, unwritten
from plastron_tui.lint.rule import RULES, rule_of
from plastron_tui.lint.selection import Selection, matches, path_from, unknown_words
from plastron_tui.lint.tree import SourceTree
from plastron_tui.project.settings import TRUST_CODES, Project, find_project
from plastron_tui.regular_files import read_named, reason
from plastron_tui.targets import LIBRARIES

from .cache import FactCache
from .comments import FileTexts
from .fingerprints import Digest, Reads, digest, noted
from .found_before import FoundBefore
from .listing import Listing, common_folder, list_files
from .reading import Progress, read_tree


class LintOptions(NamedTuple):
    """What the command line says of a run.

    Attributes:
        paths: the folders and files that are looked at.
        selection: what it says of rules.
        baseline: the file with what was found before, None for that of the project file.
        exclude: patterns of paths that are not looked at.
        workers: how many processes read, None for one a core.
        cache: what was read before, None for the user's.
        read_program: reads a program, None to leave programs out.
        against: the revision of git that types are compared with, "" for none.
        progress: is told how many files of nodes are read, and of how many.
    """

    paths: tuple[Path, ...]
    selection: Selection = Selection()
    baseline: Path | None = None
    exclude: tuple[str, ...] = ()
    workers: int | None = None
    cache: FactCache | None = None
    read_program: ReadProgram | None = None
    against: str = ""
    progress: Progress | None = None


class LintRun:
    """Reads folders when it is first asked what is wrong in them.

    Attributes:
        options: what the command line says.
        diagnostics: what is wrong with what the linter itself was given.
    """

    def __init__(self, options: LintOptions) -> None:
        """Set what is read, and which rules are followed."""
        import plastron_tui.lint.rules  # noqa: F401 - declares them

        self.options = options
        self.diagnostics: list[Diagnostic] = []
        self._held: Mapping[str, Digest | None] = {}
        self._files = FileTexts()

    def again(self) -> LintRun:
        """Return a run over the files as they are now."""
        return LintRun(self.options)

    def unselected(self) -> LintRun:
        """Return a run that follows the rules that are followed where none is selected."""
        if not self.selection.select:
            return self
        run = self.again()
        run.selection = self.selection._replace(select=())
        return run

    @cached_property
    def paths(self) -> tuple[Path, ...]:
        """The folders and files that are looked at, whole and without links."""
        return tuple(Path(os.path.realpath(each)) for each in self.options.paths)

    @cached_property
    def _boundary(self) -> Boundary:
        return find_boundary(common_folder(self.paths))

    @cached_property
    def project(self) -> Project:
        """What the project file around the folders says."""
        project, problems = find_project(self._boundary, LIBRARIES)
        # Nothing of the project is used that would have to be trusted: what is not read is missing.
        self.diagnostics += (
            each._replace(severity=Severity.WARNING) if each.code in TRUST_CODES else each
            for each in problems
        )
        for word in unknown_words(project.lint.places):
            span = project.lint.places[word]
            message = f"no rule is called `{word}`"
            remedy = did_you_mean(word, [*RULES, *(each.name for each in RULES.values())])
            self.diagnostics.append(
                Diagnostic(codes.BAD_PROJECT, message, span, project.file, remedy)
            )
        return project

    @cached_property
    def selection(self) -> Selection:
        """Which rules are followed: the command line's word goes before the project file's.

        What it selects takes the place of all that the file says of rules, and what it ignores is
        not followed, however exactly the file selects it.
        """
        given, set_ = self.options.selection, self.project.lint
        per_file = {**set_.per_file, **given.per_file}
        if given.select:
            return given._replace(per_file=per_file)
        return Selection(set_.select, set_.ignore, per_file, given.ignore)

    @cached_property
    def root(self) -> Path:
        """The folder that paths are told from: the project's, else the one that is looked at."""
        file = self.project.file
        if file is not None:
            return file.parent
        is_above = self._boundary.is_home_or_above
        return common_folder(self.paths) if is_above else self._boundary.root

    @cached_property
    def tree(self) -> SourceTree:
        """What was read, with the nodes of programs that are written nowhere."""
        tree, against = self._files_read, self.options.against
        for path, why in tree.problems:
            message = f"`{path.name}` is not read: {why}"
            self.diagnostics.append(Diagnostic(codes.UNREADABLE_FILE, message, file=path))
        if self._programs:
            made = unwritten(self._programs, tree.units, tree.packages.values())
            tree = replace(tree, units=(*tree.units, *made))
        if not against:
            return tree
        from .earlier import read_earlier

        earlier = read_earlier(tree, against)
        if isinstance(earlier, Diagnostic):
            self.diagnostics.append(earlier)
            return tree
        return replace(tree, earlier=earlier)

    @cached_property
    def _programs(self) -> tuple[ProgramFacts, ...]:
        """What programs say."""
        read = self.options.read_program
        paths = (Path(each) for each in self._files_read.files if each.endswith(".plastron"))
        if read is None:
            return ()
        return tuple(read(each, text) for each in paths if (text := self.text(each)) is not None)

    @cached_property
    def _files_read(self) -> SourceTree:
        options = self.options
        return read_tree(self.paths, self._cache, options.workers, self._listing, options.progress)

    @cached_property
    def _cache(self) -> FactCache:
        given = self.options.cache
        return FactCache(common_folder(self.paths), None, self.paths) if given is None else given

    @cached_property
    def _listing(self) -> Listing:
        patterns = (*self.options.exclude, *self.project.lint.exclude)
        if not patterns:
            return list_files(self.paths)
        root = self.root

        def is_excluded(path: str) -> bool:
            name = path_from(root, Path(path))
            return any(matches(name, pattern) for pattern in patterns)

        return list_files(self.paths, is_excluded)

    @property
    def has_nothing(self) -> bool:
        """Whether there is nothing that a rule looks at."""
        if self._listing.packages or any(x.endswith(".plastron") for x in self._listing.files):
            return False
        return not (self.tree.units or self.tree.launches or self.tree.problems)

    @cached_property
    def rules(self) -> tuple[Rule, ...]:
        """The rules that are followed."""
        return self.selection.rules()

    @cached_property
    def found(self) -> tuple[Found, ...]:
        """What is found, without what comments or the settings say is meant."""
        has_programs = any(each.endswith(".plastron") for each in self._listing.files)
        if has_programs or self.options.against:
            # What a program loads, and what git has, is not told by the files that are here.
            found = self._find()
            self._held = self._cache.needs()
            return found
        said = repr((self.selection, [rule.code for rule in self.rules], str(self.root)))
        before = FoundBefore(self._cache, self._listing, said)
        known = before.get()
        self._held = before.needs()
        if known is None:
            told = len(self.diagnostics)
            reads = Reads({}, {})
            with noted(reads):
                known = self._find()
            self._held = self._cache.needs()
            if self.tree.is_whole and len(self.diagnostics) == told:
                before.keep(known, reads)
        return known

    def _find(self) -> tuple[Found, ...]:
        tree = replace(self.tree, asked=self.selection.asked())
        found = [*lint(tree, self.rules), *self._mistakes(tree)]
        found = [each for each in found if not self._is_meant(each)]
        if self.selection.tells(rule_of(codes.UNUSED_NOQA)):
            unused = self._files.unused(self.tree.commented, self.rules)
            found += [each for each in unused if not self._is_meant(each)]
        return in_order(found)

    @cached_property
    def told(self) -> tuple[Found, ...]:
        """What is found and not in the baseline; one that cannot be read has nothing."""
        baseline = self.options.baseline or self.project.lint.baseline
        if baseline is None:
            return self.found
        try:
            known = read_baseline(read_named(baseline, LARGEST))
        except (OSError, ValueError) as error:
            message = f"the baseline cannot be read: {reason(error)}"
            self.diagnostics.append(Diagnostic(codes.UNREADABLE_FILE, message, file=baseline))
            return self.found
        return tuple(only_new(self.found, known, self.root, self.lines))

    def baseline_text(self) -> str:
        """Return the text of a baseline that has all of what is found."""
        return baseline_text(self.found, self.root, self.lines)

    def text(self, file: Path) -> bytes | None:
        """Return what a file holds, None where it cannot be read."""
        return self._files.text(file)

    def is_changed(self, file: Path) -> bool:
        """Tell whether somebody has changed a file after it was read for what is found in it."""
        known, text = self._held.get(os.fspath(file)), self.text(file)
        return known is not None and (text is None or digest(text) != known)

    def lines(self, file: Path | None) -> LineIndex | None:
        """Return the lines of a file, None where it cannot be read."""
        return self._files.lines(file)

    def _mistakes(self, tree: SourceTree) -> Iterator[Found]:
        """Yield what is wrong with programs, as `check` tells it, and with each package.xml."""
        of_programs = (program.diagnostics for program in self._programs)
        for each in dict.fromkeys(chain(tree.wrong, *of_programs)):
            rule = rule_of(each.code)
            if each.severity is not Severity.NOTE and self.selection.tells(rule):
                yield Found(rule, each)

    def _is_meant(self, found: Found) -> bool:
        file = found.diagnostic.file
        if file is not None and self.selection.is_ignored(found.rule, file, self.root):
            return True
        return self._files.is_meant(found)
