#!/usr/bin/env python3
"""What the command line promises: `cli_test.py INHABIT PROMISE`. Exit code 77: skipped, and why."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

INHABIT = sys.argv[1]
HERE = pathlib.Path(__file__).resolve().parent
HOMES = HERE.parent / "build" / "sweethome3d" / "examples"  # tools/fetch_sweethome3d.sh fetches them


def run(*arguments, code=0):
    result = subprocess.run([INHABIT, *map(str, arguments)], capture_output=True, text=True, timeout=100)
    assert result.returncode == code, f"{arguments}: exit {result.returncode}, not {code}\n{result.stdout}{result.stderr}"
    return result


def fails(*arguments):
    """The one line of an error; nothing on standard output."""
    result = run(*arguments, code=2)
    assert result.stdout == "", result.stdout
    assert result.stderr.count("\n") == 1 and result.stderr.startswith("inhabit: "), result.stderr
    return result.stderr


def test_help(folder):
    assert "furnish" in run("--help").stdout
    for verb in ("furnish", "check", "scenes", "render", "convert", "bench"):
        text = run(verb, "--help").stdout
        assert f"inhabit {verb}" in text and "Example" in text, text
    assert run("--version").stdout.startswith("inhabit ")


def test_usage(folder):
    assert 'did you mean "furnish"' in fails("furnsih", "living-room")
    assert 'did you mean "--seed"' in fails("furnish", "living-room", "--sed=3")
    assert 'did you mean "--starts"' in fails("furnish", "living-room", "--start-s", "3")
    fails("furnish")
    fails("furnish", "living-room", "--starts", "0")
    fails("furnish", "living-room", "--seed", "-1")
    fails("furnish", "living-room", "--seed", "x")
    fails("furnish", "living-room", "--scheme", "nonsense")
    fails("check", "living-room", "too", "many")
    fails("bench", "nonsense")


def test_errors(folder):
    assert 'did you mean "picnic"' in fails("furnish", "picnik")
    bad = folder / "bad.json"
    bad.write_text('{"format": "inhabit-scene", "version": 1, "space": {"outline": [[0, 0], [4, 0]]}}')
    assert f"{bad}: /space/outline" in fails("check", bad)
    bad.write_text('{"format": "inhabit-scene", ')
    assert "line" in fails("furnish", bad)
    fails("furnish", folder)
    fails("check", folder / "nothing.json")
    fails("convert", "living-room", folder / "room.docx")
    fails("render", "living-room", "-o", folder / "room.txt")
    fails("furnish", "living-room", "--svg", folder / "room.png")
    fails("furnish", "living-room", "--room", "Kitchen")
    assert "--line is for ProcTHOR" in fails("check", "living-room", "--line", 2)
    assert "--assets is for ProcTHOR" in fails("furnish", "living-room", "--assets", folder / "nothing.json")
    fails("furnish", "living-room", "-o", folder / "no" / "such" / "folder.json", "--quiet")


def test_scenes(folder):
    listed = json.loads(run("scenes", "--json").stdout)["rows"]
    assert len(listed) == 17
    assert {"theater-1", "picnic", "tight-bedroom"} <= {row["name"] for row in listed}
    scene = json.loads(run("scenes", "desk").stdout)
    assert len(scene["objects"]) == 21
    assert len(json.loads(run("scenes", "theater-1", "--seats", 50).stdout)["objects"]) == 51
    fails("scenes", "theatre")
    fails("scenes", "desk", "--seats", 50)


def test_furnish(folder):
    out = folder / "room.json"
    text = run("furnish", "living-room", "-o", out).stdout
    assert "feasible" in text, text
    scene = json.loads(out.read_text())
    assert all("position" in item for item in scene["objects"])
    run("check", out)
    assert run("furnish", "living-room", "--quiet").stdout == ""


def test_check(folder):
    scene = json.loads(run("scenes", "desk").stdout)
    run("furnish", "living-room", "-o", folder / "room.json", "--quiet")
    report = json.loads(run("check", folder / "room.json", "--json").stdout)
    assert report["feasible"] is True
    for key in ("overlaps", "outside", "blocked_doors", "clearances", "reachable", "walkable_share", "views", "constraints", "energy"):
        assert key in report, key
    for item in scene["objects"]:
        item["position"] = [0.4, 0.4, 0]
    heap = folder / "heap.json"
    heap.write_text(json.dumps(scene))
    report = json.loads(run("check", heap, "--json", code=1).stdout)
    assert report["feasible"] is False and report["overlaps"]
    assert run("check", heap, code=1).stdout
    run("check", heap, "--json", "--metrics", "published", code=1)


def test_json(folder):
    answer = json.loads(run("furnish", "tight-bedroom", "--json", "--seed", 3).stdout)
    suggestion = answer["rooms"][0]["suggestions"][0]
    assert len(suggestion["scene"]["objects"]) == 12 and "check" in suggestion
    answer = json.loads(run("furnish", "living-room", "--json", "-o", folder / "room.json").stdout)
    assert "scene" not in answer["rooms"][0]["suggestions"][0]


def test_contradiction(folder):
    """What cannot all be kept is a report and exit code 1; what cannot be placed is an error, from every format."""
    room = {"outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}
    things = [{"id": name, "kind": "table", "size": [0.6, 0.6, 0.7]} for name in "ab"]
    apart = [{"type": "distance", "between": ["a", "b"], "distance": far} for far in (1, 2)]
    scene = folder / "scene.json"
    scene.write_text(json.dumps({"format": "inhabit-scene", "version": 1, "space": room, "objects": things, "constraints": apart}))
    assert "distance a" in run("furnish", scene, "-o", folder / "out.json", code=1).stdout
    run("check", folder / "out.json", "-q", code=1)
    home = folder / "home.xml"
    corners = "".join(f"<point x='{x}' y='{y}'/>" for x, y in ((0, 0), (300, 0), (300, 300), (0, 300)))
    piece = "<pieceOfFurniture name='sofa' x='150' y='150' width='500' depth='90' height='80'/>"
    home.write_text(f"<home><room name='A'>{corners}</room>{piece}</home>")
    assert "larger than the room" in fails("furnish", home)
    home.write_text("<home name='&big;'></home>")
    assert "entity" in fails("check", home)


def test_outputs(folder):
    """A failure leaves what was there."""
    kept = folder / "kept.json"
    kept.write_text("mine")
    fails("convert", folder / "nothing.json", kept)
    bad = folder / "bad.json"
    bad.write_text("{")
    fails("furnish", bad, "-o", kept)
    # One output that cannot be written is told before anything is.
    fails("furnish", "living-room", "-o", kept, "--png", folder / "none" / "room.png")
    assert kept.read_text() == "mine"
    run("scenes", "desk", "-o", kept)
    assert json.loads(kept.read_text())["name"] == "desk"
    assert sorted(p.name for p in folder.iterdir()) == ["bad.json", "kept.json"]


def test_variants(folder):
    run("furnish", "tight-bedroom", "--variants", 3, "-o", folder / "v.json", "--svg", folder / "v.svg", "--png", folder / "v.png")
    names = {p.name for p in folder.iterdir()}
    assert {"v-1.json", "v-2.json", "v-3.json", "v.svg", "v.png"} <= names, names
    assert (folder / "v.png").read_bytes().startswith(b"\x89PNG")
    assert len({(folder / f"v-{k}.json").read_text() for k in (1, 2, 3)}) == 3


def test_trace(folder):
    csv = folder / "energy.csv"
    run("furnish", "living-room", "--trace", csv, "--starts", 2, "--quiet")
    lines = csv.read_text().splitlines()
    assert lines[0] == "start,iteration,energy,overlap,feasible,relocated" and len(lines) > 10
    assert {line.split(",")[0] for line in lines[1:]} == {"0", "1"}
    assert (folder / "energy.csv.svg").exists() and (folder / "energy.csv.png").exists()


def test_deterministic(folder):
    for threads in (1, 2, 8):
        run("furnish", "tight-bedroom", "--seed", 7, "--threads", threads, "-o", folder / f"{threads}.json", "--quiet")
    assert len({(folder / f"{threads}.json").read_bytes() for threads in (1, 2, 8)}) == 1


def test_convert(folder):
    run("furnish", "bedroom", "-o", folder / "a.json", "--quiet")
    run("convert", folder / "a.json", folder / "b.json")
    assert (folder / "a.json").read_bytes() == (folder / "b.json").read_bytes()
    run("convert", folder / "a.json", folder / "a.sh3d", "--quiet")
    assert (folder / "a.sh3d").read_bytes().startswith(b"PK")
    (folder / "hall.wkt").write_text("POLYGON ((0 0, 5 0, 5 4, 0 4, 0 0))")
    run("convert", folder / "hall.wkt", folder / "hall.json")
    assert len(json.loads((folder / "hall.json").read_text())["space"]["outline"]) == 4


def test_rooms(folder):
    """Several rooms do not fit where there is place for one; the error names them."""
    home = folder / "home.xml"
    corners = ["".join(f"<point x='{x + k * 400}' y='{y}'/>" for x, y in ((0, 0), (300, 0), (300, 300), (0, 300))) for k in (0, 1)]
    home.write_text(f"<home><room name='Hall'>{corners[0]}</room><room name='Bath'>{corners[1]}</room></home>")
    for verb in (["convert", home, folder / "out.json"], ["furnish", home, "-o", folder / "out.json"]):
        assert "choose one with --room: Hall, Bath" in fails(*verb)
    run("convert", home, folder / "out.json", "--room", "Bath")
    assert json.loads((folder / "out.json").read_text())["name"] == "Bath"


def test_house_rules(folder):
    """What nobody asked for may be missed, where it is furnished and where its file is checked."""
    room = {"outline": [[0, 0], [4, 0], [4, 4], [0, 4]]}
    # Every wall is taken: the wardrobe cannot stand at one.
    shelves = [{"id": f"shelf-{k}", "kind": "bookcase", "size": [3.3, 0.3, 2], "position": [x, y, 0], "angle": angle, "fixed": True}
               for k, (x, y, angle) in enumerate(((2, 0.15, 90), (3.85, 2, 180), (2, 3.85, -90), (0.15, 2, 0)))]
    things = [*shelves, {"id": "closet", "kind": "wardrobe", "size": [1.5, 0.6, 2]}]
    scene, out = folder / "scene.json", folder / "out.json"
    scene.write_text(json.dumps({"format": "inhabit-scene", "version": 1, "space": room, "objects": things}))
    assert "house rules, which may be missed" in run("furnish", scene, "--house-rules", "-o", out).stdout
    written = json.loads(out.read_text())
    assert written["house_rules"] is True and written["constraints"]
    assert "house rules, which may be missed" in run("check", out).stdout
    run("furnish", out, "-q")
    del written["house_rules"]
    out.write_text(json.dumps(written))
    run("check", out, "-q", code=1)


def test_render(folder):
    run("furnish", "living-room", "-o", folder / "a.json", "--quiet")
    for name, start in (("a.svg", b"<?xml"), ("a.png", b"\x89PNG"), ("a.pdf", b"%PDF")):
        run("render", folder / "a.json", "-o", folder / name, "--problems", "--clearances")
        assert (folder / name).read_bytes().startswith(start) or b"<svg" in (folder / name).read_bytes()[:200]


def test_homes(folder):
    homes = sorted(HOMES.glob("*.xml"))
    if not homes:
        print(f"skipped: no homes in {HOMES}; tools/fetch_sweethome3d.sh build/sweethome3d fetches them")
        sys.exit(77)
    report = json.loads(subprocess.run([INHABIT, "check", homes[0], "--json"], capture_output=True, text=True).stdout)
    assert len(report["rooms"]) > 1
    result = subprocess.run([INHABIT, "furnish", homes[0], "--start", "placed", "--house-rules", "-o", folder / "home.sh3d"],
                            capture_output=True, text=True)
    assert result.returncode in (0, 1), result.stderr
    assert (folder / "home.sh3d").read_bytes().startswith(b"PK")
    assert "--room" in fails("convert", homes[0], folder / "home.json", "--quiet")


def test_interrupt(folder):
    """Ctrl-C stops the work and still writes the best so far."""
    out = folder / "theatre.json"
    process = subprocess.Popen([INHABIT, "furnish", "tight-picnic", "--starts", "100000", "-o", str(out)],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    text, complaint = process.communicate(timeout=60)
    assert process.returncode in (0, 1), complaint
    assert "interrupted" in text, text
    assert all("position" in item for item in json.loads(out.read_text())["objects"])


def test_bench(folder):
    answer = json.loads(run("bench", "interactive", "tight", "--seeds", 1, "--json", "--plots", folder).stdout)
    assert [table["id"] for table in answer["tables"]] == ["machine", "interactive", "tight"]
    assert (folder / "tight.svg").exists()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        globals()["test_" + sys.argv[2]](pathlib.Path(place))
