// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "commands/completions.h"

#include <fmt/format.h>

#include <algorithm>

namespace rc::tool {
namespace {

std::vector<std::string> namesOf(const std::vector<OptionOutline> &options) {
  std::vector<std::string> names;
  for (const OptionOutline &option : options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> namesOf(const std::vector<CommandOutline> &commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CommandOutline &command : commands) names.push_back(command.name);
  return names;
}

// Between single quotes; characters that mean something there get a backslash.
std::string quoted(const std::string &text, const std::string &special) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (special.find(c) != special.npos) result += '\\';
    result += c;
  }
  return result + "'";
}

// Files are what is completed where nothing else is known.
std::string bashValues(const CommandOutline &command, const OptionOutline &option) {
  std::vector<std::string> patterns;
  for (const std::string &name : option.names) patterns.push_back(fmt::format("'{} {}'", command.name, name));
  const std::string reply = !option.choices.empty() ? fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$current\"))",
                                                                  joined(option.choices, " "))
                            : option.file           ? "COMPREPLY=($(compgen -f -- \"$current\"))"
                                                    : ":";
  return fmt::format("    {}) {}; return ;;\n", joined(patterns, " | "), reply);
}

std::string zshOption(const OptionOutline &option) {
  const std::string what = fmt::format("[{}]", option.description);
  std::string value;
  if (!option.value.empty()) {
    value = fmt::format(":{}:{}", option.value,
                        option.file              ? "_files"
                        : option.choices.empty() ? ""
                                                 : "(" + joined(option.choices, " ") + ")");
  }
  std::string text;
  for (const std::string &name : option.names) {
    // Brackets and colons of a description would end it.
    std::string safe;
    for (const char c : what.substr(1, what.size() - 2))
      safe += c == '[' || c == ']' || c == ':' ? std::string("\\") + c : std::string(1, c);
    text += "        " + quoted(fmt::format("{}[{}]{}", name, safe, value), "") + " \\\n";
  }
  return text;
}

std::string fishOption(const std::string &condition, const OptionOutline &option) {
  std::string text = fmt::format("complete -c raycore -n '{}'", condition);
  for (const std::string &name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty()) text += option.file ? " -r -F" : " -x";
  if (!option.choices.empty()) text += fmt::format(" -a '{}'", joined(option.choices, " "));
  return text + " -d " + quoted(option.description, "\\") + "\n";
}

}  // namespace

std::string bashCompletion(const Outline &outline) {
  std::string values, options, arguments;
  for (const CommandOutline &command : outline.commands) {
    for (const OptionOutline &option : command.options) {
      if (!option.value.empty()) values += bashValues(command, option);
    }
    options += fmt::format("    {}) words='{}' ;;\n", command.name, joined(namesOf(command.options), " "));
    if (!command.argumentChoices.empty())
      arguments += fmt::format("    {}) words='{}' ;;\n", command.name, joined(command.argumentChoices, " "));
  }
  return fmt::format(R"(# Completion of raycore for bash; made by `raycore generate bash`.
_raycore() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} words=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W '{} {}' -- "$current"))
    return
  fi
  case "$command $previous" in
{}  esac
  case "$current" in
  -*)
    case "$command" in
{}    esac ;;
  *)
    case "$command" in
{}    *) COMPREPLY=($(compgen -f -- "$current")); return ;;
    esac ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o filenames -F _raycore raycore
)",
                     joined(namesOf(outline.commands), " "), joined(namesOf(outline.options), " "), values, options,
                     arguments);
}

std::string zshCompletion(const Outline &outline) {
  std::string commands, cases;
  for (const CommandOutline &command : outline.commands) {
    commands += "    " + quoted(command.name + ":" + command.description, "") + "\n";
    const std::string action =
        command.argumentChoices.empty() ? "_files" : "(" + joined(command.argumentChoices, " ") + ")";
    std::string options;
    for (const OptionOutline &option : command.options) options += zshOption(option);
    const std::string argument =
        command.argument.empty() ? "" : fmt::format("        ':{}:{}'", command.argument, action);
    if (argument.empty() && options.ends_with(" \\\n")) options.erase(options.size() - 3, 2);
    cases += fmt::format("    {})\n      _arguments \\\n{}{}\n      ;;\n", command.name, options, argument);
  }
  return fmt::format(R"(#compdef raycore
# Completion of raycore for zsh; made by `raycore generate zsh`.
_raycore() {{
  local -a commands
  commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
}}
_raycore "$@"
)",
                     commands, cases);
}

std::string fishCompletion(const Outline &outline) {
  std::string text = "# Completion of raycore for fish; made by `raycore generate fish`.\n";
  for (const OptionOutline &option : outline.options) text += fishOption("__fish_use_subcommand", option);
  for (const CommandOutline &command : outline.commands) {
    text += fmt::format("complete -c raycore -f -n '__fish_use_subcommand' -a {} -d {}\n", command.name,
                        quoted(command.description, "\\"));
    const std::string condition = "__fish_seen_subcommand_from " + command.name;
    if (!command.argumentChoices.empty())
      text += fmt::format("complete -c raycore -f -n '{}' -a '{}'\n", condition, joined(command.argumentChoices, " "));
    for (const OptionOutline &option : command.options) text += fishOption(condition, option);
  }
  return text;
}

}  // namespace rc::tool
