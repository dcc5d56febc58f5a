"""`plastron trust`."""

from __future__ import annotations

from pathlib import Path

import click

from plastron_tui.boundary import find_boundary
from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.diagnostics.terminal import visible
from plastron_tui.trust import TrustStore, TrustStoreError, UnsafeStoreError, real_path

from .common import Report, finish, print_text


@click.command(epilog="Example: plastron trust ~/robots/rover")
@click.argument("folder", required=False, metavar="[DIR]", type=click.Path(path_type=Path))
@click.option("--remove", is_flag=True, help="Trust it no longer.")
@click.option("--list", "is_list", is_flag=True, help="List the folders that you trust.")
def command(folder: Path | None, remove: bool, is_list: bool) -> None:
    """Trust the project of a folder, without DIR that of the working folder.

    Its templates are then used, and its programs and its plastron.yaml may lead out of it. Look at
    them first. What you trust is remembered among your own files, never in the folder.
    """
    if is_list and (remove or folder is not None):
        raise click.UsageError("--list goes alone")
    report = Report()
    store = TrustStore()
    try:
        if is_list:
            _list(store, report)
        elif remove:
            _remove(store, folder or Path.cwd(), report)
        else:
            _add(store, folder, report)
    except TrustStoreError as error:
        is_unsafe = isinstance(error, UnsafeStoreError)
        remedy = "remove it, and trust your folders again" if is_unsafe else None
        report.unreadable([_unsafe(str(error), remedy)])
    finish(report)


def _list(store: TrustStore, report: Report) -> None:
    folders = store.folders()
    for folder in folders:
        print_text(str(folder))
    if not folders:
        click.echo("you trust no folder yet", err=True)
    for file in store.broken():
        found = _unsafe(f"`{file}` is broken, or not yours alone", f"remove it: {file}")
        report.add([found._replace(severity=Severity.WARNING)], lambda _: None)


def _add(store: TrustStore, folder: Path | None, report: Report) -> None:
    place = folder or Path.cwd()
    shown = visible(str(place))
    if not place.is_dir():
        raise click.BadParameter(f"there is no folder '{shown}'", param_hint="'[DIR]'")
    boundary = find_boundary(place)
    if boundary.is_home_or_above and folder is None:
        raise click.UsageError(f"'{shown}' is no project of its own; name it if you mean it")
    store.add(boundary.root)
    print_text(f"trusted  {boundary.root}")


def _remove(store: TrustStore, folder: Path, report: Report) -> None:
    """Forget a folder, which may be gone, or the project that it is in."""
    for path in dict.fromkeys((real_path(folder), find_boundary(folder).root)):
        if store.remove(path):
            print_text(f"no longer trusted  {path}")
            return
    report.status = 1
    click.echo("nothing to remove: the folder is not trusted", err=True)


def _unsafe(message: str, remedy: str | None) -> Diagnostic:
    return Diagnostic(codes.UNSAFE_TRUST_STORE, message, help=remedy)
