"""Builds the wheel (PEP 517) with CMake: no other package is needed.

Environment  CLEARCUT_BUILD_DIR  where to compile (default build/release, as `make` does); kept, so that a second wheel takes seconds
             CMAKE_ARGS          more arguments for CMake's configuration
             SOURCE_DATE_EPOCH   time of the files in the wheel (default 1980): the same sources give the same bytes
"""
import base64
import gzip
import hashlib
import io
import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EARLIEST = 315532800  # 1980-01-01: zip files know none before


def version():
    return re.search(r"project\(clearcut VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def tag():
    """The interpreter and the machine that the compiled part is for."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def metadata():
    return (
        "Metadata-Version: 2.1\nName: clearcut\n"
        f"Version: {version()}\n"
        "Summary: Plans 2.5-D pocket-milling toolpaths and proves them\n"
        "License: MIT\nClassifier: License :: OSI Approved :: MIT License\n"
        "Requires-Python: >=3.9\nRequires-Dist: numpy\n"
    )


def compiled():
    """The folder that holds the package with its compiled part."""
    build = Path(os.environ.get("CLEARCUT_BUILD_DIR", ROOT / "build" / "release"))
    configure = ["cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCLEARCUT_PYTHON=ON"]
    if not (build / "CMakeCache.txt").exists():
        configure += ["-G", "Ninja"] if _has("ninja") else []
        configure += ["-DCLEARCUT_TESTS=OFF"]
    # The interpreter itself: pip's may lie in a virtual environment that is gone before the next build.
    configure += [f"-DPython_EXECUTABLE={Path(sys.executable).resolve()}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
    subprocess.run(configure, check=True)
    subprocess.run(["cmake", "--build", build, "--target", "_core"], check=True)
    return build / "python" / "clearcut"


def _has(program):
    return any((Path(folder) / program).exists() for folder in os.environ["PATH"].split(os.pathsep))


def _record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def described():
    """The files of a wheel that say what it is."""
    info = f"clearcut-{version()}.dist-info"
    wheel = f"Wheel-Version: 1.0\nGenerator: clearcut\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    return {f"{info}/METADATA": metadata().encode(), f"{info}/WHEEL": wheel.encode()}


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """So that pip knows name and version before anything is compiled."""
    for name, content in described().items():
        file = Path(metadata_directory) / name
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(content)
    return f"clearcut-{version()}.dist-info"


def write_wheel(folder, files):
    """A wheel of (name, bytes): sorted, with one time for all of them."""
    info = f"clearcut-{version()}.dist-info"
    files = {**files, **described()}
    record = "".join(_record_line(name, files[name]) for name in sorted(files)) + f"{info}/RECORD,,\n"
    stamp = time.gmtime(max(EARLIEST, int(os.environ.get("SOURCE_DATE_EPOCH", EARLIEST))))[:6]
    name = f"clearcut-{version()}-{tag()}.whl"
    with zipfile.ZipFile(Path(folder) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for file in [*sorted(files), f"{info}/RECORD"]:
            entry = zipfile.ZipInfo(file, stamp)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if file.endswith(".so") else 0o644) << 16
            wheel.writestr(entry, files.get(file, record.encode()))
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    package = compiled()
    # What was compiled for another interpreter in the same folder is left out.
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    files = {f"clearcut/{file.name}": file.read_bytes() for file in package.iterdir()
             if file.is_file() and (file.suffix != ".so" or file.name.endswith(suffix))}
    return write_wheel(wheel_directory, files)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that points to the build folder."""
    return write_wheel(wheel_directory, {"clearcut.pth": f"{compiled().parent}\n".encode()})


def _sources():
    """What git knows of the tree; of an unpacked source archive all of its files."""
    if (ROOT / "PKG-INFO").exists():
        files = [file.relative_to(ROOT) for file in ROOT.rglob("*") if file.is_file()]
        return sorted(str(file) for file in files if file.parts[0] != "build" and file.name != "PKG-INFO" and file.suffix != ".pyc")
    return sorted(subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.splitlines())


def build_sdist(sdist_directory, config_settings=None):
    """The sources with PKG-INFO, which says what they are; the same sources give the same bytes."""
    name = f"clearcut-{version()}"
    stamp = max(EARLIEST, int(os.environ.get("SOURCE_DATE_EPOCH", EARLIEST)))
    with open(Path(sdist_directory) / f"{name}.tar.gz", "wb") as file, \
            gzip.GzipFile("", "wb", fileobj=file, mtime=stamp) as packed, tarfile.open(fileobj=packed, mode="w") as archive:
        def add(entry, content):
            entry.size, entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname = len(content), stamp, 0, 0, "", ""
            archive.addfile(entry, io.BytesIO(content))

        add(tarfile.TarInfo(f"{name}/PKG-INFO"), metadata().encode())
        for listed in _sources():
            entry = tarfile.TarInfo(f"{name}/{listed}")
            entry.mode = 0o755 if os.access(ROOT / listed, os.X_OK) else 0o644
            add(entry, (ROOT / listed).read_bytes())
    return f"{name}.tar.gz"


if __name__ == "__main__":
    print(metadata(), end="")
