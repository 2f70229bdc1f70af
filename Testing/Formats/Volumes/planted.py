#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Deliberate errors in the readers of volumes; the comparison must find each.

    python3 Testing/Formats/Volumes/planted.py FOLDER

FOLDER gets a copy of the sources and a build. Prints a row for each error: the variants that differ.
"""

import dataclasses
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
VARIANTS = 100


@dataclasses.dataclass
class Bug:
    name: str
    format: str
    file: str  # of Applications/Volume
    old: str  # blanks and line ends are the same
    new: str


BUGS = (
    Bug("LAS is mirrored along x alone", "nrrd", "Readers/NrrdFile.cxx", "(*vector)[1] = -(*vector)[1];", ""),
    Bug("units of NRRD are passed over", "nrrd", "Readers/NrrdFile.cxx", "geometry = InMillimeters(geometry, this->Unit());", ""),
    Bug("byte orders are exchanged", "nrrd", "Readers/NrrdFile.cxx", "airEndianBig ? ByteOrder::Big : ByteOrder::Little",
        "airEndianBig ? ByteOrder::Little : ByteOrder::Big"),
    Bug("bytes before packed voxels are not skipped", "nrrd", "Readers/DataFile.cxx", "== bytes + data.Skipped", "== bytes"),
    Bug("y of the sform stays in RAS", "nifti", "Readers/NiftiPosition.cxx", "row < 2 ? -1.0 : 1.0", "row < 1 ? -1.0 : 1.0"),
    Bug("any sform is preferred", "nifti", "Readers/NiftiPosition.cxx", "header.At<std::int16_t>(254) == 1;", "header.At<std::int16_t>(254) >= 1;"),
    Bug("voxels always begin at byte 352", "nifti", "Readers/NiftiHeader.h", "? static_cast<std::uint64_t>(offset) : Size", "? 352 : Size"),
    Bug("an intercept alone is no scale", "nifti", "Readers/NiftiHeader.h", "(slope != 1.0F || intercept != 0.0F)",
        "(slope != 1.0F || intercept > 1e30F)"),
    Bug("the origin has the wrong unit", "nifti", "Readers/NiftiPosition.cxx", "const double unit = header.Unit().Millimeters; return",
        "const double unit = 1.0; return"),
    Bug("one key of the byte order is not known", "metaimage", "Readers/MetaImageFile.cxx", 'FieldOf(header, "binarydatabyteordermsb")', "key"),
    Bug("bytes before voxels from the end of the file are not skipped", "metaimage", "Readers/MetaImageFile.cxx", "ParseWholeNumber(FieldOf(header, \"headersize\")).value_or(0) == 0",
        "ParseWholeNumber(FieldOf(header, \"headersize\")).value_or(0) < 100"),
    Bug("of several segments the first one counts", "seg.nrrd", "LabelMaps/Segmentation.cxx", "last = std::max(last, found->second);",
        "last = last == 0 ? found->second : last;"),
    Bug("colors are reversed", "seg.nrrd", "LabelMaps/Segmentation.cxx", "std::copy(color->begin(), color->end(), segment.Color.begin());",
        "std::copy(color->rbegin(), color->rend(), segment.Color.begin());"),
    Bug("names are identifiers", "seg.nrrd", "LabelMaps/Segmentation.cxx", 'segment.Name = textOf(prefix + "Name");', "segment.Name = identifier;"),
    Bug("rows and columns exchange their distances", "dicom", "Dicom/DicomScan.cxx", "slice->RowDistance = (*spacing)[0]; slice->ColumnDistance = (*spacing)[1];",
        "slice->RowDistance = (*spacing)[1]; slice->ColumnDistance = (*spacing)[0];"),
    Bug("slices are ordered downward", "dicom", "Dicom/DicomSeries.cxx", "Dot(a.Position, normal) < Dot(b.Position, normal)",
        "Dot(a.Position, normal) > Dot(b.Position, normal)"),
    Bug("the range of padding ends early", "dicom", "Dicom/DicomReader.cxx", "std::max(one, other) + half", "std::min(one, other) + half"),
    Bug("frames have the scale of the file", "enhanced", "Dicom/DicomFrames.cxx", "slice.Slope = slope ? slope->front() : slice.Slope;", "slice.Slope *= slope ? 1.0 : 1.0;"),
    Bug("bits are counted from the highest one", "seg", "Dicom/SegmentFrames.cxx", ">> bit % 8;", ">> (7 - bit % 8);"),
    Bug("planes begin at the last frame", "seg", "Dicom/FrameGrid.cxx", "grid.Geometry.Origin = this->Frames[this->Order.front()].Position;",
        "grid.Geometry.Origin = this->Frames[this->Order.back()].Position;"),
    Bug("the name of a segment has one encoding", "seg", "Dicom/DicomText.cxx", "NameForIconv(FirstTerm(characterSet))", "NameForIconv(FirstTerm(characterSet).substr(0, 0))"),
    Bug("slices are in the order of the folder", "tiff", "Readers/TiffFolder.cxx", "std::sort(ordered.begin(), ordered.end());", ""),
    Bug("the last tile of a row is one too narrow", "tiff", "Readers/TiledTiff.cxx", "std::min(width, columns - x) * bytes);", "(std::min(width, columns - x) - 1) * bytes);"),
    Bug("the origin is that of the upper corner", "vti", "Readers/VtiVolume.cxx", "geometry.Steps[axis][i] * extent[2 * axis];",
        "geometry.Steps[axis][i] * extent[2 * axis + 1];"),
)


def pattern_of(text):
    return re.compile(r"\s+".join(re.escape(word) for word in text.split()))


def copied(folder):
    """The sources as they are, built."""
    source = folder / "source"
    if not source.exists():
        files = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.split("\n")
        for name in filter(None, files):
            (source / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, source / name)
        subprocess.run(["cmake", "--preset", "release"], cwd=source, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return source


def built(source):
    words = ["cmake", "--build", "build/release", "--target", "bonedecimate-dump-volume"]
    subprocess.run(words, cwd=source, check=True, stdout=subprocess.DEVNULL)


def differences(source, format_):
    words = [sys.executable, "-B", str(ROOT / "Testing" / "Formats" / "compare_volumes.py"), "--format", format_, "--variants", str(VARIANTS),
             "--driver", str(source / "build" / "release" / "bin" / "bonedecimate-dump-volume"), "--generator"]
    text = subprocess.run(words, check=False, capture_output=True, text=True).stdout
    return int(text.split("\n")[2].split("|")[5])


def rounds():
    """Of each format one error at a time: those of several formats are built together, as none is in code of two formats."""
    of_format = {}
    for bug in BUGS:
        of_format.setdefault(bug.format, []).append(bug)
    return [[bugs[i] for bugs in of_format.values() if i < len(bugs)] for i in range(max(map(len, of_format.values())))]


def plant(source, bug):
    path = source / "Applications" / "Volume" / bug.file
    changed, count = pattern_of(bug.old).subn(lambda _match: bug.new, path.read_text(encoding="utf-8"))
    assert count == 1, f"{bug.name}: {count} matches"
    path.write_text(changed, encoding="utf-8")


def main():
    source = copied(pathlib.Path(sys.argv[1]).resolve())
    built(source)
    for format_ in sorted({bug.format for bug in BUGS}):
        assert differences(source, format_) == 0, format_
    print("| format | error | variants that differ |\n|---|---|---:|", flush=True)
    missed = 0
    for bugs in rounds():
        for bug in bugs:
            plant(source, bug)
        built(source)
        for bug in bugs:
            found = differences(source, bug.format)
            missed += found == 0
            print(f"| {bug.format} | {bug.name} | {found} |", flush=True)
        for bug in bugs:
            name = pathlib.Path("Applications") / "Volume" / bug.file
            shutil.copy(ROOT / name, source / name)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
