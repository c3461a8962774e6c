# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Errors are exceptions, blocks restore what they change, pictures are arrays."""
import threading

import numpy
import pytest
import raycore as rc

TRIANGLE = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]]


@pytest.fixture
def context():
    with rc.Context(64, 48) as made:
        rc.look_at((0, 0, 3), (0, 0, 0))
        yield made


def test_errors_name_function_argument_and_what_is_allowed(context):
    with pytest.raises(rc.Error) as caught:
        rc.light(rc.LIGHT0, rc.SPOT_CUTOFF, 95)
    assert str(caught.value) == (
        "rcLightf: RC_INVALID_VALUE: params is 95 for pname RC_SPOT_CUTOFF, not 0 ... 90 degrees or 180")
    assert caught.value.code == rc.INVALID_VALUE
    assert rc.get_error() == rc.NO_ERROR


def test_without_a_context_calls_say_so():
    with pytest.raises(rc.Error, match="no context is current"):
        rc.enable(rc.LIGHTING)


def test_values_are_counted(context):
    with pytest.raises(ValueError, match="light: parameter 0x1203 takes 4 values, got 3"):
        rc.light(rc.LIGHT0, rc.POSITION, (1, 2, 3))
    rc.light(rc.LIGHT0, rc.POSITION, (1, 2, 3, 1))
    assert rc.get_light(rc.LIGHT0, rc.POSITION).tolist() == [1, 2, 3, 1]
    rc.material(rc.DIFFUSE, numpy.array([0.25, 0.5, 0.75]))
    assert rc.get_material(rc.DIFFUSE)[:3].tolist() == [0.25, 0.5, 0.75]


def test_gets_return_as_much_as_there_is(context):
    rc.translate(1, 2, 3)
    assert rc.get_float(rc.MODELVIEW_MATRIX)[:3, 3].tolist() == [1, 2, 3]
    assert rc.get_integer(rc.VIEWPORT).tolist() == [0, 0, 64, 48]
    assert rc.get_integer(rc.MAX_LIGHTS) == 8
    assert rc.get_boolean(rc.COLOR_WRITEMASK) == [True] * 4
    assert rc.get_string(rc.RENDERER) == "RayCore"


def test_matrices_are_those_of_mathematics(context):
    move = numpy.eye(4)
    move[:3, 3] = 4, 5, 6
    rc.load_matrix(move)
    assert rc.get_float(rc.MODELVIEW_MATRIX).tolist() == move.tolist()


def test_matrix_blocks_restore_also_after_exceptions(context):
    with pytest.raises(KeyError):
        with rc.matrix():
            rc.scale(2, 2, 2)
            raise KeyError
    assert rc.get_float(rc.MODELVIEW_MATRIX).tolist() == numpy.eye(4).tolist()
    assert rc.get_integer(rc.MODELVIEW_STACK_DEPTH) == 1


def test_static_scenes_stay_and_dynamic_geometry_goes(context):
    with rc.static_scene():
        rc.draw(TRIANGLE)
    first = rc.picture()
    context.swap()
    assert (rc.picture() == first).all()
    rc.scene_all_init()
    assert rc.picture().max() == 0


def test_half_a_static_scene_is_none(context):
    with pytest.raises(KeyError):
        with rc.static_scene():
            rc.draw(TRIANGLE)
            raise KeyError
    assert rc.picture().max() == 0


def test_material_blocks_bind_the_one_before(context):
    with rc.bound_material() as name:
        assert rc.get_integer(rc.MATERIAL_BINDING) == name != 0
    assert rc.get_integer(rc.MATERIAL_BINDING) == 0


def test_contexts_nest_and_share(context):
    texture = rc.gen_textures(1)[0]
    with rc.Context(32, 16, share=context) as inner:
        assert (inner.width, inner.height) == (32, 16)
        assert rc.is_texture(texture)
        assert rc.picture().shape == (16, 32, 3)
    assert rc.picture().shape == (48, 64, 3)


def test_closed_contexts_are_refused():
    context = rc.Context(16, 16)
    context.close()
    context.close()
    with pytest.raises(RuntimeError, match="the context is closed"):
        context.make_current()


@pytest.mark.parametrize("arguments", [(0, 5), (5, -1), (20000, 5)])
def test_sizes_are_checked(arguments):
    with pytest.raises(ValueError, match="width, height: 1 ... 16384 expected"):
        rc.Context(*arguments)


def test_samples_are_checked():
    with pytest.raises(ValueError, match="samples: 1, 4, 8 or 16 expected, got 99"):
        rc.Context(16, 16, samples=99)


def test_pictures_begin_at_the_top(context):
    rc.draw(numpy.array(TRIANGLE) * 0.5 + [0, 0.6, 0])
    rows = rc.picture().max(axis=(1, 2)) > 0
    assert rows[: len(rows) // 2].sum() > rows[len(rows) // 2 :].sum()


def test_rays_tell_what_they_meet(context):
    """A triangle in the plane z = 0, the eye in front of it: seen in the middle, not in the upper corners."""
    rc.perspective(60, 1, 1, 100)
    rc.look_at((0, 0, 3), (0, 0, 0))
    rc.draw([[-1, -1, 0], [1, -1, 0], [0, 1, 0]])
    _, _, width, height = (int(number) for number in rc.get_integer(rc.VIEWPORT))
    distances = rc.read_rays(0, 0, width, height, rc.RAY_DISTANCE)
    assert distances.shape == (height, width) and distances.dtype == numpy.float32
    assert abs(distances[height // 2, width // 2] - 3) < 0.01
    assert distances[0, 0] == distances[0, -1] == -1
    with pytest.raises(rc.Error, match="nothing that a ray tells"):
        rc.read_rays(0, 0, 1, 1, rc.RGBA)


def test_textures_show(context):
    red = numpy.zeros((16, 16, 3), dtype=numpy.uint8)
    red[..., 0] = 255
    found = rc.render(TRIANGLE, texcoords=[[0, 0], [1, 0], [0, 1]], texture=red, size=(64, 48), background=(0, 0, 1))
    middle = found[26, 32]
    assert middle[0] > 100 and middle[1] == 0 and middle[2] == 0


def test_render_is_the_same_each_time_and_frames_the_mesh():
    vertices = numpy.array(TRIANGLE) * 7 + 100
    first = rc.render(vertices, [[0, 1, 2]], size=(64, 48))
    assert first.shape == (48, 64, 3) and first.dtype == numpy.uint8
    assert (first == rc.render(vertices, size=(64, 48))).all()
    assert 200 < (first != first[0, 0]).any(axis=2).sum() < 48 * 64


@pytest.mark.parametrize(
    "vertices, text",
    [([], r"vertices: shape \(n, 3\), n > 0 expected"), ([[0, 0, float("nan")]], "vertices: finite numbers expected")],
)
def test_render_refuses_what_is_no_mesh(vertices, text):
    with pytest.raises(ValueError, match=text):
        rc.render(vertices)


def test_threads_have_contexts_of_their_own():
    results = {}

    def work(index):
        results[index] = rc.render(TRIANGLE, size=(48, 32), color=(1, 0, 0))

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert len(results) == 4
    assert all((results[i] == results[0]).all() for i in range(4))
