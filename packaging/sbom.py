"""The software bill of materials of a folder, as SPDX 2.3 in JSON: each file by its sums, each package of Debian's that files came from or were made with."""

import hashlib
import json
import pathlib
import re
import time

NONE = "NOASSERTION"


def element(name):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def package(name, version, **more):
    return {"SPDXID": element(name), "name": name, "versionInfo": version, "downloadLocation": NONE, "filesAnalyzed": False,
            "licenseConcluded": NONE, "licenseDeclared": NONE, "copyrightText": NONE, **more}


def debian(name, version, source):
    where = f"pkg:deb/debian/{name}@{version}"
    return package(name, version, supplier="Organization: Debian", sourceInfo=f"built from Debian's source package {source}",
                   externalRefs=[{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": where}])


def bill(folder, version, epoch, origins, made_with):
    """`origins`: file (below `folder`) -> (package, version, source) where it is a copy of Debian's; `made_with`: such triples that are in ours."""
    packages = {triple[0]: debian(*triple) for triple in sorted({*origins.values(), *made_with})}
    ours = package("whittle", version, supplier="Organization: The Whittle project", licenseDeclared="Apache-2.0")
    files, relations = [], [("SPDXRef-DOCUMENT", "DESCRIBES", ours["SPDXID"])]
    for path in sorted(p for p in pathlib.Path(folder).rglob("*") if p.is_file() and not p.is_symlink()):
        name, data = str(path.relative_to(folder)), path.read_bytes()
        sums = [{"algorithm": kind, "checksumValue": hashlib.new(kind, data).hexdigest()} for kind in ("SHA1", "SHA256")]
        files.append({"SPDXID": element("File-" + name), "fileName": "./" + name, "checksums": sums, "licenseConcluded": NONE, "copyrightText": NONE})
        holder = packages[origins[name][0]] if name in origins else ours
        relations.append((holder["SPDXID"], "CONTAINS", files[-1]["SPDXID"]))
    for name, found in packages.items():
        whole = any(triple[0] == name for triple in origins.values())
        relations.append((ours["SPDXID"], "DEPENDS_ON", found["SPDXID"]) if whole else (found["SPDXID"], "BUILD_DEPENDENCY_OF", ours["SPDXID"]))
    content = json.dumps([files, sorted(packages), relations])
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"whittle-{version}",
            "documentNamespace": "https://spdx.org/spdxdocs/whittle-" + hashlib.sha256(content.encode()).hexdigest(),
            "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(epoch)), "creators": ["Tool: packaging/sbom.py"]},
            "packages": [ours, *packages.values()], "files": files,
            "relationships": [{"spdxElementId": a, "relationshipType": b, "relatedSpdxElement": c} for a, b, c in relations]}
