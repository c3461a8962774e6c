# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""The sources of the notebooks run, cell by cell, and their pictures show something."""
import pathlib
import runpy

import numpy
import pytest

EXAMPLES = sorted((pathlib.Path(__file__).resolve().parents[1] / "examples").glob("*.py"))


def read_ppm(file):
    head, pixels = file.read_bytes().split(b"\n", 1)
    _, width, height, _ = head.split()
    return numpy.frombuffer(pixels, dtype=numpy.uint8).reshape(int(height), int(width), 3)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example(example, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert example.read_text(encoding="utf-8").count("# %%") >= 3
    runpy.run_path(str(example), run_name="__main__")
    picture = read_ppm(tmp_path / f"{example.stem}.ppm")
    assert len(numpy.unique(picture.reshape(-1, 3), axis=0)) > 20
    assert (picture != picture[0, 0]).any(axis=2).mean() > 0.05


def test_there_are_examples():
    assert len(EXAMPLES) >= 3
