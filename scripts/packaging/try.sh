#!/usr/bin/env bash
# Tries packages in a fresh Debian 12: try.sh FOLDER_OF_PACKAGES. Made anew by mmdebstrap (as root; what is downloaded is Debian's),
# thrown away after: the command plans, Python imports, CMake finds, the tarball runs on what a bare Debian has, and after removal no file is
# left. CLEARCUT_BASE names a tarball of a bare Debian to start from.
set -euo pipefail
packages=$(realpath "$1")
source=$(cd "$(dirname "$0")/../.." && pwd)
if [ "$(id -u)" -ne 0 ] || ! command -v mmdebstrap > /dev/null; then
  echo "not tried: needs root and mmdebstrap" >&2
  exit 0
fi
scratch=$(mktemp -d)
root=$scratch/root
# What is still mounted is not followed into.
trap 'umount -q "$root/proc" || true; rm -rf --one-file-system "$scratch"' EXIT
mkdir "$root"
if [ -n "${CLEARCUT_BASE:-}" ]; then
  tar -C "$root" -xf "$CLEARCUT_BASE"
else
  # From where this machine takes its packages, where it says so.
  sources=$(find /etc/apt/sources.list.d -name debian.sources)
  mmdebstrap --quiet --variant=minbase --mode=root --dpkgopt=force-unsafe-io bookworm "$root" ${sources:+"$sources"}
fi
mount -t proc proc "$root/proc"
cp /etc/resolv.conf "$root/etc/" 2> /dev/null || true
echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
mkdir "$root/try"
cp "$packages"/*.deb "$source/examples/bracket.json" "$root/try/"
cp -r "$source/examples/embed" "$root/try/"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive bash -euc "cd /try; $1"; }
install() { inside "apt-get install -y -qq --no-install-recommends $1 > /try/apt.log 2>&1 || { cat /try/apt.log; exit 1; }"; }
step() { printf '%-12s %s\n' "$1" "$2"; }
plan='plan bracket.json --tool endmill:6 --quiet -o'

# Before anything is installed: the tarball has what it needs.
mkdir "$root/opt/a folder"
tar -C "$root/opt/a folder" -xf "$packages"/clearcut-*.tar.xz --strip-components=1
inside "'/opt/a folder/bin/clearcut' $plan tarball.ngc"
[ ! -x "$root/opt/a folder/bin/clearcut-solids" ] || {
  cp "$source/examples/bracket.step" "$root/try/"
  inside "'/opt/a folder/bin/clearcut' info bracket.step > /dev/null"
}
# A bare Debian has no font to draw a sheet with, and is told so.
[ ! -x "$root/opt/a folder/bin/clearcut-sheet" ] ||
  inside "! '/opt/a folder/bin/clearcut' $plan sheet.ngc --setup-sheet sheet.pdf 2> refusal && grep -q fonts-dejavu-core refusal && [ ! -e sheet.pdf ]"
step tarball "plans, reads a solid, on a bare Debian, in '/opt/a folder'"

# A stranger's path: what the README prints, for a drawing of one's own.
inside "apt-get update -qq"
mkdir "$root/try/own"
cp "$packages"/clearcut_*.deb "$root/try/own/"
printf '%s\n' 0 SECTION 2 HEADER 9 '$INSUNITS' 70 4 0 ENDSEC 0 SECTION 2 ENTITIES 0 LWPOLYLINE 8 0 90 4 70 1 \
  10 0 20 0 10 70 20 0 10 70 20 40 10 0 20 40 0 CIRCLE 8 0 10 50 20 20 40 6 0 ENDSEC 0 EOF > "$root/try/own/drawing.dxf"
sed -n '/^## Your own drawing/,/^## Use/s/^    //p' "$source/README.md" | sed 's/^sudo apt install/apt-get install -y -qq --no-install-recommends/' > "$root/try/own/printed.sh"
[ "$(wc -l < "$root/try/own/printed.sh")" -ge 4 ]
began=$SECONDS
inside "cd own && bash -e printed.sh > said 2>&1 || { cat said; exit 1; }; grep -q '^(CERTIFICATE: CLEAN' drawing.ngc"
step README "an own drawing, planned and proven as printed, in $((SECONDS - began)) s"
rm -r "$root/try/own"
install "python3-minimal"
inside "clearcut $plan package.ngc && cmp package.ngc tarball.ngc && clearcut info bracket.json > /dev/null && clearcut serve --help > /dev/null"
[ ! -x "$root/usr/bin/clearcut-sheet" ] || inside "clearcut $plan package.ngc --setup-sheet sheet.pdf && head -c 4 sheet.pdf | grep -q %PDF"
step clearcut "plans; the same bytes as the tarball's"
[ ! -e "$(echo "$packages"/clearcut-mpi_*.deb)" ] || {
  study='clearcut study spread --side 6 --runs 40 --generations 50 --quiet'
  inside "! $study --mpi -o mpi.csv 2> refusal && grep -q 'the package clearcut-mpi' refusal"
  install "./clearcut-mpi_*.deb openmpi-bin"
  inside "$study -o serial.csv && mpirun --allow-run-as-root --oversubscribe -n 2 $study --mpi -o mpi.csv && cmp serial.csv mpi.csv"
  step clearcut-mpi "a study on two processes: the same bytes as on one"
}
install "./python3-clearcut_*.deb"
inside "python3 -c '
import clearcut, importlib.metadata
plan = clearcut.plan(\"bracket.json\", tools=\"endmill:6\")
assert plan.clean and plan.program == open(\"package.ngc\").read()
assert importlib.metadata.version(\"clearcut\") == clearcut.__version__'"
inside "PYTHONPATH='/opt/a folder/lib/python3/dist-packages' python3 -c '
import clearcut
assert clearcut.__file__.startswith(\"/opt\") and clearcut.plan(\"bracket.json\", tools=\"endmill:6\").clean'"
step python3 "imports and plans the same program, packaged and from the tarball"
install "./libclearcut0*.deb ./libclearcut-dev_*.deb g++ cmake make"
for how in OFF ON; do
  inside "rm -rf built && cmake -S embed -B built -DEMBED_PKG_CONFIG=$how > /dev/null && cmake --build built > /dev/null && built/embed > /dev/null"
done
inside "sed s/clearcut::clearcut/clearcut::shared/ -i embed/CMakeLists.txt && cmake -S embed -B shared > /dev/null && cmake --build shared > /dev/null &&
  ldd shared/embed | grep -q libclearcut.so.0 && shared/embed > /dev/null"
step libclearcut "found by find_package and pkg-config, archive and shared; the example is built and runs"

inside "apt-get purge -y -qq clearcut 'clearcut-mpi*' python3-clearcut libclearcut-dev 'libclearcut0*' > /dev/null 2>&1; ! dpkg -l '*clearcut*' 2> /dev/null | grep -q '^[ih]'"
left=$(inside "rm -rf '/opt/a folder'; find / -xdev -path /try -prune -o -name '*clearcut*' -print | grep -v -e ^/proc || true")
[ -z "$left" ] || { echo "left behind: $left" >&2; exit 1; }
step removal "leaves no file"
