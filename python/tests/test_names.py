# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Every function of C has its name in Python, every token its value, every name a stub."""
import ast
import pathlib
import re
import subprocess
import sys

import pytest
import raycore

PYTHON = pathlib.Path(__file__).resolve().parents[1]
TREE = PYTHON.parent

# Names that the rule does not make; and what Python needs no function for.
SPECIAL = {
    "rcTexImage2D": "tex_image_2d",
    "rcTexSubImage2D": "tex_sub_image_2d",
    "rcCopyTexImage2D": "copy_tex_image_2d",
    "rcCopyTexSubImage2D": "copy_tex_sub_image_2d",
    "rcCompressedTexImage2D": "compressed_tex_image_2d",
    "rcSetSPPCount": "set_spp_count",
    "rcGetBufferParameteriv": "get_buffer_parameter",
    "rcColor4ub": "color",
}
LEFT_OUT = {
    "rcCompressedTexSubImage2D": "no format can be changed in part: it always fails",
    "rcGetPointerv": "pointers are arrays in Python",
    "rcDebugMessageCallbackRCX": "its messages are those of raycore.Error",
}


def python_name(name):
    """rcTranslatef: translate. rcuLookAt: look_at. rcGetFixedv: its twin get_float."""
    if name in SPECIAL:
        return SPECIAL[name]
    name = re.sub(r"^rcu?(?=[A-Z])", "", name)
    name = re.sub(r"(OES|RCX)$", "", name)
    name = re.sub(r"^GetFixedv$", "GetFloatv", name)
    if not name.endswith("Matrix"):
        name = re.sub(r"(?<=[a-z])[1-4]?(f|x|i|fv|xv|iv|v)$", "", name)
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def c_functions():
    text = (TREE / "src/api/functions.inc").read_text(encoding="utf-8")
    return re.findall(r"^RC_FUNCTION\([^,]+, (rcu?[A-Z]\w*),", text, re.MULTILINE)


def test_every_function_of_c_is_there():
    functions = c_functions()
    assert len(functions) > 150
    missing = [f"{f}: {python_name(f)}" for f in functions if f not in LEFT_OUT and not hasattr(raycore, python_name(f))]
    assert not missing


def test_every_token_is_there():
    made = subprocess.run([sys.executable, PYTHON / "tokens.py", TREE / "include/RC/rctokens.h"],
                          capture_output=True, text=True, check=True).stdout
    assert made == (PYTHON / "raycore/_tokens.py").read_text(encoding="utf-8"), "run tokens.py"
    assert raycore.LIGHT3 == 0x4003


def stub_names(file):
    tree = ast.parse((PYTHON / "raycore" / file).read_text(encoding="utf-8"))
    return {node.name for node in tree.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


@pytest.mark.parametrize("file, module", [("_core.pyi", "raycore._core"), ("__init__.pyi", "raycore._draw")])
def test_every_name_has_a_stub(file, module):
    found = sys.modules[module]
    public = {name for name in vars(found) if not name.startswith("_")}
    own = {name for name in public if getattr(getattr(found, name), "__module__", "").startswith("raycore")}
    assert own <= stub_names(file) | stub_names("_core.pyi")
    assert stub_names(file) <= public
