# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
# %% [markdown]
# # A function of two variables as a mesh
# A grid of points, two triangles a cell, a colour for each vertex, normals from the gradient.

# %%
import numpy
import raycore

x, z = numpy.meshgrid(numpy.linspace(-3, 3, 200), numpy.linspace(-3, 3, 200))
r = numpy.hypot(x, z)
y = numpy.sinc(r) * 1.5
vertices = numpy.stack([x, y, z], axis=-1).reshape(-1, 3)

# %%
slope_z, slope_x = numpy.gradient(y, z[:, 0], x[0])
normals = numpy.stack([-slope_x, numpy.ones_like(y), -slope_z], axis=-1).reshape(-1, 3)

height = (y - y.min()) / (y.max() - y.min())
colors = numpy.stack([height, 0.35 + 0.4 * height, 1 - height, numpy.ones_like(y)], axis=-1).reshape(-1, 4)

# %%
corner = (numpy.arange(199)[:, None] * 200 + numpy.arange(199)).ravel()
indices = numpy.stack([corner, corner + 200, corner + 1, corner + 1, corner + 200, corner + 201], axis=1)

picture = raycore.render(vertices, indices, normals=normals, colors=colors, color=(1, 1, 1), eye=(4, 4.5, 6),
                         center=(0, 0, 0))

# %%
with open("mesh_of_numbers.ppm", "wb") as file:
    file.write(b"P6 %d %d 255\n" % (picture.shape[1], picture.shape[0]) + picture.tobytes())
