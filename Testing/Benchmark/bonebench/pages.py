# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages and sections that are written from Documentation/results/benchmark-data.

    python3 -m bonebench.pages [--check]     --check: writes nothing, and ends with 1 where a page is not what the data say
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from . import audit_page, document, records, tables
from .document import DATA, IMAGES, RESULTS, ROOT
from .records import Records, read_file

README, EVIDENCE = ROOT / "README.md", ROOT / "Documentation" / "paper" / "evidence.md"
FEATURES = tuple(RESULTS / f"{name}.md" for name in ("formats", "measurements", "thesis-tolerance", "tolerances-and-counts", "triangle-shapes"))


def with_parts(page: Path, parts: dict[str, str]) -> str:
    """The page with each part between its mark and the next end."""
    return re.sub(r"(?s)(<!-- table: (.+?) -->\n).*?(<!-- end -->)", lambda mark: f"{mark[1]}{parts[mark[2]]}{mark[3]}",
                  page.read_text(encoding="utf-8"))


def evidence(data: Records) -> dict[str, str]:
    """The tables of the paper."""
    audit, certificates = (read_file(RESULTS / DATA / name) for name in audit_page.FILES)
    return {"audit": audit_page.kept_by_program(audit), "certificates": audit_page.beside_others_by_bone(certificates),
            "equal counts": tables.by_method(data["comparison"], lambda record: tables.number(tables.worst(record, "rms"))),
            "proved": tables.thesis_errors(data["errors"]), "thesis": tables.thesis_counts(data["comparison"])}


def feature_tables() -> dict[str, str]:
    """The tables of single features, each with its commits."""
    parts = {}
    for file in (RESULTS / DATA).glob("features-*.csv"):
        rows = read_file(file)
        commits = ", ".join(dict.fromkeys(row.pop("commit") for row in rows))
        table = tables.markdown(list(rows[0]), [[tables.cell(value) for value in row.values()] for row in rows])
        parts[file.stem.split("-", 1)[1]] = f"\n{table}\nCommit: {commits}. Data: [{file.name}]({DATA}/{file.name}).\n\n"
    return parts


def generated() -> dict[Path, str]:
    """The text of each page."""
    data, run = records.read(RESULTS / DATA)
    plots = sorted(path.name for path in IMAGES.glob("benchmark-*.png"))
    sections = {"benchmark": document.readme_section(data, run),
                "audit": audit_page.readme_section(read_file(RESULTS / DATA / audit_page.FILES[0]))}
    return {RESULTS / "benchmark.md": document.page(data, run, plots, "../images"), RESULTS / "thesis.md": document.thesis_page(data),
            RESULTS / "audit.md": audit_page.page(RESULTS / DATA), README: with_parts(README, sections),
            EVIDENCE: with_parts(EVIDENCE, evidence(data)), **{page: with_parts(page, feature_tables()) for page in FEATURES}}


def write() -> None:
    """Writes all of them."""
    for page, text in generated().items():
        page.write_text(text, encoding="utf-8")


def main() -> int:
    """Writes or checks."""
    if "--check" not in sys.argv:
        write()
        return 0
    wrong = [page for page, text in generated().items() if page.read_text(encoding="utf-8") != text]
    for page in wrong:
        print(f"{page.relative_to(ROOT)} is not what the data say: python3 -m bonebench.pages in Testing/Benchmark writes it again")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
