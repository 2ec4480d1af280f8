"""`python -m proofs [--full] [--json]`: what is proved, refuted and open, a line a statement."""

from __future__ import annotations

import argparse
import json
from collections import Counter

from proofs.registry import statements


def main() -> int:
    """Print every statement; a traceback where a proof fails."""
    parser = argparse.ArgumentParser(prog="python -m proofs", description=main.__doc__)
    parser.add_argument("--full", action="store_true", help="larger enumerations as well")
    parser.add_argument("--json", action="store_true", help="a JSON object a line")
    options = parser.parse_args()
    count: Counter[str] = Counter()
    for found in statements(options.full):
        count[found.status] += 1
        if options.json:
            print(json.dumps(found.to_json()), flush=True)
        else:
            print(
                f"{found.status:8} {found.place}: {found.text}  [{found.method}: {found.evidence}]",
                flush=True,
            )
    if not options.json:
        print(", ".join(f"{count[status]} {status}" for status in ("proved", "refuted", "open")))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
