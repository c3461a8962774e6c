# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""What Python adds: `with` blocks for what C begins and ends, drawing from arrays, a picture in one call."""
import contextlib

import numpy

from . import _core as core
from . import _tokens as rc


@contextlib.contextmanager
def matrix(mode=None):
    """Keeps the current matrix, or that of `mode`, and brings it back."""
    before = core.get_integer(rc.MATRIX_MODE)
    core.matrix_mode(before if mode is None else mode)
    core.push_matrix()
    try:
        yield
    finally:
        core.matrix_mode(before if mode is None else mode)
        core.pop_matrix()
        core.matrix_mode(before)


@contextlib.contextmanager
def static_scene():
    """What is drawn in the block stays until the next static scene, or scene_all_init()."""
    core.static_scene_begin()
    try:
        yield
    except BaseException:
        core.scene_all_init()  # half a scene is none
        raise
    core.static_scene_end()


@contextlib.contextmanager
def bound_material(name=None):
    """Binds a material, a new one without a name, gives its name, and binds the one before again."""
    before = core.get_integer(rc.MATERIAL_BINDING)
    core.bind_material(core.gen_materials(1)[0] if name is None else name)
    try:
        yield core.get_integer(rc.MATERIAL_BINDING)
    finally:
        core.bind_material(before)


def draw(vertices, indices=None, *, normals=None, texcoords=None, colors=None, mode=rc.TRIANGLES):
    """Draws from arrays: vertices (n, 3), normals (n, 3), texcoords (n, 2), colors (n, 4); indices of any shape."""
    given = [
        (core.vertex_pointer, rc.VERTEX_ARRAY, vertices, "vertices"),
        (core.normal_pointer, rc.NORMAL_ARRAY, normals, "normals"),
        (core.tex_coord_pointer, rc.TEXTURE_COORD_ARRAY, texcoords, "texcoords"),
        (core.color_pointer, rc.COLOR_ARRAY, colors, "colors"),
    ]
    count = len(vertices)
    enabled = []
    try:
        for point, token, array, name in given:
            if array is None:
                continue
            if len(array) != count:
                raise ValueError(f"{name}: {count} rows expected, as many as vertices, got {len(array)}")
            point(array)
            core.enable_client_state(token)
            enabled.append(token)
        if indices is None:
            core.draw_arrays(mode, 0, count)
        else:
            core.draw_elements(mode, indices)
    finally:
        for token in enabled:
            core.disable_client_state(token)


def picture(format=rc.RGB):
    """Traces the frame; the picture of the viewport as an array (height, width, 3), or 4 with RGBA, the top row first."""
    core.finish()
    _, _, width, height = (int(number) for number in core.get_integer(rc.VIEWPORT))
    return core.read_pixels(0, 0, width, height, format)


def _frame(vertices, size, fovy):
    """An eye that sees all vertices: somewhat from above and from the right."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    centre = (low + high) / 2
    radius = max(float(numpy.linalg.norm(high - low)) / 2, 1e-6)
    flat = (high - low)[2] < 1e-3 * radius
    towards = numpy.array([0, 0, 1.0] if flat else [0.45, 0.35, 0.82])
    narrow = min(1.0, size[0] / size[1])
    distance = radius / (numpy.sin(numpy.radians(fovy) / 2) * narrow)
    return centre + towards * distance, centre, radius


def render(vertices, indices=None, *, normals=None, texcoords=None, colors=None, texture=None, color=(0.8, 0.8, 0.8),
           reflection=0.0, eye=None, center=None, up=(0, 1, 0), fovy=45.0, light=None, background=(0.12, 0.14, 0.18),
           size=(800, 480), samples=4):
    """Triangles to a picture: an array (height, width, 3) of bytes, the top row first.

    vertices   (n, 3), three in a row a triangle; with indices (m, 3) as these say
    normals, texcoords, colors   a row for each vertex, or nothing
    texture    (h, w, 3 or 4) bytes, sides powers of two from 16 to 1024, for texcoords
    eye, center, up, fovy   the camera; without an eye all is in the picture
    light      its position; without one it stands above and to the left of the eye
    """
    vertices = numpy.asarray(vertices)
    if vertices.ndim != 2 or vertices.shape[1] != 3 or not len(vertices):
        raise ValueError(f"vertices: shape (n, 3), n > 0 expected, got shape {vertices.shape}, dtype {vertices.dtype}")
    if not numpy.isfinite(vertices.astype(float)).all():
        raise ValueError("vertices: finite numbers expected, got inf or nan")
    width, height = size
    found_eye, found_center, radius = _frame(vertices.astype(float), size, fovy)
    eye = numpy.asarray(found_eye if eye is None else eye, dtype=float)
    center = numpy.asarray(found_center if center is None else center, dtype=float)
    if light is None:
        light = eye + radius * numpy.array([-1.2, 1.6, 0.6])
    with core.Context(width, height, samples):
        core.clear_color(*background)
        core.perspective(fovy, width / height, radius / 100, radius * 100)
        core.look_at(eye, center, up)
        core.enable(rc.LIGHTING)
        core.enable(rc.LIGHT0)
        core.light(rc.LIGHT0, rc.AMBIENT, (0.25, 0.25, 0.25))
        core.light(rc.LIGHT0, rc.DIFFUSE, (0.8, 0.8, 0.8))
        core.light(rc.LIGHT0, rc.SPECULAR, (1, 1, 1))
        core.light(rc.LIGHT0, rc.POSITION, (*light, 1))
        with bound_material():
            core.material(rc.AMBIENT_AND_DIFFUSE, color)
            core.material(rc.REFLECTION, reflection)
            if texture is not None:
                core.enable(rc.TEXTURE_2D)
                core.bind_texture(rc.TEXTURE_2D, core.gen_textures(1)[0])
                core.tex_image_2d(texture)
            draw(vertices, indices, normals=normals, texcoords=texcoords, colors=colors)
            return picture()
