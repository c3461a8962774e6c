// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The manual page, in the macros of man(7).
#include <fmt/format.h>

#include <sstream>

#include "commands/completions.h"

namespace rc::tool {
namespace {

// Backslashes, hyphens and lines that begin like a request mean something to roff.
std::string roff(const std::string &text) {
  std::string result;
  for (const char c : text) {
    const bool first = result.empty() || result.back() == '\n';
    if (first && (c == '.' || c == '\'')) result += "\\&";
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return result;
}

std::string optionText(const OptionOutline &option) {
  std::string names;
  for (const std::string &name : option.names) names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  if (!option.value.empty()) names += " \\fI" + roff(option.value) + "\\fR";
  return fmt::format(".TP\n{}\n{}\n", names, roff(option.description));
}

// Its lines stay lines: examples are among them.
std::string footerText(const std::string &footer) {
  return footer.empty() ? "" : fmt::format(".PP\n.nf\n{}\n.fi\n", roff(footer));
}

std::string commandText(const CommandOutline &command) {
  const std::string argument = command.argument.empty() ? "" : " \\fI" + roff(command.argument) + "\\fR";
  std::string text = fmt::format(".SS raycore {}\n{}\n.PP\n\\fBraycore {}\\fR [options]{}\n", command.name,
                                 roff(command.description) + ".", command.name, argument);
  if (!command.argument.empty())
    text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", roff(command.argument), roff(command.argumentDescription));
  for (const OptionOutline &option : command.options) text += optionText(option);
  return text + footerText(command.footer);
}

}  // namespace

std::string manualPage(const Outline &outline) {
  std::string text = fmt::format(
      ".\\\" SPDX-License-Identifier: Apache-2.0\n.\\\" Made by `raycore generate man`.\n"
      ".TH RAYCORE 1 \"\" \"raycore {}\" \"User Commands\"\n.SH NAME\nraycore \\- render, watch and inspect 3D models\n"
      ".SH SYNOPSIS\n\\fBraycore\\fR \\fIcommand\\fR [options]\n.SH DESCRIPTION\n{}\n.SH OPTIONS\n",
      RAYCORE_VERSION, roff(outline.description));
  for (const OptionOutline &option : outline.options) text += optionText(option);
  text += ".SH COMMANDS\n";
  for (const CommandOutline &command : outline.commands) text += commandText(command);
  return text + ".SH NOTES\n.nf\n" + roff(outline.footer) + "\n.fi\n";
}

}  // namespace rc::tool
