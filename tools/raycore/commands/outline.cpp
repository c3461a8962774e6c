// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "commands/outline.h"

#include <algorithm>
#include <sstream>

namespace rc::tool {
namespace {

// "{y,z}" -> the words in the first braces.
std::vector<std::string> choicesIn(const std::string &validator) {
  const size_t first = validator.find('{'), last = validator.find('}');
  std::vector<std::string> choices;
  if (first == validator.npos || last == validator.npos) return choices;
  std::istringstream words(validator.substr(first + 1, last - first - 1));
  for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
  return choices;
}

std::vector<std::string> choicesOf(const CLI::Option &option) {
  try {
    auto &changeable = const_cast<CLI::Option &>(option);  // CLI11 has no other way to ask
    return choicesIn(changeable.get_validator()->get_description());
  } catch (const CLI::OptionNotFound &) {
    return {};
  }
}

OptionOutline outlineOf(const CLI::Option &option) {
  OptionOutline outline;
  for (const std::string &name : option.get_snames()) outline.names.push_back("-" + name);
  for (const std::string &name : option.get_lnames()) outline.names.push_back("--" + name);
  outline.description = option.get_description();
  outline.group = option.get_group();
  if (option.get_items_expected_max() == 0) return outline;
  outline.value = option.get_type_name().substr(0, option.get_type_name().find(':'));
  outline.choices = choicesOf(option);
  outline.file = outline.value == "FILE" || outline.value == "FOLDER";
  return outline;
}

CommandOutline commandOutline(const CLI::App &app) {
  CommandOutline outline;
  outline.name = app.get_name();
  outline.description = app.get_description();
  outline.footer = app.get_footer();
  for (const CLI::Option *option : app.get_options()) {
    if (!option->get_positional()) {
      outline.options.push_back(outlineOf(*option));
      continue;
    }
    outline.argument = option->get_name(true);
    outline.argumentDescription = option->get_description();
    outline.argumentChoices = choicesOf(*option);
  }
  return outline;
}

}  // namespace

Outline outlineOf(const CLI::App &app) {
  const CommandOutline top = commandOutline(app);
  Outline outline{top.description, top.footer, top.options, {}};
  for (const CLI::App *command : app.get_subcommands([](const CLI::App *) { return true; })) {
    outline.commands.push_back(commandOutline(*command));
  }
  return outline;
}

std::string joined(const std::vector<std::string> &words, const std::string &between) {
  std::string text;
  for (const std::string &word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

}  // namespace rc::tool
