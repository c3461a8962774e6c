// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// The loaders' process. Files come from anywhere, and the libraries that read them (Assimp, OpenImageIO and what those
// use) have had their share of crashes, endless loops and allocations that follow a lying count. So they run in a
// process of their own, with limits of processor time and memory that grow with the file, and hand the scene back as
// bytes. What goes wrong there is a message here. It is a plain fork: a new program would spend more time on starting
// than most files take to read. Threads of ours, where there are some (`view`), are idle meanwhile.
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <string_view>

#include "codec/picture.h"
#include "input/error.h"
#include "input/file.h"
#include "load/archive.h"
#include "load/load.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define RAYCORE_SHADOW_MEMORY 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define RAYCORE_SHADOW_MEMORY 1
#endif
#endif

namespace rc::tool {
namespace {

constexpr size_t kMiB = 1 << 20;
constexpr char kScene = 'S', kRejected = 'E';

struct Limits {
  rlim_t seconds;
  rlim_t bytes;
};

// A small file that needs more than this is not a small file; half a second goes by loading the picture formats.
Limits limitsFor(const std::string &name) {
  std::error_code error;
  const auto size = std::filesystem::is_regular_file(name, error) ? std::filesystem::file_size(name, error) : 0;
  return {3 + rlim_t(size / (kMiB / 2)), rlim_t(900 * kMiB + 100 * size)};
}

void limit(int resource, rlim_t soft) {
  rlimit now{};
  getrlimit(resource, &now);
  now.rlim_cur = now.rlim_max == RLIM_INFINITY ? soft : std::min(soft, now.rlim_max);
  setrlimit(resource, &now);
}

class Descriptor {
 public:
  explicit Descriptor(int number) : mNumber(number) {}
  ~Descriptor() {
    if (mNumber >= 0) close(mNumber);
  }
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;
  int number() const { return mNumber; }

 private:
  int mNumber;
};

void enterSandbox(const Limits &limits) {
  limit(RLIMIT_CPU, limits.seconds);
  limit(RLIMIT_CORE, 0);
#ifndef RAYCORE_SHADOW_MEMORY  // of a sanitizer, which is larger than any limit
  limit(RLIMIT_AS, limits.bytes);
#endif
  // Libraries print what they return as well; RAYCORE_LOG=debug shows it.
  const char *log = std::getenv("RAYCORE_LOG");
  const int nowhere = log && std::string_view(log) == "debug" ? -1 : open("/dev/null", O_WRONLY);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
}

int waitFor(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void explain(int status, const Limits &limits) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    reject("reading it takes more than {} s of processor time: given up", limits.seconds);
  }
  if (WIFSIGNALED(status)) reject("the reader crashed on it ({}): it is damaged", strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0) reject("the reader failed on it (exit code {})", WEXITSTATUS(status));
}

std::string contentOf(int descriptor) {
  struct stat about {};
  fstat(descriptor, &about);
  std::string bytes(size_t(about.st_size), '\0');
  size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = pread(descriptor, bytes.data() + done, bytes.size() - done, off_t(done));
    if (got <= 0) reject("the reader's answer is cut short");
    done += size_t(got);
  }
  return bytes;
}

void answerWith(int descriptor, char kind, std::string_view bytes) {
  std::string all(1, kind);
  all += bytes;
  for (size_t done = 0; done < all.size();) {
    const ssize_t got = write(descriptor, all.data() + done, all.size() - done);
    if (got <= 0) _exit(3);
    done += size_t(got);
  }
}

using Read = Scene (*)(const std::string &name);

[[noreturn]] void runSandboxed(const std::string &name, Read read, int answer, const Limits &limits) {
  enterSandbox(limits);
  try {
    answerWith(answer, kScene, packed(read(name)));
  } catch (const std::bad_alloc &) {
    answerWith(answer, kRejected, "reading it takes more memory than a file of its size should need: given up");
  } catch (const std::exception &error) {
    answerWith(answer, kRejected, error.what());
  }
  _exit(0);  // no destructors of libraries that a bad file may have upset
}

Scene load(const std::string &name, Read read) {
  if (name != "-" && access(name.c_str(), R_OK) != 0) reject("cannot be opened: {}", std::strerror(errno));
  const Limits limits = limitsFor(name);
  const Descriptor answer(memfd_create("raycore-scene", 0));
  if (answer.number() < 0) reject("no memory for the scene: {}", std::strerror(errno));
  const pid_t child = fork();
  if (child == 0) runSandboxed(name, read, answer.number(), limits);
  if (child < 0) reject("cannot start the reader: {}", std::strerror(errno));
  explain(waitFor(child), limits);
  const std::string bytes = contentOf(answer.number());
  if (bytes.empty()) reject("the reader said nothing about it");
  if (bytes[0] == kRejected) throw InputError(bytes.substr(1));
  return unpacked(std::string_view(bytes).substr(1));
}

Scene readPicture(const std::string &name) {
  Scene scene;
  scene.images.push_back(decodePicture(readFile(name), name));
  return scene;
}

}  // namespace

Scene loadModel(const std::string &name) { return load(name, readModel); }

Image loadPicture(const std::string &name) { return std::move(load(name, readPicture).images.at(0)); }

}  // namespace rc::tool
