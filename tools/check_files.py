#!/usr/bin/env python3
"""Fails when a source file is longer than a person reads in one go, ends without a newline, or has blanks at line ends."""
import pathlib
import sys

LONGEST = 500
FOLDERS = ["core", "geometry", "pbd", "scene", "layout", "io", "render", "session", "app", "fuzz", "tests", "tools", "cmake"]
SUFFIXES = {".h", ".cpp", ".py", ".sh", ".cmake", ".txt", ".java"}


def main(root: pathlib.Path) -> int:
    wrong = []
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SUFFIXES or not path.is_file():
                continue
            name = path.relative_to(root).as_posix()
            text = path.read_text()
            lines = text.splitlines()
            if len(lines) > LONGEST:
                wrong.append(f"{name}: {len(lines)} lines; split it by meaning, at most {LONGEST}")
            if text and not text.endswith("\n"):
                wrong.append(f"{name}: no newline at the end")
            wrong += [f"{name}:{n}: blanks at the end of the line" for n, line in enumerate(lines, 1) if line != line.rstrip()]
    print("\n".join(wrong) if wrong else "files: none too long")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
