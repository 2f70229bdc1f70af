# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""3MF files of other programs: what the build makes is read, and everything else is named."""

import fractions
import re
import struct
import zipfile

from application import REJECTED, ApplicationTest, as_doubles, main, read, sphere, write

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
BEAMS = "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"
MATERIAL = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"
MESH = ("<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='10' y='0' z='0'/><vertex x='0' y='10' z='0'/>"
        "<vertex x='0' y='0' z='10'/></vertices><triangles><triangle v1='0' v2='2' v3='1'/><triangle v1='0' v2='1' v3='3'/>"
        "<triangle v1='1' v2='2' v3='3'/><triangle v1='0' v2='3' v3='2'/></triangles></mesh>")
IDENTITY = "1 0 0 0 1 0 0 0 1 0 0 0"
MOVED = "1 0 0 0 1 0 0 0 1 20 30 40"


def thing(number, content=MESH, more=""):
    return f"<object id='{number}' {more}>{content}</object>"


def components(*references):
    return "<components>" + "".join(f"<component {r}/>" for r in references) + "</components>"


def model(objects, items, attributes="unit='millimeter'"):
    build = "".join(f"<item {item}/>" for item in items)
    return f"<?xml version='1.0'?><model xmlns='{CORE}' {attributes}><resources>{objects}</resources><build>{build}</build></model>"


class ThreeMf(ApplicationTest):
    def pack(self, text, name="in.3mf", start="3D/3dmodel.model", **parts):
        relationship = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
        with zipfile.ZipFile(self.path(name), "w", zipfile.ZIP_DEFLATED) as package:
            package.writestr("_rels/.rels", f"<Relationships><Relationship Target='/{start}' Id='a' Type='{relationship}'/></Relationships>")
            package.writestr(start, text)
            for part, content in parts.items():
                package.writestr(f"3D/{part}.model", content)

    def load(self, *words):
        said = self.succeed("in.3mf", "out.vtp", "--target-reduction", 0, "--measure", "off", *words).stdout
        surface = read(self.path("out.vtp"))
        return surface.GetNumberOfPolys(), surface.GetBounds(), said

    def test_transforms_and_components_move_objects(self):
        for objects, items, triangles, bounds in (
            (thing(1), [f"objectid='1' transform='{IDENTITY}'"], 4, (0, 10, 0, 10, 0, 10)),
            (thing(1), [f"objectid='1' transform='{MOVED}'"], 4, (20, 30, 30, 40, 40, 50)),
            (thing(1), ["objectid='1'", f"objectid='1' transform='{MOVED}'"], 8, (0, 30, 0, 40, 0, 50)),
            (thing(1) + thing(2, components("objectid='1'", f"objectid='1' transform='{MOVED}'")), ["objectid='2'"], 8,
             (0, 30, 0, 40, 0, 50)),
            # The component is turned by a quarter about z and then moved by the item.
            (thing(1) + thing(2, components("objectid='1' transform='0 1 0 -1 0 0 0 0 1 0 0 0'")),
             [f"objectid='2' transform='{MOVED}'"], 4, (10, 20, 30, 40, 40, 50)),
        ):
            with self.subTest(items=items):
                self.pack(model(objects, items))
                self.assertEqual(self.load()[:2], (triangles, bounds))
        self.pack(model(thing(1), [f"objectid='1' transform='{MOVED}'"], "unit='inch'"))
        self.assertEqual(self.load()[1], tuple(25.4 * c for c in (20, 30, 30, 40, 40, 50)))

    def test_a_mirrored_object_is_not_inside_out(self):
        self.pack(model(thing(1), ["objectid='1' transform='-1 0 0 0 1 0 0 0 1 0 0 0'"]))
        self.assertNotIn("inside out", self.load()[2])
        self.assertNotIn("inside out", self.succeed("diagnose", "in.3mf").stdout)

    def test_what_is_not_built_is_named(self):
        far = thing(7, MESH.replace("'10'", "'90'"))
        for objects, items, sentence in (
            (thing(1) + far, ["objectid='1'"], "1 object of the input that the build does not use is not read"),
            (thing(1) + far, ["objectid='1'", "objectid='7' printable='0'"],
             "1 object of the input that is marked as not printable is not read"),
            (thing(1) + far.replace("id='7'", "id='7' type='support'"), ["objectid='1'", "objectid='7'"],
             "1 object of the input of a type for supports is not read"),
            (thing(1) + far.replace("id='7'", "id='7' type='other'") + far.replace("id='7'", "id='8' type='other'"),
             ["objectid='1'", "objectid='7'", "objectid='8'"], "2 objects of the input of another type than model are not read"),
        ):
            with self.subTest(sentence=sentence):
                self.pack(model(objects, items))
                triangles, bounds, said = self.load()
                self.assertEqual((triangles, bounds[1]), (4, 10))
                self.assertIn("warning: " + sentence, said)
        self.pack(model(thing(1), []))
        self.fail_with(REJECTED, "in.3mf", "out.vtp", says="its build has no item")

    def test_slices_are_named_and_a_mesh_that_stands_in_for_them_is_rejected(self):
        space = "xmlns:s='http://schemas.microsoft.com/3dmanufacturing/slice/2015/07' requiredextensions='s'"
        for attributes, says in (("s:slicestackid='9'", ""), ("s:slicestackid='9' s:meshresolution='lowres'", "its mesh is a stand-in")):
            self.pack(model(thing(1).replace("id='1'", "id='1' " + attributes), ["objectid='1'"], space))
            if says:
                self.fail_with(REJECTED, "in.3mf", "out.vtp", says=says)
            else:
                self.assertIn("warning: the slices of the input", self.load()[2])

    def test_required_extensions_are_read_or_named(self):
        self.pack(model(thing(1), ["objectid='1'"], f"xmlns:b='{BEAMS}' requiredextensions='b'"))
        self.fail_with(REJECTED, "in.3mf", "out.vtp", says=f"it requires the extension '{BEAMS}', which is not read")
        self.pack(model(thing(1), ["objectid='1'"], "requiredextensions='q'"))
        self.fail_with(REJECTED, "in.3mf", "out.vtp", says="it requires the extension 'q'")
        beams = MESH.replace("</mesh>", "<b:beamlattice><b:beams><b:beam v1='0' v2='1'/></b:beams></b:beamlattice></mesh>")
        self.pack(model(thing(1, beams), ["objectid='1'"], f"xmlns:b='{BEAMS}' xmlns:m='{MATERIAL}' requiredextensions='m'"))
        self.assertIn("warning: the beam lattices of the input are not read", self.load()[2])

    def test_parts_of_the_production_extension_are_read(self):
        root = thing(1, components(f"p:path='/3D/bone.model' objectid='5' transform='{MOVED}'", "p:path='/3D/bone.model' objectid='6'"))
        part = model(thing(5) + thing(6, components("objectid='5'")), [])
        self.pack(model(root, ["objectid='1'"], f"xmlns:p='{PRODUCTION}' requiredextensions='p'"), bone=part)
        self.assertEqual(self.load()[:2], (8, (0, 30, 0, 40, 0, 50)))
        self.pack(model(root, ["objectid='1'"], f"xmlns:p='{PRODUCTION}' requiredextensions='p'"))
        self.fail_with(REJECTED, "in.3mf", "out.vtp", says="it has no 3D/bone.model")

    def test_the_model_is_where_the_package_says(self):
        self.pack(model(thing(1), ["objectid='1'"]), start="parts/bone one.model")
        self.assertEqual(self.load()[0], 4)

    def test_a_package_without_relationships_has_the_usual_model(self):
        with zipfile.ZipFile(self.path("in.3mf"), "w") as package:
            package.writestr("3D/3dmodel.model", model(thing(1), ["objectid='1'"]))
        self.assertEqual(self.load()[0], 4)

    def test_names_of_core_elements_may_have_a_prefix(self):
        text = model(thing(1), ["objectid='1'"])
        text = re.sub(r"<(/?)([a-z])", r"<\1c:\2", text.replace("<?xml version='1.0'?>", "")).replace("xmlns=", "xmlns:c=")
        self.pack(text)
        self.assertEqual(self.load()[0], 4)

    def test_damaged_builds_are_rejected(self):
        for objects, items, says in (
            (thing(1), ["objectid='2'"], "names the object '2', which is not there"),
            (thing(1) + thing(1), ["objectid='1'"], "two objects have the id '1'"),
            (thing(1), ["objectid='1' transform='1 0 0'"], "a transform is not twelve numbers"),
            (thing(1, components("objectid='1'")), ["objectid='1'"], "its components contain each other"),
            (thing(1, MESH.replace("v3='3'", "v3='4'")), ["objectid='1'"], "a triangle has a vertex that is not there"),
        ):
            with self.subTest(says=says):
                self.pack(model(objects, items))
                self.fail_with(REJECTED, "in.3mf", "out.vtp", says=says)

    def test_components_that_repeat_each_other_take_bounded_memory(self):
        levels = thing(0) + "".join(thing(i, components(*[f"objectid='{i - 1}'"] * 10)) for i in range(1, 12))
        self.pack(model(levels, ["objectid='11'"]))
        self.fail_with(REJECTED, "in.3mf", "out.vtp", says="its components repeat objects to more than a gigabyte", timeout=120)

    def test_a_long_attribute_takes_no_longer_than_a_long_file(self):
        self.pack(model(thing(1, more=f"name='{'bone ' * 4000000}'"), ["objectid='1'"]))
        self.succeed("diagnose", "in.3mf", timeout=60)

    def test_decimals_equal_the_numbers_of_single_precision(self):
        write(as_doubles(sphere()), self.path("in.vtp"))
        self.succeed("in.vtp", "out.3mf", "--max-error", 0.2)
        text = zipfile.ZipFile(self.path("out.3mf")).read("3D/3dmodel.model").decode()
        decimals = re.findall(r'[xyz]="([^"]+)"', text)
        self.assertGreater(len(decimals), 100)
        for decimal in decimals:
            single = struct.unpack("f", struct.pack("f", float(decimal)))[0]
            self.assertEqual(fractions.Fraction(decimal), fractions.Fraction(single), decimal)


if __name__ == "__main__":
    main()
