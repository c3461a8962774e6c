#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Completions and manual page: generated.sh TOOL. Each command and option of --help is in all of them, shells accept
# them, and bash completes with its one.
set -u
tool=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
unset DISPLAY
failed=0
say() {
  echo "$*"
  failed=1
}

for kind in bash zsh fish man; do
  "$tool" generate $kind >raycore.$kind || say "generate $kind failed"
done
commands=$("$tool" --help | sed -n '/^Subcommands:/,$p' | sed -nE 's/^  ([a-z]+) +[A-Z].*/\1/p')
[ "$(wc -w <<<"$commands")" -ge 8 ] || say "commands are not found in the help: $commands"
for command in $commands; do
  options=$("$tool" "$command" --help | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
  for option in $options; do
    grep -qE -- "^ *$command\) words='[^']*$option[ ']" raycore.bash || say "bash: no $command $option"
    grep -qF -- "'$option[" raycore.zsh || say "zsh: no $option"
    grep -qE -- "from $command'.* -l ${option#--} " raycore.fish || say "fish: no $command $option"
    grep -qF -- "\\fB$(sed 's/-/\\-/g' <<<"$option")\\fR" raycore.man || say "manual: no $option"
  done
  grep -qF "SS raycore $command" raycore.man || say "manual: no $command"
done

bash -n raycore.bash || say "bash refuses its completion"
command -v zsh >/dev/null && { zsh -n raycore.zsh || say "zsh refuses its completion"; }
command -v fish >/dev/null && { fish -n raycore.fish || say "fish refuses its completion"; }
if command -v man >/dev/null && command -v groff >/dev/null; then
  man -l --warnings -E UTF-8 raycore.man 2>warnings >page || say "man refuses the page"
  [ -s warnings ] && { say "warnings of man:"; head -3 warnings; }
  grep -q -- '--heatmap' page || say "the page lacks an option"
fi

# complete WORD...: what bash offers for the last word
source raycore.bash
complete_words() {
  COMP_WORDS=("$@")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _raycore
  echo "${COMPREPLY[*]:-}"
}
expect() {
  local wanted=$1
  shift
  local got
  got=$(complete_words "$@")
  [ "$got" = "$wanted" ] || say "$*: \"$got\" instead of \"$wanted\""
}
touch model.glb other.obj
expect "render" raycore ren
expect "--overwrite" raycore render --over
expect "matte mirror" raycore render model.glb --ground m
expect "model.glb" raycore info mod
expect "bash" raycore generate b
expect "other.obj" raycore stats model.glb --heatmap oth
expect "" raycore render --size 1
exit $failed
