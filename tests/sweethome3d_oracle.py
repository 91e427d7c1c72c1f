#!/usr/bin/env python3
"""Sweet Home 3D itself reads what we write: every piece must be where we say. Skipped (77) without Java, jar or homes.

Usage: sweethome3d_oracle.py PROGRAM READ_HOME_JAVA WORK_DIR FETCHED_DIR"""
import math
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77


def skip(why: str) -> None:
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def rows(text: str) -> list[list[str]]:
    return [line.split("\t") for line in text.splitlines() if line]


def compare(name: str, ours: list[list[str]], theirs: list[list[str]]) -> int:
    # They list in their own order, and a group's angle passes through floats: match by name and nearest place.
    wrong = abs(len(ours) - len(theirs))
    rest = list(theirs)
    for piece in ours:
        x, y, z, a = map(float, piece[1:])

        def distance(other: list[str]) -> float:
            turn = math.remainder(float(other[4]) - a, 2 * math.pi)
            return math.hypot(float(other[1]) - x, float(other[2]) - y, float(other[3]) - z) + 100 * abs(turn)

        same = [other for other in rest if other[0] == piece[0]]
        best = min(same, key=distance, default=None)
        if best is None or distance(best) > 0.01:
            print(f"{name}: {piece} is not where we say; nearest: {best}")
            wrong += 1
        if best is not None:
            rest.remove(best)
    print(f"{name}: {len(ours)} pieces, {wrong} wrong")
    return wrong


def main(program: str, reader: str, work: str, fetched: str) -> int:
    java = shutil.which("java")
    jars = [pathlib.Path(fetched) / "sweethome3d.jar", pathlib.Path("/usr/share/sweethome3d/sweethome3d.jar"),
            pathlib.Path("/usr/share/java/sweethome3d.jar")]
    jar = next((j for j in jars if j.exists()), None)
    if java is None or shutil.which("javac") is None:
        skip("no Java compiler")
    if jar is None:
        skip("no sweethome3d.jar: run tools/fetch_sweethome3d.sh on build/sweethome3d")
    homes = sorted((pathlib.Path(fetched) / "examples").glob("*.xml"))
    folder = pathlib.Path(work)
    folder.mkdir(parents=True, exist_ok=True)
    wrong = 0
    for source in ["--new", *map(str, homes)]:
        name = pathlib.Path(source).stem
        archive, table = folder / f"{name}.sh3d", folder / f"{name}.tsv"
        subprocess.run([program, source, archive, table], check=True)
        run = subprocess.run([java, "-Djava.awt.headless=true", "-cp", str(jar), reader, str(archive)],
                             capture_output=True, text=True, env={**os.environ, "LC_ALL": "C.UTF-8"})
        if run.returncode != 0:
            print(f"{name}: Sweet Home 3D cannot read it\n{run.stderr[-2000:]}")
            wrong += 1
            continue
        theirs = [row for row in rows(run.stdout) if row[0] != "home"]
        wrong += compare(name, rows(table.read_text()), theirs)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5]))
