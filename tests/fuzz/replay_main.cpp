// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Runs a fuzz target on every file of the folders that are named, in the order of their names: the corpus as a test,
// without libFuzzer. With RAYCORE_FUZZ_VERBOSE each file is named before it is run. Exit code 77 where there are none.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

namespace {

std::vector<std::string> filesIn(const std::string &folder) {
  std::vector<std::string> files;
  if (!std::filesystem::exists(folder)) return files;
  if (!std::filesystem::is_directory(folder)) return {folder};
  for (const auto &entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void run(const std::string &name) {
  if (std::getenv("RAYCORE_FUZZ_VERBOSE")) std::fprintf(stderr, "%s\n", name.c_str());
  std::ifstream file(name, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t *>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char **arguments) {
  size_t files = 0;
  for (int i = 1; i < count; ++i) {
    for (const std::string &name : filesIn(arguments[i])) {
      run(name);
      ++files;
    }
  }
  std::printf("%zu inputs\n", files);
  constexpr int kSkipped = 77;
  return files > 0 ? EXIT_SUCCESS : kSkipped;
}
