# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
from contextlib import AbstractContextManager
from typing import Optional, Sequence, Tuple

import numpy
from numpy.typing import ArrayLike, NDArray

from ._core import *
from ._core import Context as Context, Error as Error
from ._tokens import *

__version__: str

def matrix(mode: Optional[int] = ...) -> AbstractContextManager[None]: ...
def static_scene() -> AbstractContextManager[None]: ...
def bound_material(name: Optional[int] = ...) -> AbstractContextManager[int]: ...
def draw(
    vertices: ArrayLike,
    indices: Optional[ArrayLike] = ...,
    *,
    normals: Optional[ArrayLike] = ...,
    texcoords: Optional[ArrayLike] = ...,
    colors: Optional[ArrayLike] = ...,
    mode: int = ...,
) -> None: ...
def picture(format: int = ...) -> NDArray[numpy.uint8]: ...
def render(
    vertices: ArrayLike,
    indices: Optional[ArrayLike] = ...,
    *,
    normals: Optional[ArrayLike] = ...,
    texcoords: Optional[ArrayLike] = ...,
    colors: Optional[ArrayLike] = ...,
    texture: Optional[ArrayLike] = ...,
    color: Sequence[float] = ...,
    reflection: float = ...,
    eye: Optional[ArrayLike] = ...,
    center: Optional[ArrayLike] = ...,
    up: ArrayLike = ...,
    fovy: float = ...,
    light: Optional[ArrayLike] = ...,
    background: Sequence[float] = ...,
    size: Tuple[int, int] = ...,
    samples: int = ...,
) -> NDArray[numpy.uint8]: ...
