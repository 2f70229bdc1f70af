#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The software of others in what the project delivers: Utilities/third_party.json, checked, as a page, and as bills of materials.

    third_party.py --markdown                      Documentation/reference/third-party.md
    third_party.py --check [BINARY...]             that the page, licenses and libraries of binaries agree with the list
    third_party.py --sbom PRODUCT FILE             a bill of materials in CycloneDX 1.6; deb, wheel, wheel-windows, wheel-program, page
                                   or browser

Versions are those of the Debian packages that are installed, of package-lock.json and of wheel_constraints.txt. With SOURCE_DATE_EPOCH
the bill has that time; without it none, so that the same input gives the same bytes.
"""
import argparse
import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import urllib.parse
import uuid

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "Utilities" / "third_party.json"
CONSTRAINTS = ROOT / "Utilities" / "wheel_constraints.txt"
VIEWER = ROOT / "Applications" / "Picture" / "Viewer"
PAGE = ROOT / "Documentation" / "reference" / "third-party.md"
BROWSER = ROOT / "Applications" / "Browser"
PRODUCTS = {"deb": "Debian package", "wheel": "wheel", "wheel-windows": "wheel for Windows", "wheel-program": "program of wheels",
            "page": "HTML page", "browser": "browser"}
OWN = ("libBoneDecimate", "libvtkFiltersBoneDecimate", "libvtkFiltersParallelBoneDecimate", "libvtkBoneDecimate", "libvtkpython", "libpython")


def components(product=None):
    return [one for one in json.loads(LIST.read_text(encoding="utf-8"))["components"] if product is None or product in one["in"]]


def own_version():
    return re.search(r"project\(vtkBoneDecimate VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def packages_of(folder):
    return json.loads((folder / "package-lock.json").read_text(encoding="utf-8"))["packages"]


def version_of_wheel_tool(name):
    found = re.search(rf"(?m)^{re.escape(name)}==(\S+)$", CONSTRAINTS.read_text(encoding="utf-8"))
    return found[1] if found else ""


def debian_version(package):
    """Empty if dpkg does not know it."""
    try:
        done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True, check=False)
    except OSError:
        return ""
    return done.stdout.strip() if done.returncode == 0 else ""


def version_and_purl(component):
    quoted = {"safe": ""}
    if "npm" in component:
        version = packages_of(VIEWER if "page" in component["in"] else BROWSER)["node_modules/" + component["npm"]]["version"]
        scope, _, name = component["npm"].rpartition("/")
        return version, "pkg:npm/" + (urllib.parse.quote(scope, **quoted) + "/" if scope else "") + f"{name}@{version}"
    if "pypi" in component:
        version = version_of_wheel_tool(component["pypi"])
        return version, f"pkg:pypi/{component['pypi']}@{version}"
    if "debian" in component:
        version = debian_version(component["debian"])
        return version, f"pkg:deb/debian/{component['debian']}" + (f"@{urllib.parse.quote(version, **quoted)}" if version else "")
    return "", ""


def origin(component):
    for kind, shown in (("debian", "Debian"), ("pypi", "PyPI"), ("npm", "npm"), ("part_of", "part of")):
        if kind in component:
            return f"{shown} `{component[kind]}`"
    return ""


def markdown():
    lines = ["# Third-party software", "",
             "What the deliveries of this project link, have compiled in or bundle. The list is `Utilities/third_party.json`; a test compares it with the",
             "libraries of the built program, with the packages of the interactive view and with this page. The project itself is BSD-3-Clause. Each Debian",
             "package and each wheel has a bill of materials with versions (CycloneDX 1.6): `/usr/share/doc/vtkbonedecimate/sbom.cdx.json`, and",
             "`bonedecimate-*.dist-info/sboms/` in the wheel.", "",
             "| software | license (SPDX) | how | in | from |", "|---|---|---|---|---|"]
    for one in components():
        where = ", ".join(PRODUCTS[product] for product in one["in"])
        lines.append(f"| [{one['name']}]({one['url']}) | {one['license']} | {one['how']} | {where} | {origin(one)} |")
    lines += ["", "Linked libraries come from the system and are not delivered. ParaView, 3D Slicer, VTK, PyVista and numpy load the project's modules under",
              "their own licenses. What only builds, tests or measures the project is in `Utilities/packages.txt`, `Utilities/wheel_constraints.txt` and",
              "`Testing/Benchmark/requirements.txt`. \"Browser\" is the page that decimates in the browser, with the package for npm. License texts:",
              "`Applications/Picture/Viewer/LICENSES.txt` (also in each page), `Applications/Browser/LICENSES.txt` and",
              "`Utilities/wheel_licenses.txt` (also in the wheel); those of the program of wheels, as Debian has them, are in `licenses/program/` of its metadata.", ""]
    return "\n".join(lines)


def license_of(component):
    name = component["license"]
    return {"expression": name} if " " in name or name.startswith("LicenseRef-") else {"license": {"id": name}}


def entry(component):
    version, purl = version_and_purl(component)
    made = {"type": "library", "bom-ref": component["name"], "name": component["name"]}
    if version:
        made["version"] = version
    made["licenses"] = [license_of(component)]
    if purl:
        made["purl"] = purl
    made["externalReferences"] = [{"type": "website", "url": component["url"]}]
    made["properties"] = [{"name": "vtkbonedecimate:how", "value": component["how"]}]
    return made


def bill(product):
    found = [entry(one) for one in components(product)]
    name = {"deb": "vtkbonedecimate", "wheel": "bonedecimate", "wheel-windows": "bonedecimate", "wheel-program": "bonedecimate-program",
            "page": "bonedecimate-viewer", "browser": "bonedecimate-browser"}[product]
    main = {"type": "application" if product in ("deb", "wheel-program") else "library", "bom-ref": name, "name": name, "version": own_version(),
            "licenses": [{"license": {"id": "BSD-3-Clause"}}]}
    metadata = {"component": main}
    if "SOURCE_DATE_EPOCH" in os.environ:
        time = datetime.datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), datetime.timezone.utc)
        metadata = {"timestamp": time.strftime("%Y-%m-%dT%H:%M:%SZ"), **metadata}
    made = {"$schema": "http://cyclonedx.org/schema/bom-1.6.schema.json", "bomFormat": "CycloneDX", "specVersion": "1.6", "version": 1,
            "metadata": metadata, "components": found,
            "dependencies": [{"ref": name, "dependsOn": [one["bom-ref"] for one in found]},
                             *({"ref": one["bom-ref"]} for one in found)]}
    serial = uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(made, sort_keys=True))
    return {"$schema": made.pop("$schema"), "bomFormat": made.pop("bomFormat"), "specVersion": made.pop("specVersion"),
            "serialNumber": f"urn:uuid:{serial}", **made}


def problems_of_viewer():
    text = (VIEWER / "LICENSES.txt").read_text(encoding="utf-8")
    for one in components("page"):
        package = packages_of(VIEWER)["node_modules/" + one["npm"]]
        if f"{one['npm'].rpartition('/')[2]} {package['version']}, {one['license']}" not in text:
            yield f"Viewer/LICENSES.txt lacks {one['npm']} {package['version']}, {one['license']}"
        if one["license"] not in package["license"]:
            yield f"{one['npm']} has the license {package['license']}"


def problems_of_browser():
    text = (BROWSER / "LICENSES.txt").read_text(encoding="utf-8")
    for one in components("browser"):
        if "page" in one["in"]:
            version = packages_of(BROWSER)["node_modules/" + one["npm"]]["version"]
            if version != version_and_purl(one)[0]:
                yield f"the browser has {one['npm']} {version}, the HTML page another version"
        elif one["name"].lower() not in text.lower():
            yield f"Applications/Browser/LICENSES.txt lacks {one['name']}"


def problems_of_binary(binary):
    text = subprocess.run(["readelf", "-d", binary], capture_output=True, text=True, check=True).stdout
    known = [prefix for one in components() for prefix in one.get("libraries", [])]
    for library in re.findall(r"NEEDED.*\[(.*)\]", text):
        if not library.startswith((*known, *OWN)):
            yield f"{pathlib.Path(binary).name} links {library}, which is not in the list"


def problems(binaries):
    if PAGE.read_text(encoding="utf-8") != markdown():
        yield "Documentation/reference/third-party.md is not what third_party.py --markdown prints"
    licenses = (ROOT / "Utilities" / "wheel_licenses.txt").read_text(encoding="utf-8")
    for one in [*components("wheel"), *components("wheel-windows")]:
        if one["how"] != "linked" and one["name"] not in licenses:
            yield f"Utilities/wheel_licenses.txt lacks {one['name']}"
        if "pypi" in one and not version_of_wheel_tool(one["pypi"]):
            yield f"Utilities/wheel_constraints.txt lacks {one['pypi']}"
    yield from problems_of_viewer()
    yield from problems_of_browser()
    for binary in binaries:
        yield from problems_of_binary(binary)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--markdown", action="store_true")
    parser.add_argument("--check", nargs="*", metavar="BINARY")
    parser.add_argument("--sbom", nargs=2, metavar=("PRODUCT", "FILE"))
    arguments = parser.parse_args()
    if arguments.markdown:
        sys.stdout.write(markdown())
    if arguments.sbom:
        pathlib.Path(arguments.sbom[1]).write_text(json.dumps(bill(arguments.sbom[0]), indent=2) + "\n", encoding="utf-8")
    found = list(problems(arguments.check)) if arguments.check is not None else []
    for problem in found:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
