from __future__ import annotations

import sys
from importlib import import_module

from plastron_tui import collector

_PARTS = (
    *("language", "process", "output", "source", "cpp_source", "editor", "studio"),
    *("robots", "graphs", "collector", "threads", "memory", "rates", "live"),
    *("pasting", "beside", "flood", "lint"),
)


def main() -> int:
    """Measure everything, or the parts that were named; 1 when a bound does not hold."""
    # As in the processes that are measured.
    collector.look_seldom()
    failed = False
    print(f"{'':4} {'measured':>9} {'bound':>7}  what")
    for part in sys.argv[1:] or _PARTS:
        for row in import_module(f"benchmarks.{part}").rows():
            failed |= not row.holds
            print(
                f"{'ok' if row.holds else 'OVER':4} {row.value:>7.2f}{row.unit:<2} "
                f"{row.bound:>5g}{row.unit:<2}  {row.name}"
                + (f"  ({row.detail})" if row.detail else ""),
                flush=True,
            )
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
