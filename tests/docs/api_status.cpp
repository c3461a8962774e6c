// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Makes docs/api_status.md out of the table of functions.
//
//   api_status_program --write FILE   writes it
//   api_status_program --check FILE   fails where FILE is not what --write would write
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "api/functions.h"

using namespace rc::api;

namespace {

constexpr const char *kHead =
    R"(<!-- Generated from src/api/functions.inc by the build target api_status: do not edit. -->
# API status

Every `rc*` and `rcu*` function. What they do in detail: the pages in [reference](reference/). `egl*`:
[EGL](reference/egl.md). What the specification leaves open: [decisions](decisions.md). What goes beyond the vendor's
API, by name: [extensions](extensions/README.md).

- **acts**: changes or reads what is traced. **stored without effect**: checked, kept and returned; pictures do not
  depend on it. **accepted**: any call is fine and does nothing. **beyond**: not part of the vendor's API.
- Source: *S n.m*: API Specifications; *guide*: Programming Guide or header; *OpenGL ES 1.1, beyond the guide*;
  *extension of our own*.
- Errors: IE `RC_INVALID_ENUM`, IV `RC_INVALID_VALUE`, IO `RC_INVALID_OPERATION`, OOM `RC_OUT_OF_MEMORY`, SO
  `RC_STACK_OVERFLOW`, SU `RC_STACK_UNDERFLOW`. Without a current context each call does nothing, and `rcGetError`
  says `RC_INVALID_OPERATION`.
)";

constexpr struct {
  Effect effect;
  const char *text;
} kEffects[] = {{Effect::Acts, "acts"}, {Effect::Stored, "stored without effect"}, {Effect::Accepted, "accepted"}};

const char *textOf(Effect effect) {
  return std::find_if(std::begin(kEffects), std::end(kEffects), [&](const auto &row) { return row.effect == effect; })
      ->text;
}

bool isBeyond(const FunctionRow &row) { return row.source == "GL" || row.source == "X"; }

std::string sourceOf(const FunctionRow &row) {
  if (row.source == "X") return "extension of our own";
  if (isBeyond(row)) return "OpenGL ES 1.1, beyond the guide";
  return row.source == "G" ? "guide" : std::string(row.source);
}

std::string errorsOf(const FunctionRow &row) {
  std::string text;
  for (const char letter : row.errors) text += letter == ' ' ? ", " : std::string(1, letter);
  return text;
}

template <class Condition>
long count(Condition &&condition) {
  return std::count_if(functions().begin(), functions().end(), condition);
}

void writeCounts(std::ostream &out) {
  out << "\n| functions | of the vendor's API | beyond | all |\n|---|---|---|---|\n";
  const auto line = [&](const char *text, auto &&condition) {
    const long all = count(condition);
    const long beyond = count([&](const FunctionRow &row) { return condition(row) && isBeyond(row); });
    out << "| " << text << " | " << all - beyond << " | " << beyond << " | " << all << " |\n";
  };
  for (const auto &[effect, text] : kEffects) {
    line(text, [effect = effect](const FunctionRow &row) { return row.effect == effect; });
  }
  line("all", [](const FunctionRow &) { return true; });
}

std::string document() {
  std::ostringstream out;
  out << kHead;
  writeCounts(out);
  out << "\n| function | what it does | source | errors | note |\n|---|---|---|---|---|\n";
  for (const FunctionRow &row : functions()) {
    out << "| `" << row.name << "` | " << textOf(row.effect) << (isBeyond(row) ? ", beyond" : "") << " | "
        << sourceOf(row) << " | " << errorsOf(row) << " | " << row.note << " |\n";
  }
  return out.str();
}

bool write(const char *file) {
  std::ofstream out(file);
  out << document();
  out.close();
  if (!out) std::cerr << file << " cannot be written\n";
  return bool(out);
}

bool check(const char *file) {
  std::ifstream in(file);
  const std::string found{std::istreambuf_iterator<char>(in), {}};
  if (found == document()) return true;
  std::cerr << file << " is not what src/api/functions.inc says; build the target api_status\n";
  return false;
}

}  // namespace

int main(int argc, char **argv) {
  const std::string mode = argc == 3 ? argv[1] : "";
  if (mode == "--write") return write(argv[2]) ? 0 : 1;
  if (mode == "--check") return check(argv[2]) ? 0 : 1;
  std::cerr << "usage: " << argv[0] << " --write|--check FILE\n";
  return 2;
}
