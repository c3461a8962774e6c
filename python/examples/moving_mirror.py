# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
# %% [markdown]
# # Frames: what stays and what moves
# The floor is a static scene, built once. The mirror is drawn anew each frame, and `swap` ends the frame.

# %%
import numpy
import raycore as rc

quad = numpy.array([[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], dtype=numpy.float32)
checkers = numpy.kron(numpy.indices((8, 8)).sum(axis=0) % 2, numpy.ones((8, 8)))
checkers = numpy.stack([60 + 180 * checkers, 50 + 150 * checkers, 90 + 60 * checkers], axis=-1).astype(numpy.uint8)

# %%
frames = []
with rc.Context(320, 192, samples=4) as context:
    rc.clear_color(0.3, 0.45, 0.65)
    rc.perspective(45, 320 / 192)
    rc.look_at((0, 2.5, 6), (0, 0.4, 0))
    rc.enable(rc.LIGHTING)
    rc.enable(rc.LIGHT0)
    rc.light(rc.LIGHT0, rc.POSITION, (3, 6, 4, 1))
    rc.light(rc.LIGHT0, rc.AMBIENT, (0.4, 0.4, 0.4))
    rc.light(rc.LIGHT0, rc.DIFFUSE, (0.7, 0.7, 0.7))
    with rc.static_scene(), rc.bound_material():
        rc.enable(rc.TEXTURE_2D)
        rc.bind_texture(rc.TEXTURE_2D, rc.gen_textures(1)[0])
        rc.tex_image_2d(checkers)
        rc.draw(quad * 4, texcoords=[[0, 0], [1, 0], [1, 1], [0, 1]], mode=rc.QUADS)
    for frame in range(8):
        with rc.bound_material(), rc.matrix():
            rc.disable(rc.TEXTURE_2D)
            rc.material(rc.AMBIENT_AND_DIFFUSE, (0.1, 0.12, 0.15))
            rc.material(rc.REFLECTION, 0.8)
            rc.translate(0, 1, -0.5)
            rc.rotate(frame * 10 - 35, 0, 1, 0)
            rc.rotate(97, 1, 0, 0)
            rc.draw(quad, mode=rc.QUADS)
        frames.append(rc.picture())
        context.swap()

# %%
sheet = numpy.concatenate([numpy.concatenate(frames[:4], axis=1), numpy.concatenate(frames[4:], axis=1)])
with open("moving_mirror.ppm", "wb") as file:
    file.write(b"P6 %d %d 255\n" % (sheet.shape[1], sheet.shape[0]) + sheet.tobytes())
