# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of Documentation/paper/evidence.md, from the data of benchmark and audit.

    python3 -m bonebench.evidence
"""

from __future__ import annotations

import re

from . import audit_page, records, tables
from .document import DATA, RESULTS, ROOT
from .records import read_file

PAGE = ROOT / "Documentation" / "paper" / "evidence.md"


def main() -> None:
    """Writes each table between its mark and the next end."""
    data, _ = records.read(RESULTS / DATA)
    audit, certificates = (read_file(RESULTS / DATA / name) for name in audit_page.FILES)
    made = {"audit": audit_page.kept_by_program(audit), "certificates": audit_page.beside_others(certificates),
            "equal counts": tables.by_method(data["comparison"], lambda record: tables.number(tables.worst(record, "rms"))),
            "proved": tables.proved_triangles(data["proved"]), "thesis": tables.thesis_counts(data["comparison"])}
    text = re.sub(r"(?s)(<!-- table: (.+?) -->\n).*?(<!-- end -->)", lambda m: f"{m[1]}{made[m[2]]}{m[3]}",
                  PAGE.read_text(encoding="utf-8"))
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
