#!/usr/bin/env python3
"""What `inhabit study` promises: `study_test.py INHABIT PROMISE`. Exit code 77: skipped, and why."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

from cli_test import fails, run, write

HERE = pathlib.Path(__file__).resolve().parent
COUNTS = HERE.parent / "docs" / "yu11-counts.csv"


def plan_of(folder):
    """A room as its designer left it and two others, by the names of built-in scenes."""
    return write(folder / "study.json", json.dumps({"title": "Bedrooms", "scenes": [
        {"name": "bedroom", "human": "exemplar/bedroom-1", "syntheses": {"A1": "exemplar/bedroom-2", "A2": "exemplar/bedroom-3"}},
        {"name": "gallery", "human": "exemplar/gallery-1", "syntheses": {"A1": "exemplar/gallery-2"}}]}))


def test_make(folder):
    """Pictures and scenes become one page; a page that is wrong is not written."""
    page = folder / "study.html"
    assert "3 pairs" in run("study", "make", plan_of(folder), "-o", page).stdout
    text = page.read_text()
    assert text.startswith("<!DOCTYPE html>") and "http" not in text.replace("http-equiv", "")
    before = page.read_bytes()
    png = folder / "plan.png"
    run("render", "exemplar/bedroom-1", "-o", png, "--pixels", 200)
    one = folder / "one.html"
    run("study", "make", "--human", png, "--synthesis", "exemplar/bedroom-2", "--synthesis", "mine=exemplar/bedroom-3", "-o", one)
    assert '"synthesis":"A1"' in one.read_text() and '"synthesis":"mine"' in one.read_text() and "data:image/png" in one.read_text()
    assert run("study", "make", plan_of(folder), "-o", page, "-q").stdout == "" and page.read_bytes() == before
    assert "PLAN" in fails("study", "make", "-o", page)
    assert "PLAN" in fails("study", "make", plan_of(folder), "--human", png, "-o", page)
    assert "looks the same" in fails("study", "make", "--human", png, "--synthesis", png, "-o", page)
    assert "nowhere.png" in fails("study", "make", "--human", "nowhere.png", "--synthesis", png, "-o", page)
    assert "no place" in fails("study", "make", "--human", png, "--synthesis", "learned-bedroom", "-o", page)
    bad = write(folder / "bad.json", '{"scenes": [{"name": "a", "human": "x.png", "synthese": {}}]}')
    assert f"{bad}: /scenes/0/synthese" in fails("study", "make", bad, "-o", page)
    fake = write(folder / "fake.png", "no picture")
    assert "is no PNG" in fails("study", "make", "--human", fake, "--synthesis", png, "-o", page)
    assert 'did you mean "--human"' in fails("study", "make", "--humann", png, "-o", page)
    assert "inhabit study make --help" in fails("study", "make", png)
    assert 'did you mean "make"' in fails("study", "mak")
    fails("study")
    assert page.read_bytes() == before


def test_page(folder):
    """The page, clicked through by node; its file is analysed."""
    node = shutil.which("node")
    if node is None:
        print("skipped: no node")
        sys.exit(77)
    page = folder / "study.html"
    run("study", "make", plan_of(folder), "-o", page)
    done = subprocess.run([node, HERE / "study_page_test.js", page], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    answers = write(folder / "answers.json", done.stdout)
    table = json.loads(run("study", "analyse", answers, "--json").stdout)["tables"]
    # One chose the human design always, one the left side always: 6 and 3 of 6.
    assert table[0]["rows"][0] == {"participants": 2, "answers": 12, "chose left": 9, "p of a coin": 598 / 4096,
                                   "pairs seen twice": 6, "answered alike": 3, "median seconds": 1.5}, table[0]
    assert [(row["scene"], row["synthesis"], row["human"], row["of"]) for row in table[1]["rows"]] == [
        ("bedroom", "A1", 3, 4), ("bedroom", "A2", 3, 4), ("gallery", "A1", 3, 4)]
    assert table[1]["rows"][0]["chi2"] == 1 and table[1]["rows"][0]["odds"] == 1.25


def test_analyse(folder):
    """Counts become tables, JSON, and CSV that reads again; faults have their place."""
    text = run("study", "analyse", COUNTS, "--paper").stdout
    assert "5.506" in text and "1.210" in text and "human preferred" in text
    csv = folder / "rows.csv"
    proper = json.loads(run("study", "analyse", COUNTS, "--json", "--csv", csv).stdout)
    assert [table["id"] for table in proper["tables"]] == ["pairs", "chi2", "odds"]
    assert proper["tables"][0]["rows"][3]["chi2"] == 11.52  # 37 of 50
    assert json.loads(run("study", "analyse", csv, "--json").stdout) == proper
    # The same counts twice are twice as many.
    assert json.loads(run("study", "analyse", csv, csv, "--json").stdout)["tables"][0]["rows"][0]["of"] == 100
    bad = write(folder / "bad.csv", "scene,synthesis,human,of\na,A1,5,3\n")
    assert f"{bad}: line 2: chosen 5 times of 3" in fails("study", "analyse", bad)
    bad.write_text('{"participants": [{"id": "1", "answers": [{"scene": "a"}]}]}')
    assert f"{bad}: /participants/0/answers/0" in fails("study", "analyse", bad)
    assert "plan" in fails("study", "analyse", plan_of(folder))
    assert "nowhere" in fails("study", "analyse", folder / "nowhere.json")
    fails("study", "analyse")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        globals()["test_" + sys.argv[2]](pathlib.Path(place))
