#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Prints libFuzzer's dictionary for fuzz_api: tokens as its inputs have them (input.h), the low byte first. Those of
# EGL also as integers, which lists of attributes are made of.
set -eu
cd "$(dirname "$0")/../.."

# tokens PREFIX FILE...: name and eight digits of every token
tokens() {
  sed -nE "s/^#define ($1_[A-Za-z0-9_]+)[ \t]+0x([0-9A-Fa-f]{4,8})\b.*/\1 0000\2/p" "${@:2}" |
    sed -E 's/ .*(.{8})$/ \1/'
}
short='(.*) 0000(..)(..)' long='(.*) (..)(..)(..)(..)'
tokens RC include/RC/rctokens.h | sed -E "s/^$short\$/\1=\"\\\\x\3\\\\x\2\"/; s/^$long\$/\1=\"\\\\xff\\\\xff\\\\x\5\\\\x\4\\\\x\3\\\\x\2\"/"
tokens EGL /usr/include/EGL/egl.h /usr/include/EGL/eglext.h |
  sed -nE "s/^$short\$/\1=\"\\\\x\3\\\\x\2\"\n\1_i=\"\\\\xfe\\\\x\3\\\\x\2\"/p"
