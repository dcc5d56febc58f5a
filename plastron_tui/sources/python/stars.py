"""Which package a type is of that `from package.msg import *` brings in."""

from __future__ import annotations

from plastron_tui.ros.catalog.data import index
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName


def star_interface(bare: str, modules: list[str], distribution: str) -> InterfaceName | None:
    """Return the interface that a bare name means, None where several star imports may have it.

    The packages that the catalog knows settle it; a package that it does not know is meant
    where no other can be.
    """
    packages: dict[tuple[str, InterfaceKind], None] = {}
    for module in modules:
        package, dot, kind = module.partition(".")
        if dot and kind in ("msg", "srv", "action"):
            packages[package, InterfaceKind(kind)] = None
    if len(packages) == 1:
        ((package, _),) = packages
        return InterfaceName(package, bare)
    if not packages:
        return None
    known = index(distribution)
    having = {
        InterfaceName(package, bare)
        for package, kind in packages
        if InterfaceName(package, bare) in known.names[kind]
    }
    if not having:
        having = {InterfaceName(package, bare) for package, _ in packages.keys() - known.packages}
    return having.pop() if len(having) == 1 else None


def is_starred(name: str, modules: list[str], distribution: str) -> bool:
    """Whether a star import of interface types is known to bring in a name."""
    # A service's module has its request and response classes as well.
    bases = {name, name.removesuffix("Request"), name.removesuffix("Response")}
    found = (star_interface(each, modules, distribution) for each in bases)
    names = index(distribution).names
    return any(each in names[kind] for each in found if each is not None for kind in InterfaceKind)
