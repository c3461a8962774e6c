# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Arrays are checked, and messages say what was expected and what was given."""
import numpy
import pytest
import raycore as rc

TRIANGLE = numpy.array([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], dtype=numpy.float32)


@pytest.fixture
def context():
    with rc.Context(64, 48) as made:
        rc.look_at((0, 0, 3), (0, 0, 0))
        yield made


def covered():
    return int((rc.picture().max(axis=2) > 0).sum())


@pytest.mark.parametrize(
    "array, error, text",
    [
        (numpy.zeros((4, 2)), ValueError, r"vertices: shape \(n, 3\) expected, got shape \(4, 2\), dtype float64"),
        (numpy.zeros(9), ValueError, r"vertices: shape \(n, 3\) expected, got shape \(9,\)"),
        (numpy.zeros((3, 3), dtype=complex), TypeError, r"vertices: dtype float or int expected, got .*complex128"),
        (numpy.full((3, 3), "x"), TypeError, "vertices: dtype float or int expected"),
    ],
)
def test_wrong_arrays_are_refused(context, array, error, text):
    with pytest.raises(error, match=text):
        rc.draw(array)


@pytest.mark.parametrize("dtype", ["float32", "float64", "int8", "int64", "uint16"])
def test_numbers_of_any_type_draw_the_same(context, dtype):
    rc.draw(numpy.abs(TRIANGLE).astype(dtype) if dtype == "uint16" else TRIANGLE.astype(dtype))
    found = covered()
    rc.draw(numpy.abs(TRIANGLE) if dtype == "uint16" else TRIANGLE)
    assert found == covered()


def test_views_and_lists_are_taken(context):
    rc.draw(TRIANGLE.tolist())
    whole = covered()
    context.swap()
    rc.draw(numpy.repeat(TRIANGLE, 2, axis=0)[::2])
    assert covered() == whole > 250


def test_a_pointer_keeps_its_array_alive(context):
    rc.vertex_pointer(TRIANGLE * 1.0)
    for _ in range(50):
        numpy.full((3, 3), 9e9, dtype=numpy.float32)
    rc.enable_client_state(rc.VERTEX_ARRAY)
    rc.draw_arrays(rc.TRIANGLES, 0, 3)
    assert covered() > 250


def test_draws_past_the_end_are_refused(context):
    rc.vertex_pointer(TRIANGLE)
    rc.enable_client_state(rc.VERTEX_ARRAY)
    with pytest.raises(ValueError, match="300 vertices are needed, array 0x8074 has 3"):
        rc.draw_arrays(rc.TRIANGLES, 0, 300)
    with pytest.raises(ValueError, match="8 vertices are needed"):
        rc.draw_elements(rc.TRIANGLES, [0, 1, 7])
    with pytest.raises(ValueError, match="indices: 0 ... 2147483647 expected, got -1"):
        rc.draw_elements(rc.TRIANGLES, [0, 1, -1])
    with pytest.raises(TypeError, match="indices: dtype int expected"):
        rc.draw_elements(rc.TRIANGLES, [0.0, 1.0, 2.0])


def test_arrays_need_as_many_rows(context):
    with pytest.raises(ValueError, match="normals: 3 rows expected, as many as vertices, got 2"):
        rc.draw(TRIANGLE, normals=TRIANGLE[:2])


def test_buffers_take_offsets_and_nothing_else(context):
    buffer = rc.gen_buffers(1)[0]
    rc.bind_buffer(rc.ARRAY_BUFFER, buffer)
    rc.buffer_data(rc.ARRAY_BUFFER, TRIANGLE)
    assert rc.get_buffer_parameter(rc.ARRAY_BUFFER, rc.BUFFER_SIZE) == 36
    with pytest.raises(ValueError, match="an offset expected"):
        rc.vertex_pointer(TRIANGLE)
    rc.vertex_pointer(0)
    rc.bind_buffer(rc.ARRAY_BUFFER, 0)
    with pytest.raises(ValueError, match="an array expected"):
        rc.vertex_pointer(4096)
    rc.enable_client_state(rc.VERTEX_ARRAY)
    rc.draw_arrays(rc.TRIANGLES, 0, 3)
    assert covered() > 250


@pytest.mark.parametrize("shape", [(16, 16), (16, 16, 2), (16,)])
def test_texels_have_rows_columns_and_channels(context, shape):
    with pytest.raises(ValueError, match=r"pixels: shape \(height, width, 3 or 4\) expected"):
        rc.tex_image_2d(numpy.zeros(shape, dtype=numpy.uint8))
    with pytest.raises(TypeError, match="pixels: dtype uint8 expected"):
        rc.tex_image_2d(numpy.zeros((16, 16, 3)))
