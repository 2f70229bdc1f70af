# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names and colors of labels: in the header of a label map, in a file that is given, and in one that lies beside the map."""

import gzip
import json
import struct
import zipfile

from application import REJECTED, USAGE, ApplicationTest, main, read
from volume_headers_test import SEGMENTS, balls, layers, nifti

COLORS = {1: (255, 0, 0), 2: (0, 128, 255)}
SNAP = """################
# ITK-SnAP Label Description File
################
    0     0    0    0        0  0  0    "Clear Label"
    1   255    0    0        1  1  1    "femur left"
    2     0  128  255     0.50  1  1    "patella, left"
"""
CTBL = "# Color table file Bones.ctbl\n# 3 values\n0 background 0 0 0 0\n1 femur_left 255 0 0 255\n2 patella_left 0 128 255 255\n9 (none) 0 0 0 0\n"
TSV = "index\tname\tabbreviation\tcolor\tmapping\n0\tBackground\tBG\t#000000\t0\n1\tfemur left\tFL\t#ff0000\t40\n2\tpatella left\tn/a\t#0080FF\t1\n"
CSV = 'LabelValue,Name,Color_R,Color_G,Color_B,Color_A\n1,"femur left",255,0,0,255\n2,"patella, left",0,128,255,255\n'
NNUNET = {"channel_names": {"0": "CT"}, "labels": {"background": 0, "femur left": 1, "patella left": 2}, "file_ending": ".nii.gz"}
NAMED = ["femur_left.vtp", "index.html", "patella_left.vtp", "picture.png", "report.json"]


def table(labels, more=""):
    """The header extension that TotalSegmentator writes."""
    rows = "".join(f'<Label Key="{key}" Red="{color[0] / 255}" Green="{color[1] / 255}" Blue="{color[2] / 255}" Alpha="1">'
                   f"<![CDATA[{name}]]></Label>\n" for key, name, color in labels)
    return ('<?xml version="1.0" encoding="UTF-8"?> <CaretExtension>  <Date><![CDATA[2013-07-14T05:45:09]]></Date>   <VolumeInformation Index="0">'
            f'   <LabelTable>\n{rows}\n  </LabelTable>  <StudyMetaDataLinkSet>  </StudyMetaDataLinkSet>  <VolumeType><![CDATA[Label]]>'
            f"</VolumeType>   </VolumeInformation></CaretExtension>{more}\n              ").encode()


def extended(data, *extensions, order="<"):
    """The bytes of a .nii with extensions of code 0 in its header."""
    body = b"".join(struct.pack(order + "ii", size, 0) + text.ljust(size - 8, b"\0")
                    for text in extensions for size in [(len(text) + 8 + 15) // 16 * 16])
    header = bytearray(data[:352])
    header[348] = 1
    struct.pack_into(order + "f", header, 108, 352 + len(body))
    return bytes(header) + body + data[352:]


FEMUR = [(1, "femur left", COLORS[1]), (2, "patella left", COLORS[2]), (40, "spleen", (1, 2, 3))]


class LabelNames(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.map = nifti(balls())
        self.write("map.nii", self.map)

    def write(self, name, data):
        self.path(name).parent.mkdir(parents=True, exist_ok=True)
        self.path(name).write_bytes(data if isinstance(data, bytes) else data.encode())
        return name

    def names_of(self, name, *words, segments="all"):
        """By label, with colors, as the result holds them; and what the program says."""
        text = self.succeed(name, "out.vtp", "--segments", segments, *SEGMENTS[2:], "--report", "report.json", *words).stdout
        fields = read(self.path("out.vtp")).GetFieldData()
        values, names, colors = (fields.GetAbstractArray(field) for field in ("LabelValues", "LabelNames", "LabelColors"))
        rows = range(values.GetNumberOfTuples() - 1)
        return {int(values.GetTuple1(i)): (names.GetValue(i), colors.GetTuple(i) if colors else None) for i in rows}, text

    def test_the_table_in_a_header_names_and_colors_the_surfaces(self):
        self.write("total.nii.gz", gzip.compress(extended(self.map, b"<other/>", table(FEMUR))))
        names, text = self.names_of("total.nii.gz")
        self.assertEqual(names, {1: ("femur left", COLORS[1]), 2: ("patella left", COLORS[2])})
        self.assertIn("note: names of labels are those of the table in its header", text)
        self.assertNotIn("spleen", text)  # a table has rows for what a scan does not show
        self.assertEqual([(row["label"], row["name"]) for row in self.report()["segments"]["list"]], [(1, "femur left"), (2, "patella left")])
        self.succeed("total.nii.gz", "bones/", *SEGMENTS)
        self.assertEqual(sorted(path.name for path in self.path("bones").iterdir()), NAMED)
        self.assertIn("femur left", self.path("bones/index.html").read_text(encoding="utf-8"))
        self.succeed("total.nii.gz", "bones.3mf", *SEGMENTS)
        self.succeed("total.nii.gz", "bones.glb", *SEGMENTS)
        self.succeed("total.nii.gz", "bones.vtm", *SEGMENTS)
        with zipfile.ZipFile(self.path("bones.3mf")) as file:
            self.assertIn(b'name="patella left"', file.read("3D/3dmodel.model"))
        for name in ("bones.glb", "bones.vtm"):
            self.assertIn(b"patella left", self.path(name).read_bytes())

    def test_headers_of_either_byte_order_are_read(self):
        data = bytearray(self.map[:352])
        for begin, kind in ((0, "i"), (108, "3f"), (76, "8f"), (40, "8h"), (70, "2h"), (252, "2h"), (280, "12f")):
            struct.pack_into(">" + kind, data, begin, *struct.unpack_from("<" + kind, data, begin))
        self.write("big.nii", extended(bytes(data) + self.map[352:], table(FEMUR), order=">"))
        self.assertEqual(self.names_of("big.nii")[0][2], ("patella left", COLORS[2]))

    def test_segments_are_chosen_by_the_names_of_the_header(self):
        self.write("total.nii", extended(self.map, table(FEMUR)))
        self.assertEqual(list(self.names_of("total.nii", segments="PATELLA left")[0]), [2])
        text = self.names_of("total.nii", segments="femur left,spleen")[1]
        self.assertIn("warning: no surface of 40 (spleen): no voxel has this label\n", text)
        self.fail_with(REJECTED, "total.nii", "no.vtp", "--segments", "spleen", says="no voxel belongs to what --segments chooses, 40 (spleen)")
        says = "it has no segment 'rib'; its segments are 1 (femur left), 2 (patella left)\n"
        self.fail_with(REJECTED, "total.nii", "no.vtp", "--segments", "rib", says=says)
        bones = [(1, "Femur_Left", COLORS[1]), (2, "liver", COLORS[2])]
        self.write("bones.nii", extended(self.map, table(bones)))
        self.assertEqual(list(self.names_of("bones.nii", segments="bones")[0]), [1])

    def test_a_fixed_table_that_contradicts_the_header_is_rejected(self):
        labels = balls()
        labels[labels == 1], labels[labels == 2] = 25, 92
        for name, rows in (("right", [(25, "Sacrum", COLORS[1])]), ("generic", [(25, "Segment_1", COLORS[1])]), ("wrong", [(92, "spleen", COLORS[2])])):
            self.write(f"{name}.nii", extended(nifti(labels), table(rows)))
        words = ("--label-names", "totalsegmentator")
        self.assertEqual(self.names_of("right.nii", *words)[0], {25: ("Sacrum", COLORS[1]), 92: ("rib_left_1", (0, 0, 0))})
        self.assertEqual(self.names_of("generic.nii", *words)[0][25], ("sacrum", COLORS[1]))
        says = ("label 92 is 'spleen' in its header and 'rib_left_1' in the table of TotalSegmentator: --label-names contradicts the label map; "
                "leave it out to take the names of the header")
        self.fail_with(REJECTED, "wrong.nii", "no.vtp", *SEGMENTS, *words, says=says)
        self.write("names.tsv", "index\tname\n92\trib 1\n")
        self.fail_with(REJECTED, "wrong.nii", "no.vtp", *SEGMENTS, "--label-names", "names.tsv", says="'rib 1' in names.tsv")

    def test_tables_of_other_programs_are_named_or_lie_beside_the_map(self):
        first = {1: ("femur left", COLORS[1]), 2: ("patella left", COLORS[2])}
        comma = {1: ("femur left", COLORS[1]), 2: ("patella, left", COLORS[2])}
        underscore = {1: ("femur_left", COLORS[1]), 2: ("patella_left", COLORS[2])}
        plain = {1: ("femur left", None), 2: ("patella left", None)}
        for name, text, names in (("snap.txt", SNAP, comma), ("map.txt", SNAP, comma), ("map.label", SNAP, comma), ("slicer.ctbl", CTBL, underscore),
                                  ("map.ctbl", CTBL, underscore), ("map_ColorTable.ctbl", CTBL, underscore), ("bids.tsv", TSV, first),
                                  ("map.tsv", TSV, first), ("dseg.tsv", TSV, first), ("map.csv", CSV, comma), ("nnunet.json", json.dumps(NNUNET), plain),
                                  ("dataset.json", json.dumps(NNUNET), plain)):
            with self.subTest(name=name):
                self.write(name, text)
                is_beside = name.startswith(("map", "dseg", "dataset"))
                found, told = self.names_of("map.nii", *(() if is_beside else ("--label-names", name)))
                self.assertEqual(found, names)
                note = f"note: names of labels are those of {name} beside the label map"
                (self.assertIn if is_beside else self.assertNotIn)(note, told)
                self.path(name).unlink()

    def test_the_files_of_a_dataset_are_found(self):
        self.write("data/dataset.json", json.dumps(NNUNET))
        self.write("data/labelsTr/case.nii", self.map)
        self.assertEqual(self.names_of("data/labelsTr/case.nii")[0][1][0], "femur left")
        self.write("bids/sub-01_desc-bone_dseg.nii", self.map)
        self.write("bids/desc-bone_dseg.tsv", TSV)
        self.write("bids/desc-other_dseg.tsv", TSV.replace("femur", "rib"))
        self.write("bids/dseg.tsv", TSV.replace("femur", "tooth"))
        self.assertEqual(self.names_of("bids/sub-01_desc-bone_dseg.nii")[0][1][0], "femur left")
        self.assertEqual(self.names_of("map.nii")[0][1][0], "")

    def test_what_the_header_names_comes_first(self):
        self.write("total.nii", extended(self.map, table(FEMUR)))
        self.write("dseg.tsv", "index\tname\n1\trib\n")
        self.assertEqual(self.names_of("total.nii")[0][1][0], "femur left")
        self.assertEqual(self.names_of("map.nii")[0], {1: ("rib", None), 2: ("", None)})
        labels = balls()
        self.write("layers.seg.nrrd", layers(labels == 1, labels == 2, names=("bone", "marrow")))
        self.write("layers.ctbl", "1 rib 1 2 3 255\n")
        self.assertEqual(self.names_of("layers.seg.nrrd")[0][1][0], "bone")
        self.fail_with(REJECTED, "layers.seg.nrrd", "no.vtp", *SEGMENTS, "--label-names", "layers.ctbl", says="'bone' in its header and 'rib'")
        # names that say no more than the label are completed, also where segments are chosen before layers are combined
        self.write("layers.seg.nrrd", layers(labels == 1, 2 * (labels > 0), names=("Segment_1", "Segment_2")).replace(b"Segment1_LabelValue:=1", b"Segment1_LabelValue:=2"))
        self.assertEqual(self.names_of("layers.seg.nrrd", segments="rib")[0][1][0], "rib")

    def test_regions_choose_all_of_their_labels(self):
        regions = {"labels": {"background": 0, "leg": [1, 2], "patella": [2]}, "regions_class_order": [1, 2]}
        self.write("dataset.json", json.dumps(regions))
        names = self.names_of("map.nii", segments="Leg")[0]
        self.assertEqual({label: name for label, (name, _) in names.items()}, {1: "", 2: "patella"})
        self.write("dataset.json", json.dumps({"labels": {"0": "background", "1": "femur", "2": "patella"}}))
        self.assertEqual(self.names_of("map.nii")[0][1][0], "femur")

    def test_a_table_that_cannot_be_read_is_rejected_with_its_line(self):
        for name, text, says in (
            ("a.tsv", "index\tname\n1\tfemur\n1.5\trib\n", "line 3: '1.5' is no label"),
            ("a.tsv", "index\tname\n1e300\tfemur\n", "line 2: '1e300' is no label"),
            ("a.tsv", "index\tname\n9223372036854775808\tfemur\n", "line 2: '9223372036854775808' is no label"),
            ("a.tsv", "index\tname\n\n7\n", "line 3: it has 1 columns"),
            ("a.ctbl", "# comment\r\n1 femur 300 0 0 255\r\n", "line 2: its color is not within 0 to 255"),
            ("a.ctbl", "1 femur\n", "line 1: it is no row of a color table"),
            ("a.txt", '1 255 0 0 1 1 "femur"\n', "line 1: it is no label description"),
            ("a.txt", "femur\n", "line 1:"), ("a.txt", "", "it names no label"), ("a.txt", "\0\1\2", "line 1:"),
            ("a.tsv", "index\tname\n1\tfemur\n1\trib\n", "its label 1 has two names, 'femur' and 'rib'"),
            ("a.json", "{", "it is no valid JSON"), ("a.json", "[" * 100000, ""), ("a.json", '{"a":' * 100000, "it is no valid JSON"),
            ("a.json", "{}", "it names no label"), ("a.json", '{"labels": [1, 2]}', "labels is no object"),
            ("a.json", '{"labels": {"femur": 1.5}}', "the label of 'femur' is 1.5, which is no whole number"),
            ("a.json", '{"labels": {"femur": 1e300}}', "the label of 'femur' is 1e+300"),
            ("a.json", '{"labels": {"femur": 18446744073709551615}}', "is 18446744073709551615"),
            ("a.json", '{"labels": {"leg": [1, [2]]}}', "is [1,[2]]"),
            ("a.tsv", b"\xff\xfe" + TSV.encode("utf-16-le"), "its text is UTF-16; save it as UTF-8")):
            with self.subTest(text=text[:40]):
                self.write(name, text)
                self.fail_with(REJECTED, "map.nii", "no.vtp", *SEGMENTS, "--label-names", name, says=says)
        says = "--label-names takes totalsegmentator or a file with names (.json, .tsv, .csv, .ctbl, .txt or .label); there is no file 'b.tsv'"
        self.fail_with(USAGE, "map.nii", "no.vtp", *SEGMENTS, "--label-names", "b.tsv", says=says)
        self.fail_with(REJECTED, "map.nii", "no.vtp", *SEGMENTS, "--label-names", ".", says="no regular file")

    def test_damaged_and_contradicting_tables_beside_a_map_are_told_and_left(self):
        self.write("map.txt", "A note on this scan.\n")
        names, text = self.names_of("map.nii")
        self.assertEqual(names, {1: ("", None), 2: ("", None)})
        self.assertNotIn("warning", text)
        self.write("map.tsv", "index\tname\n1\tfemur\nx\trib\n")
        self.assertIn("warning: map.tsv, beside the label map, is no table of its labels: line 3: 'x' is no label", self.names_of("map.nii")[1])
        self.write("map.tsv", "index\tname\n1\tfemur\n")
        self.write("map.ctbl", "1 tibia 1 2 3 255\n")
        names, text = self.names_of("map.nii")
        self.assertEqual(names[1][0], "")
        self.assertIn("two files beside the label map contradict each other, so that no names are taken from them: label 1 is 'femur' in map.tsv and 'tibia' "
                      "in map.ctbl; --label-names FILE chooses one", text)
        self.assertEqual(self.names_of("map.nii", "--label-names", "map.ctbl")[0][1], ("tibia", (1, 2, 3)))
        self.write("map.ctbl", "1 Femur 1 2 3 255\n")
        self.assertEqual(self.names_of("map.nii")[0][1][0], "femur")

    def test_a_damaged_table_in_a_header_is_told_and_left(self):
        whole = table(FEMUR)
        for text, says in ((whole[:-60], "its XML is damaged"), (whole.replace(b'Key="2"', b'Key="2.5"'), "a label has no whole number"),
                           (table(FEMUR + [(2, "rib", COLORS[1])]), "its label 2 has two names"), (table([(1, "f\xff", COLORS[1])]).replace(b"\xc3\xbf", b"\xff"), "its XML is damaged"),
                           (b"<LabelTable" + b"<a>" * 300000, "its XML is damaged")):
            self.write("total.nii", extended(self.map, text))
            names, told = self.names_of("total.nii")
            self.assertEqual(names, {1: ("", None), 2: ("", None)})
            self.assertIn("warning: no names are taken from the table of labels in its header: " + says, told)
        data = bytearray(extended(self.map, whole))
        struct.pack_into("<i", data, 352, 1 << 30)
        self.write("total.nii", bytes(data))
        self.assertEqual(self.names_of("total.nii")[0][1][0], "")

    def test_what_tables_of_spreadsheets_have_is_read(self):
        for name, data in (("a.csv", "LabelValue;Name\n1.0;femur\n2;tibia\n"), ("a.ctbl", '1 "femur" 255 0 0 255\n2\ttibia\t0\t0\t255\t255\n'),
                           ("a.tsv", "name\tcolor\tindex\nfemur\tn/a\t1\nn/a\tn/a\t9\ntibia\tred\t2"), ("a.json", '{"labels": {"femur": 1.0, "tibia": "2"}}')):
            self.write(name, data)
            self.assertEqual([label for label, _ in self.names_of("map.nii", "--label-names", name)[0].values()], ["femur", "tibia"])
        self.write("a.json", '{"labels": {"Sch\u00e4del": 1}}'.encode("latin-1"))
        self.assertEqual(self.names_of("map.nii", "--label-names", "a.json")[0][1][0], "Sch?del")
        self.write("a.tsv", "id\tlabel\n1\tfemur\n")
        says = "line 1: it is no row of a color table, which is a label, a name and four numbers, and no heading with the columns index and name"
        self.fail_with(REJECTED, "map.nii", "no.vtp", *SEGMENTS, "--label-names", "a.tsv", says=says)

    def test_names_in_any_encoding_and_of_any_length_are_safe(self):
        self.write("map.tsv", b"\xef\xbb\xbfindex\tname\r\n1\tSch\xc3\xa4del\r\n2\tSch\xe4del \x1b[31m\r\n")
        self.assertEqual([name for name, _ in self.names_of("map.nii")[0].values()], ["Sch\u00e4del", "Sch?del ?[31m"])
        rows = "".join(f"{label}\t{'x' * 1000}{label}\n" for label in range(1, 20001))
        self.write("map.tsv", "index\tname\n" + rows)
        self.assertEqual(self.names_of("map.nii")[0][2][0], "x" * 1000 + "2")
        self.write("map.tsv", "index\tname\r1\tfemur\r2\t../../rib\r")
        self.succeed("map.nii", "bones/", *SEGMENTS, "--format", "stl")
        self.assertTrue(self.path("bones/femur.stl").exists())
        self.assertTrue(self.path("bones/label_2.stl").exists())

    def test_a_batch_takes_the_table_beside_each_map(self):
        for name in ("a", "b"):
            self.write(f"maps/{name}.nii", self.map)
            self.write(f"maps/{name}.ctbl", f"1 {name}one 1 2 3 255\n")
        self.succeed("maps", "out/", "--segments", "1", *SEGMENTS[2:])
        self.assertTrue(self.path("out/a/aone.vtp").exists())
        self.assertTrue(self.path("out/b/bone.vtp").exists())
        self.succeed("maps", "given/", "--segments", "1", *SEGMENTS[2:], "--label-names", "maps/a.ctbl")
        self.assertTrue(self.path("given/b/aone.vtp").exists())


if __name__ == "__main__":
    main()
