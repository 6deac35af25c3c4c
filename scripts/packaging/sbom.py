"""Writes what the built programs consist of, with versions and licences, as SPDX 2.3: sbom.py OUT VERSION BINARY...

Read from Debian's own records: which package owns each shared object that the programs load, which headers are compiled into
them, and what the copyright files say. OUT gets clearcut.spdx.json, and in licenses/ the notices of what is compiled in.
SOURCE_DATE_EPOCH is its time (default 1980); the same programs and packages give the same bytes.
"""
import functools
import hashlib
import json
import os
import re
import subprocess
import sys
from datetime import datetime, timezone
from pathlib import Path

# Packages of headers alone, and musl, of which functions are taken: their code lies in our binaries.
COMPILED_IN = ("libboost1.74-dev", "libcli11-dev", "musl-dev", "nlohmann-json3-dev", "pybind11-dev")
TOOLS = ("g++-12", "cmake", "ninja-build")
# Copyright files name licences in Debian's way.
SPDX = {
    "apache-2.0": "Apache-2.0", "boost": "BSL-1.0", "bsl-1.0": "BSL-1.0", "bsd-2-clause": "BSD-2-Clause",
    "bsd-3-clause": "BSD-3-Clause", "expat": "MIT", "expat with embedded exception": "MIT", "mit": "MIT", "zlib": "Zlib",
    "lgpl-2.1 with opencascade exception": "LGPL-2.1-only WITH OCCT-exception-1.0", "ftl or gpl-2+": "FTL OR GPL-2.0-or-later",
    "bsd-3-clause+cla": "BSD-3-Clause", "gpl-2+": "GPL-2.0-or-later", "lgpl-2.1+": "LGPL-2.1-or-later", "bsd-3-clause or gpl-2+": "BSD-3-Clause OR GPL-2.0-or-later",
    "lgpl-2+": "LGPL-2.0-or-later", "lgpl-2+ and lgpl-2.1+": "LGPL-2.0-or-later AND LGPL-2.1-or-later", "mit-1": "MIT",
    "lgpl-2+ and lgpl-2.1+ and cc0-1.0": "LGPL-2.0-or-later AND LGPL-2.1-or-later AND CC0-1.0",
    "lgpl-2.1+ or mpl-1.1 or gpl-2+": "LGPL-2.1-or-later OR MPL-1.1 OR GPL-2.0-or-later",
}
# Those whose copyright files are prose.
IN_PROSE = {"libc6": "LGPL-2.1-or-later", "libstdc++6": "GPL-3.0-or-later WITH GCC-exception-3.1",
            "libgcc-s1": "GPL-3.0-or-later WITH GCC-exception-3.1", "g++-12": "GPL-3.0-or-later",
            "libhwloc15": "BSD-3-Clause", "libopenmpi3": "BSD-3-Clause-Open-MPI", "zlib1g": "Zlib",
            "libfreetype6": "FTL OR GPL-2.0-or-later", "libfontconfig1": "HPND-sell-variant", "libpng16-16": "libpng-2.0",
            "libcairo2": "LGPL-2.1-only OR MPL-1.1", "libcairo-gobject2": "LGPL-2.1-only OR MPL-1.1", "libpixman-1-0": "MIT",
            "libselinux1": "libselinux-1.0", "libxau6": "MIT-open-group", "libxdmcp6": "MIT-open-group", "libxext6": "MIT-open-group",
            "libxrender1": "HPND-sell-variant", "libx11-6": "MIT"}


def said(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def loaded_packages(binary):
    """The packages of every shared object that the loader finds for a binary."""
    owners = set()
    for file in re.findall(r"=> (/\S+)|^\s*(/\S+ld-linux\S+)", said("ldd", binary), re.MULTILINE):
        owner = _owner(file[0] or file[1])
        if owner:
            owners.add(owner)
    return owners


@functools.cache  # asking takes a second, and most programs load the same
def _owner(file):
    """dpkg knows files of merged directories by either of their names."""
    path = Path(file)
    for name in dict.fromkeys((path, path.resolve(), Path(str(path.resolve()).removeprefix("/usr")))):
        run = subprocess.run(["dpkg", "-S", name], capture_output=True, text=True)
        if run.returncode == 0:
            return run.stdout.split(":")[0]
    return None


def license_of(package):
    """The licence of a package's own files in SPDX's words, NOASSERTION where its copyright file does not say it in known ones."""
    if package in IN_PROSE:
        return IN_PROSE[package]
    file = Path(f"/usr/share/doc/{package}/copyright")
    for stanza in file.read_text(errors="replace").split("\n\n") if file.exists() else []:
        files = re.search(r"^Files:((?:.|\n[ \t])*)", stanza, re.MULTILINE)
        name = re.search(r"^License:[ \t]*(.+)", stanza, re.MULTILINE)
        if files and name and "*" in files[1].split():
            return SPDX.get(name[1].strip().lower(), "NOASSERTION")
    return "NOASSERTION"


def identifier(name):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def debian_package(name):
    version, architecture, home = said("dpkg-query", "-W", "-f", "${Version}\\t${Architecture}\\t${Homepage}\\n", name).splitlines()[0].split("\t")
    declared = license_of(name)
    entry = {
        "SPDXID": identifier(name), "name": name, "versionInfo": version, "supplier": "Organization: Debian",
        "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseConcluded": "NOASSERTION",
        "licenseDeclared": declared, "copyrightText": "NOASSERTION",
        "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                          "referenceLocator": f"pkg:deb/debian/{name.replace('+', '%2B')}@{version.replace('+', '%2B').replace(':', '%3A')}?arch={architecture}"}],
    }
    return entry | ({"homepage": home} if home else {})


def our_package(name, version):
    return {"SPDXID": identifier(name), "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": "MIT", "licenseDeclared": "MIT", "copyrightText": "Copyright (c) 2026 The Clearcut authors"}


def document(version, binaries):
    packages = {"clearcut-source": our_package("clearcut-source", version)}
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", identifier("clearcut-source"))]
    for binary in binaries:
        name = Path(binary).name
        packages[name] = our_package(name, version)
        relations.append((identifier(name), "GENERATED_FROM", identifier("clearcut-source")))
        for owner in sorted(loaded_packages(binary)):
            packages.setdefault(owner, debian_package(owner))
            relations.append((identifier(name), "DYNAMIC_LINK", identifier(owner)))
    for names, relation in ((COMPILED_IN, "STATIC_LINK"), (TOOLS, "BUILD_TOOL_OF")):
        for name in names:
            packages[name] = debian_package(name)
            ends = (identifier("clearcut-source"), identifier(name))
            relations.append((ends[0], relation, ends[1]) if relation == "STATIC_LINK" else (ends[1], relation, ends[0]))
    text = json.dumps([packages, relations], sort_keys=True)
    epoch = int(os.environ.get("SOURCE_DATE_EPOCH", 315532800))
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"clearcut-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/clearcut-{version}-{hashlib.sha256(text.encode()).hexdigest()}",
        "creationInfo": {"created": datetime.fromtimestamp(epoch, timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
                         "creators": ["Tool: clearcut-sbom"]},
        "packages": [packages[name] for name in sorted(packages)],
        "relationships": [{"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b} for a, kind, b in relations],
    }


def main(out, version, *binaries):
    folder = Path(out)
    (folder / "licenses").mkdir(parents=True, exist_ok=True)
    made = document(version, binaries)
    (folder / "clearcut.spdx.json").write_text(json.dumps(made, indent=1, ensure_ascii=False) + "\n")
    for name in COMPILED_IN:
        notice = Path(f"/usr/share/doc/{name}/copyright").read_text(errors="replace")
        # Boost's is megabytes of file lists; the licence is all that its terms ask for, and of binaries not even that.
        (folder / "licenses" / name).write_text(notice if len(notice) < 100_000 else notice[: notice.index("\nFiles:")] + "\nLicense: BSL-1.0\n")
    unknown = sorted(entry["name"] for entry in made["packages"] if entry["licenseDeclared"] == "NOASSERTION")
    print(f"{len(made['packages'])} packages; licence not in known words: {', '.join(unknown) or 'none'}")


if __name__ == "__main__":
    main(*sys.argv[1:])
