#!/usr/bin/env python3
"""What the command line promises: `cli_test.py INHABIT PROMISE`. Exit code 77: skipped, and why."""
import json
import os
import pathlib
import shutil
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


def write(path, text):
    path.write_text(text)
    return path


def fails(*arguments):
    """The one line of an error; nothing on standard output."""
    result = run(*arguments, code=2)
    assert result.stdout == "", result.stdout
    assert result.stderr.count("\n") == 1 and result.stderr.startswith("inhabit: "), result.stderr
    return result.stderr


def test_help(folder):
    assert "furnish" in run("--help").stdout
    for verb in ("furnish", "check", "learn", "simulate", "scenes", "render", "convert", "measure", "study", "bench"):
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
    assert len(listed) == len(list((HERE.parent / "scenes").glob("*.json")))
    assert {"theater-1", "picnic", "tight-bedroom"} <= {row["name"] for row in listed}
    assert {row["name"]: row["people"] for row in listed}["bears-and-rabbits"] == 1152
    assert all(row["what"] for row in listed)
    scene = json.loads(run("scenes", "desk").stdout)
    assert len(scene["objects"]) == 21
    assert len(json.loads(run("scenes", "theater-1", "--seats", 50).stdout)["objects"]) == 51
    assert json.loads(run("scenes", "rimea-06").stdout)["crowd"]["populations"][0]["count"] == 20
    assert 'did you mean "rimea-10"' in fails("scenes", "rimea-13")
    fails("scenes", "theatre")
    fails("scenes", "rimea-06", "--seats", 50)
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


def test_learn(folder):
    """Five rooms become a priors file that reads back, pictures, and errors that say where."""
    priors, page, cards = folder / "bed.priors.json", folder / "bed.svg", folder / "cards"
    told = run("learn", "exemplar/bedroom", "-o", priors, "--pair", "tv,armchair", "--pair", "desk,work-chair", "--explain", page).stdout
    assert "120 things" in told and "named" in told, told
    learned = json.loads(priors.read_text())
    assert learned["format"] == "inhabit-priors" and len(learned["rooms"]) == 5
    assert {"tv", "armchair"} <= {kind["kind"] for kind in learned["kinds"]}
    assert any(pair["first"] == "desk" and pair["second"] == "work chair" and pair["count"] == 5 for pair in learned["pairs"])
    assert page.read_text().startswith("<?xml") or "<svg" in page.read_text()
    run("learn", "exemplar/gallery", "--pair", "chair,chair", "--explain", str(cards) + "/", "-q")
    assert (cards / "kind-painting.png").exists() and (cards / "pair-chair-chair.png").exists()
    answer = json.loads(run("learn", "exemplar/bedroom-1", "--json").stdout)
    assert any("one room alone" in note for note in answer["notes"]) and answer["priors"]["kinds"]
    # What a person wrote stays.
    for kind in learned["kinds"]:
        if kind["kind"] == "bed":
            kind.update(by_hand=True, wall=[{"distance": 0.5}])
    mine = write(folder / "mine.json", json.dumps(learned))
    run("learn", "exemplar/bedroom", "-o", priors, "--keep", mine, "-q")
    assert next(kind for kind in json.loads(priors.read_text())["kinds"] if kind["kind"] == "bed")["wall"][0]["distance"] == 0.5
    before = priors.read_bytes()
    assert 'did you mean "exemplar/bedroom-1"' in fails("learn", "exemplar/bedrom-1", "-o", priors)
    assert "nothing to learn from" in fails("learn", "learned-bedroom", "-o", priors)
    assert "no example has" in fails("learn", "exemplar/bedroom", "-o", priors, "--pair", "tv,throne")
    assert "two kinds" in fails("learn", "exemplar/bedroom", "-o", priors, "--pair", "tv")
    assert "picture" in fails("learn", "exemplar/bedroom", "-o", priors, "--explain", folder / "a.docx")
    mine.write_text('{"kinds": [{"kind": "bed", "wal": []}]}')
    assert f"{mine}: /kinds/0/wal" in fails("learn", "exemplar/bedroom", "-o", priors, "--keep", mine)
    assert priors.read_bytes() == before
    fails("learn")


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
    assert {line.split(",")[0] for line in lines[1:]} == {"1", "2"}
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


def test_trajectories(folder):
    ring = folder / "ring.txt"
    ring.write_text("# framerate: 25 fps\n# id frame x/m y/m z/m\n" +
                    "".join(f"{p} {f} {0.05 * f} {p} 0\n" for p in (1, 2) for f in range(50)))
    for name in ("ring.csv", "ring.h5", "ring.sqlite", "again.txt"):
        result = run("convert", ring, folder / name)
        assert result.stdout == result.stderr == "", result.stderr
        run("convert", folder / name, folder / ("back-" + name))
        assert (folder / name).read_bytes() == (folder / ("back-" + name)).read_bytes()
        ring = folder / name
    assert (folder / "again.txt").read_text().endswith("\n2 49 2.45 2 0\n")
    old = folder / "old.txt"
    old.write_text("".join(f"1 {f} {8 * f} 100 176\n" for f in range(20)))
    assert "--unit cm|m and --fps N say it; with cm and 16 fps the median speed would be 1.3 m/s" in fails(
        "convert", old, folder / "new.txt")
    assert not (folder / "new.txt").exists()
    run("convert", old, folder / "new.txt", "--unit", "cm", "--fps", 16)
    assert "\n1 1 0.08 1 0\n" in (folder / "new.txt").read_text()
    cut = folder / "cut.h5"
    cut.write_bytes((folder / "ring.h5").read_bytes()[:5000])
    before = (folder / "new.txt").read_bytes()
    assert f"{cut}: HDF5: the file is damaged or cut off" in fails("convert", cut, folder / "new.txt")
    assert (folder / "new.txt").read_bytes() == before
    fails("convert", old, folder / "new.json", "--unit", "cm", "--fps", 16)
    fails("convert", old, folder / "new.txt", "--unit", "inch", "--fps", 16)
    fails("convert", "living-room", folder / "room.json", "--fps", 16)
    fails("convert", ring, folder / "new.txt", "--room", "Kitchen")
    assert "gap" in run("convert", write(folder / "gap.csv", "id,t,x,y\n1,0,0,0\n1,0.5,0.6,0\n1,1,1.2,0\n1,2,2.4,0\n"),
                        folder / "new.txt").stderr
    help_text = run("convert", "--help").stdout
    assert "--homography" in help_text and ".sqlite" in help_text and "Vadere" in help_text
    assert not list(folder.glob("*.part-*"))


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


def walkers(folder):
    """Ten people side by side for two seconds."""
    rows = [f"{p} {f} {0.12 * f:.3f} {p} 0\n" for p in range(10) for f in range(20)]
    return write(folder / "walk.txt", "# framerate: 10 fps\n# id frame x/m y/m z/m\n" + "".join(rows))


def test_crowd_pictures(folder):
    """Pictures of people by every way; options that mean nothing there are refused."""
    walk = walkers(folder)
    for name, start in (("a.svg", b"<?xml"), ("a.png", b"\x89PNG"), ("a.pdf", b"%PDF")):
        run("render", walk, "-o", folder / name)
        assert (folder / name).read_bytes().startswith(start)
    assert "10 people</text>" in (folder / "a.svg").read_text()
    run("render", walk, "-o", folder / "b.svg", "--scene", "living-room", "--at", 1.05, "--trail", 0, "--radius", 0.2)
    assert ">1.05 s</text>" in (folder / "b.svg").read_text()
    run("render", walk, "-o", folder / "c.svg", "--paths", "--color", "time", "--from", 0.5, "--until", 1)
    assert ">10 paths</text>" in (folder / "c.svg").read_text()
    run("render", walk, "-o", folder / "d.svg", "--space-time", "x")
    assert ">time [s]</text>" in (folder / "d.svg").read_text()
    assert "0.00 … 1.90 s" in fails("render", walk, "-o", folder / "e.svg", "--at", 7)
    assert "--problems" in fails("render", walk, "-o", folder / "e.svg", "--problems")
    assert "--at" in fails("render", "living-room", "-o", folder / "e.svg", "--at", 1)
    assert "--film-fps is for films" in fails("render", walk, "-o", folder / "e.svg", "--film-fps", 5)
    assert "nobody" in fails("render", walk, "-o", folder / "e.svg", "--from", 100)
    assert ".mp4" in fails("render", walk, "-o", folder / "e.docx")
    assert not (folder / "e.svg").exists()
    run("render", walk, "-o", str(folder / "frames") + "/", "--film-fps", 5, "--width", 321)
    names = sorted(p.name for p in (folder / "frames").iterdir())
    assert names == [f"frame-{k:06d}.png" for k in range(10)], names
    run("render", walk, "-o", folder / "f-%02d.png", "--film-fps", 5, "--width", 321, "--speed", 2, "--threads", 1)
    assert (folder / "f-01.png").read_bytes() == (folder / "frames" / "frame-000002.png").read_bytes()
    assert not (folder / "f-05.png").exists()
    nowhere = {**os.environ, "PATH": str(folder)}
    result = subprocess.run([INHABIT, "render", str(walk), "-o", str(folder / "f.mp4")], capture_output=True, text=True, env=nowhere)
    assert result.returncode == 2 and "ffmpeg" in result.stderr and result.stderr.count("\n") == 1, result.stderr


def test_film(folder):
    """A film has every picture; Ctrl-C and an ffmpeg that fails leave what was there."""
    if not shutil.which("ffmpeg"):
        print("skipped: ffmpeg is not on the PATH")
        sys.exit(77)
    walk = walkers(folder)
    for name, start in (("a.mp4", b"ftyp"), ("a.webm", b"webm")):
        run("render", walk, "-o", folder / name, "--width", 161)
        assert start in (folder / name).read_bytes()[:64]
        probe = shutil.which("ffprobe")
        if probe:
            said = subprocess.run([probe, "-v", "error", "-count_frames", "-show_entries", "stream=width,nb_read_frames", "-of",
                                   "csv=p=0", str(folder / name)], capture_output=True, text=True).stdout
            assert said.strip() == "162,46", said  # 1.9 s at 24 pictures per second, both ends
    before = (folder / "a.mp4").read_bytes()
    process = subprocess.Popen([INHABIT, "render", str(walk), "-o", str(folder / "a.mp4"), "--speed", "0.001"],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    _, complaint = process.communicate(timeout=60)
    assert process.returncode == 2 and "interrupted" in complaint, complaint
    broken = folder / "bin" / "ffmpeg"
    broken.parent.mkdir()
    write(broken, "#!/bin/sh\necho no such codec >&2\nexit 1\n").chmod(0o755)
    result = subprocess.run([INHABIT, "render", str(walk), "-o", str(folder / "a.mp4")], capture_output=True, text=True,
                            env={**os.environ, "PATH": f"{broken.parent}:/bin:/usr/bin"})
    assert result.returncode == 2 and "no such codec" in result.stderr, result.stderr
    assert (folder / "a.mp4").read_bytes() == before
    assert sorted(p.name for p in folder.iterdir()) == ["a.mp4", "a.webm", "bin", "walk.txt"]


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


def test_measure(folder):
    """Walkers in a row through a corridor, by every way out; places and files that are none are refused."""
    walk = folder / "walk.txt"
    rows = [f"{p} {f} {1.2 * (f / 10 - p):.4f} {0.5 + p % 3 * 0.3:.4f} 1.7" for p in range(1, 12) for f in range(10 * p, 10 * p + 80)]
    walk.write_text("# framerate: 10 fps\n# id frame x/m y/m z/m\n" + "\n".join(rows) + "\n")
    text = run("measure", walk, "--line", "4,2,4,-1", "--area", "3,0,5,1.6").stdout
    assert "specific flow" in text and "11" in text, text
    report = json.loads(run("measure", walk, "--line", "4,2,4,-1", "--json").stdout)
    assert report["flow"]["forward"] == 11 and abs(report["flow"]["flow"] - 1) < 1e-3, report["flow"]
    assert report["people"] == 11 and abs(report["speed"]["median"] - 1.2) < 1e-3
    run("measure", walk, "-q", "--plots", folder / "plots", "--csv", folder / "rows")
    assert len(list((folder / "plots").glob("*.svg"))) == 7 and len(list((folder / "rows").glob("*.csv"))) == 7
    assert "--line" in fails("measure", walk, "--line", "1,1")
    assert "--area" in fails("measure", walk, "--area", "nonsense")
    assert "nobody" in fails("measure", walk, "--from", "1000")
    fails("measure", folder / "nothing.txt")
    fails("measure", walk, "--scene", folder / "nothing.json")
    fails("measure", walk, "--plots", folder / "no" / "such")
    assert fails("measure", walk, "--reference", walk)


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


CORRIDOR = {
    "format": "inhabit-scene", "version": 1, "name": "corridor",
    "space": {"outline": [[0, 0], [30, 0], [30, 6], [0, 6]],
              "holes": [{"id": "pillar", "outline": [[14, 2.5], [15, 2.5], [15, 3.5], [14, 3.5]]}]},
    "crowd": {"populations": [{"id": "walkers", "area": [[2, 0.5], [8, 0.5], [8, 5.5], [2, 5.5]], "spacing": 1,
                               "goal": "east"}],
              "sources": [{"id": "entrance", "area": [[24, 1], [27, 1], [27, 5], [24, 5]], "rate": 1, "goal": "west"}],
              "goals": [{"id": "east", "area": [[29, 0], [30, 0], [30, 6], [29, 6]]},
                        {"id": "west", "area": [[0, 0], [1, 0], [1, 6], [0, 6]]}]}}


def test_simulate(folder):
    """People walk, the file has a row for each of them every two steps, and wrong input is one line."""
    scene = folder / "corridor.json"
    scene.write_text(json.dumps(CORRIDOR))
    out = folder / "walk.txt"
    summary = json.loads(run("simulate", scene, "-o", out, "--seconds", 3, "--json").stdout)
    assert summary["people"] == 33 and summary["steps"] == 144 and summary["frames"] == 73, summary
    assert summary["put_back"] == 0 and summary["warnings"] == [], summary
    lines = out.read_text().splitlines()
    assert "framerate: 24" in lines[0], lines[0]
    assert sum(not line.startswith("#") for line in lines) > 30 * 73
    for threads in (1, 3):
        again = folder / f"walk-{threads}.txt"
        assert run("simulate", scene, "-o", again, "--seconds", 3, "--threads", threads, "-q").stdout == ""
        assert again.read_bytes() == out.read_bytes()
    run("simulate", scene, "-o", again, "--seconds", 3, "--seed", 2, "-q")
    assert again.read_bytes() != out.read_bytes()
    for name in ("walk.csv", "walk.h5", "walk.sqlite"):
        run("simulate", scene, "-o", folder / name, "--seconds", 0.5, "--model", "orca", "--set", "horizon=3", "-q")
        assert (folder / name).stat().st_size > 0
    assert "people" in run("simulate", scene, "--seconds", 0.1).stdout
    assert "iterations" in run("simulate", "--parameters").stdout

    assert 'did you mean "power-law"' in fails("simulate", scene, "--model", "power-lau")
    assert 'did you mean "iterations"' in fails("simulate", scene, "--set", "iteratoins=3")
    assert "at most 1 s" in fails("simulate", scene, "--step", 2, "-o", out)
    assert "people" in fails("simulate", "living-room")
    fails("simulate")
    fails("simulate", scene, "-o", folder / "walk.docx")
    fails("simulate", scene, "--every", 0)
    lost = json.loads(json.dumps(CORRIDOR))
    lost["space"]["holes"][0]["outline"] = [[14, 0], [15, 0], [15, 6], [14, 6]]
    scene.write_text(json.dumps(lost))
    before = out.read_bytes()
    complaint = fails("simulate", scene, "-o", out)
    assert "/crowd/" in complaint and "nobody can get from" in complaint and "west" in complaint, complaint
    assert out.read_bytes() == before


def test_simulate_interrupt(folder):
    """Ctrl-C keeps the frames so far, in every format."""
    scene = folder / "corridor.json"
    scene.write_text(json.dumps(CORRIDOR))
    for name in ("walk.txt", "walk.csv", "walk.h5", "walk.sqlite"):
        out = folder / name
        process = subprocess.Popen([INHABIT, "simulate", str(scene), "-o", str(out), "--seconds", "1000000", "--json"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        text, complaint = process.communicate(timeout=60)
        assert process.returncode == 0, complaint
        summary = json.loads(text)
        assert summary["cancelled"] and summary["frames"] > 0, summary
        assert out.stat().st_size > 0
        if name.endswith(".txt"):
            last = out.read_text().splitlines()[-1].split()
            assert int(last[1]) == summary["frames"] - 1, (last, summary)


def test_bench(folder):
    answer = json.loads(run("bench", "interactive", "tight", "--seeds", 1, "--json", "--plots", folder).stdout)
    assert [table["id"] for table in answer["tables"]] == ["machine", "interactive", "tight"]
    assert (folder / "tight.svg").exists()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        globals()["test_" + sys.argv[2]](pathlib.Path(place))
