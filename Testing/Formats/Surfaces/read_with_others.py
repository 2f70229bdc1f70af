# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of PyPI and Debian beside VTK's. make_NAME() gives a function of a path."""

# pylint: disable=import-outside-toplevel
import numpy as np


def rows(values):
    return np.asarray(values, float).tolist()


def make_trimesh():
    import trimesh

    def of_mesh(mesh, transform):
        points = trimesh.transform_points(mesh.vertices, transform) if transform is not None else mesh.vertices
        faces = np.asarray(mesh.faces)
        if transform is not None and np.linalg.det(transform[:3, :3]) < 0:
            faces = faces[:, ::-1]
        result = {"points": rows(points), "faces": faces.tolist()}
        visual = mesh.visual
        if getattr(visual, "kind", None) == "texture" and getattr(visual, "uv", None) is not None:
            result["uv"] = {"of": "points", "values": rows(visual.uv)}
        elif getattr(visual, "kind", None) in ("vertex", "face") and visual.defined:
            kind = visual.kind
            values = visual.vertex_colors if kind == "vertex" else visual.face_colors
            result["colors"] = {"of": "points" if kind == "vertex" else "faces", "values": rows(values)}
        normals = mesh._cache.cache.get("vertex_normals")  # those of the file: otherwise they are computed
        if normals is not None and transform is None:
            result["normals"] = {"of": "points", "values": rows(normals)}
        return result

    def read(path):
        loaded = trimesh.load(str(path), process=False)
        if isinstance(loaded, trimesh.Trimesh):
            return of_mesh(loaded, None)
        parts = []
        for name in loaded.graph.nodes_geometry:
            transform, geometry = loaded.graph[name]
            if isinstance(loaded.geometry[geometry], trimesh.Trimesh):
                parts.append(of_mesh(loaded.geometry[geometry], transform))
        return {**join(parts), "unit": str(loaded.units)}

    return read


def join(parts):
    """Several meshes as one; what all have of uv, normals, colors."""
    if not parts:
        raise ValueError("no mesh")
    points, faces = [], []
    for part in parts:
        faces += [[i + len(points) for i in face] for face in part["faces"]]
        points += part["points"]
    result = {"points": points, "faces": faces}
    for name in ("uv", "normals", "colors"):
        kinds = {part[name]["of"] for part in parts if name in part}
        if len(kinds) == 1 and all(name in part for part in parts):
            result[name] = {"of": kinds.pop(), "values": [v for part in parts for v in part[name]["values"]]}
    return result


def make_pymeshlab():
    import pymeshlab

    def read(path):
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(str(path))
        parts = []
        for mesh in meshes:
            if mesh.face_number() == 0 and mesh.vertex_number() > 0 and not hasattr(mesh, "polygonal_face_list"):
                continue
            points = mesh.vertex_matrix()
            transform = mesh.transform_matrix()
            points = points @ transform[:3, :3].T + transform[:3, 3]
            faces = mesh.face_matrix().tolist()
            if np.linalg.det(transform[:3, :3]) < 0:
                faces = [face[::-1] for face in faces]
            part = {"points": rows(points), "faces": faces}
            if mesh.has_vertex_color():
                part["colors"] = {"of": "points", "values": rows(np.round(mesh.vertex_color_matrix() * 255))}
            elif mesh.has_face_color():
                part["colors"] = {"of": "faces", "values": rows(np.round(mesh.face_color_matrix() * 255))}
            if mesh.has_wedge_tex_coord():
                part["uv"] = {"of": "corners", "values": rows(mesh.wedge_tex_coord_matrix())}
            elif mesh.has_vertex_tex_coord():
                part["uv"] = {"of": "points", "values": rows(mesh.vertex_tex_coord_matrix())}
            parts.append(part)
        return join(parts)

    return read


def make_assimp():
    import assimp_py

    def part_of(mesh, transform):
        points = np.asarray(mesh.vertices, float).reshape(-1, 3) @ transform[:3, :3].T + transform[:3, 3]
        faces = np.asarray(mesh.indices).reshape(-1, 3)
        if np.linalg.det(transform[:3, :3]) < 0:
            faces = faces[:, ::-1]
        part = {"points": rows(points), "faces": faces.tolist()}
        if mesh.normals is not None and np.allclose(transform, np.eye(4)):
            part["normals"] = {"of": "points", "values": rows(np.asarray(mesh.normals).reshape(-1, 3))}
        if mesh.texcoords:
            values = np.asarray(mesh.texcoords[0], float).reshape(len(points), -1)
            part["uv"] = {"of": "points", "values": rows(values[:, :2])}
        if mesh.colors:
            values = np.asarray(mesh.colors[0], float).reshape(len(points), -1)
            part["colors"] = {"of": "points", "values": rows(np.round(values * 255))}
        return part

    def walk(node, transform, scene, parts):
        transform = transform @ np.asarray(node.transformation, float).reshape(4, 4)
        parts += [part_of(scene.meshes[i], transform) for i in node.mesh_indices]
        for child in node.children:
            walk(child, transform, scene, parts)

    def read(path):
        scene = assimp_py.import_file(str(path), assimp_py.Process_Triangulate)
        parts = []
        walk(scene.root_node, np.eye(4), scene, parts)
        return join(parts)

    return read


def make_lib3mf():
    import lib3mf

    wrapper = lib3mf.get_wrapper()

    def matrix(transform):
        m = np.eye(4)
        m[:, :3] = np.asarray(transform.Fields, float).reshape(4, 3)
        return m  # of row vectors

    def add(item, around, parts):
        if item.IsMeshObject():
            points = np.array([v.Coordinates for v in item.GetVertices()], float).reshape(-1, 3)
            faces = [list(t.Indices) for t in item.GetTriangleIndices()]
            if np.linalg.det(around[:3, :3]) < 0:
                faces = [face[::-1] for face in faces]
            if item.GetType() in (lib3mf.ObjectType.Model, lib3mf.ObjectType.Surface) and len(points):
                parts.append({"points": rows(points @ around[:3, :3] + around[3, :3]), "faces": faces})
            return
        if item.GetType() not in (lib3mf.ObjectType.Model, lib3mf.ObjectType.Surface):
            return
        for i in range(item.GetComponentCount()):
            component = item.GetComponent(i)
            inner = matrix(component.GetTransform()) if component.HasTransform() else np.eye(4)
            add(resolve(component.GetObjectResource()), inner @ around, parts)

    def resolve(resource):
        return resource

    def read(path):
        model = wrapper.CreateModel()
        model.QueryReader("3mf").ReadFromFile(str(path))
        units = {"MicroMeter": 1e-3, "MilliMeter": 1, "CentiMeter": 10, "Inch": 25.4, "Foot": 304.8, "Meter": 1000}
        factor = units[model.GetUnit().name]
        parts, items = [], model.GetBuildItems()
        while items.MoveNext():
            item = items.GetCurrent()
            around = matrix(item.GetObjectTransform()) if item.HasObjectTransform() else np.eye(4)
            add(item.GetObjectResource(), around, parts)
        result = join(parts)
        result["points"] = rows(np.asarray(result["points"]) * factor)
        return result

    return read
