# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
# %% [markdown]
# # A first picture
# Three vertices in, an array of bytes out: row 0 is the top of the picture.

# %%
import numpy
import raycore

triangle = numpy.array([[-1, -1, 0], [1, -1, 0], [0, 1, 0]])
picture = raycore.render(triangle, color=(1.0, 0.6, 0.1))
print(picture.shape, picture.dtype)

# %% [markdown]
# Any library that takes arrays shows it or writes it. Without one, a PPM file is a line and the bytes:

# %%
with open("first_picture.ppm", "wb") as file:
    file.write(b"P6 %d %d 255\n" % (picture.shape[1], picture.shape[0]) + picture.tobytes())
