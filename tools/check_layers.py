#!/usr/bin/env python3
"""Fails when a folder includes a folder that it must not know. The table is the law: change it here, and say why."""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "core": [],
    "geometry": ["core"],
    "pbd": ["core", "geometry"],
    "scene": ["core", "geometry"],
    "layout": ["core", "geometry", "pbd", "scene"],
    "crowd": ["core", "geometry", "pbd", "scene"],
    "exemplar": ["core", "geometry", "scene"],
    "annealing": ["core", "geometry", "scene"],
    "io": ["core", "geometry", "scene", "layout"],
    "render": ["core", "geometry", "scene", "layout", "crowd"],
    "session": ["core", "geometry", "scene", "layout", "crowd", "exemplar", "annealing", "io", "render"],
    "app": ["core", "session"],
    "fuzz": ["core", "scene", "io"],
    # A leaf: tests of several layers together. Nobody includes it.
    "tests": ["core", "geometry", "pbd", "scene", "layout", "crowd", "exemplar", "annealing", "io", "render", "session"],
}
# Includes that exist in spite of the table: "file -> folder". May only shrink.
DEBT: set[str] = set()


def main(root: pathlib.Path) -> int:
    wrong = []
    for folder, allowed in MAY_INCLUDE.items():
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = re.match(r'\s*#include "([^/"]+)/', line)
                if not match or match[1] == folder or match[1] in allowed:
                    continue
                name = f"{path.relative_to(root)} -> {match[1]}"
                if name not in DEBT:
                    wrong.append(f"{path.relative_to(root)}:{number}: {folder}/ must not include {match[1]}/")
    print("\n".join(wrong) if wrong else f"layers: {len(MAY_INCLUDE)} folders, no upward include")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
