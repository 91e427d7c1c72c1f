#!/bin/sh
# Puts Sweet Home 3D's own example homes (Home.xml files, CC BY 3.0 or GPL) and its program library into a folder, from the
# Debian package: DIR/examples/*.xml and DIR/sweethome3d.jar. Needs neither root nor Java. Does nothing when they are there.
set -eu

if [ $# -ne 1 ]; then
  echo "usage: $0 DIR" >&2
  exit 2
fi
mkdir -p "$1"
dir=$(cd "$1" && pwd)
inside=com/eteks/sweethome3d/io/resources/examples

if [ -f "$dir/sweethome3d.jar" ] && [ -f "$dir/examples/Studio.xml" ]; then
  exit 0
fi
for tool in apt-get dpkg-deb python3; do
  command -v "$tool" >/dev/null || { echo "fetch_sweethome3d: needs $tool (Debian or Ubuntu)" >&2; exit 1; }
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if ! (cd "$work" && apt-get download sweethome3d) >"$work/log" 2>&1; then
  tail -n 3 "$work/log" >&2
  echo "fetch_sweethome3d: the package sweethome3d cannot be downloaded: no network, or no Debian package index" >&2
  echo "(try 'apt-get update' as root). The homes are only examples; everything else works without them." >&2
  exit 1
fi
dpkg-deb -x "$work"/sweethome3d_*.deb "$work/package"
jar=$(find "$work/package" -name sweethome3d.jar -type f | head -n 1)
if [ -z "$jar" ]; then
  echo "fetch_sweethome3d: the package holds no sweethome3d.jar" >&2
  exit 1
fi
# Python unpacks the jar (a zip), because unzip is not on every machine.
python3 - "$jar" "$inside/" "$work/examples" <<'PYTHON'
import pathlib, sys, zipfile
jar, prefix, out = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
out.mkdir()
with zipfile.ZipFile(jar) as archive:
    for name in archive.namelist():
        if name.startswith(prefix) and name.endswith(".xml"):
            (out / pathlib.PurePosixPath(name).name).write_bytes(archive.read(name))
PYTHON
mkdir -p "$dir/examples"
cp "$work"/examples/*.xml "$dir/examples/"
cp "$jar" "$dir/sweethome3d.jar.part"
mv "$dir/sweethome3d.jar.part" "$dir/sweethome3d.jar"
echo "$dir/examples: $(find "$dir/examples" -name '*.xml' | wc -l) homes"
