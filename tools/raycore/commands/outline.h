// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// outline.h: the commands and options as data, read from CLI11's definitions: what completions and the manual page are
// made of, so that they cannot fall behind.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace rc::tool {

struct OptionOutline {
  std::vector<std::string> names;  // "-o", "--output"
  std::string value;               // what the value is called; empty: a flag
  std::string description, group;
  std::vector<std::string> choices;  // if there are only these
  bool file = false;                 // the value is a file or a folder
};

struct CommandOutline {
  std::string name, description, footer;
  std::string argument;  // "model"; empty: none
  std::string argumentDescription;
  std::vector<std::string> argumentChoices;
  std::vector<OptionOutline> options;
};

struct Outline {
  std::string description, footer;
  std::vector<OptionOutline> options;
  std::vector<CommandOutline> commands;
};

Outline outlineOf(const CLI::App &app);

std::string joined(const std::vector<std::string> &words, const std::string &between);

}  // namespace rc::tool
