# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""The RayCore ray tracing API.

    import raycore
    picture = raycore.render([[-1, -1, 0], [1, -1, 0], [0, 1, 0]])   # numpy: (480, 800, 3), uint8

The functions are those of C without `rc` and without the letters that say the type of the arguments
(`rcTranslatef` is `translate`), tokens are without `RC_`. Failing calls raise `raycore.Error`.
"""
from ._core import *  # noqa: F401,F403
from ._core import Context, Error
from ._draw import bound_material, draw, matrix, picture, render, static_scene
from ._tokens import *  # noqa: F401,F403

__version__ = "0.1.0"
__all__ = [name for name in globals() if not name.startswith("_")]
