#!/usr/bin/env python3
"""Runs every example of the documentation as written: `run_examples.py INHABIT ROOT`.

In README.md, lines of ```sh blocks that begin with "inhabit " run one after the other in one empty folder. In docs/scene.md,
every ```json block is a scene that must read, furnish and come out feasible."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def blocks(path: pathlib.Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", path.read_text(), re.MULTILINE | re.DOTALL)


def run(command: str, folder: str, environment: dict[str, str]) -> bool:
    done = subprocess.run(command, shell=True, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        print(f"exit {done.returncode}: {command}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.returncode == 0


def main(inhabit: pathlib.Path, root: pathlib.Path) -> int:
    environment = {**os.environ, "PATH": f"{inhabit.resolve().parent}:{os.environ['PATH']}"}
    count = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        commands = [line.split("  #")[0] for block in blocks(root / "README.md", "sh") for line in block.splitlines()]
        for number, scene in enumerate(blocks(root / "docs" / "scene.md", "json"), 1):
            pathlib.Path(folder, f"scene-{number}.json").write_text(scene)
            commands.append(f"inhabit furnish scene-{number}.json -q -o scene-{number}-done.json")
        for command in commands:
            if command.startswith("inhabit "):
                count += 1
                failed += not run(command, folder, environment)
    print(f"{count} examples, {failed} failed")
    return 1 if failed or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
