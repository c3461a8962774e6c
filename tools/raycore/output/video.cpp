// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "output/video.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "input/error.h"
#include "input/file.h"

namespace rc::tool {
namespace {

namespace fs = std::filesystem;

int runFfmpeg(const std::vector<std::string> &arguments) {
  std::vector<char *> pointers;
  pointers.reserve(arguments.size() + 1);
  for (const std::string &argument : arguments) pointers.push_back(const_cast<char *>(argument.c_str()));
  pointers.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, "ffmpeg", nullptr, nullptr, pointers.data(), environ) != 0) return 127;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

void checkFfmpeg() {
  const char *path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/ffmpeg").c_str(), X_OK) == 0) return;
  }
  reject("films are made by ffmpeg, which is not installed; numbered pictures (-o frame-%04d.png) need no ffmpeg");
}

std::string framesFolder(const std::string &video) { return video + ".frames"; }

void makeVideo(const std::string &frames, const FrameRange &range, double fps, const std::string &video) {
  const fs::path place(video);
  const std::string temporary = (place.parent_path() / (".raycore-" + place.filename().string())).string();
  const bool mp4 = extensionOf(video) == ".mp4";
  std::vector<std::string> arguments{"ffmpeg",
                                     "-loglevel",
                                     "error",
                                     "-nostdin",
                                     "-y",
                                     "-framerate",
                                     std::to_string(fps),
                                     "-start_number",
                                     std::to_string(range.first),
                                     "-i",
                                     frames,
                                     "-frames:v",
                                     std::to_string(range.count()),
                                     "-vf",
                                     "pad=ceil(iw/2)*2:ceil(ih/2)*2"};
  const std::vector<std::string> codec =
      mp4 ? std::vector<std::string>{"-c:v",    "libx264",   "-crf",       "18", "-pix_fmt",
                                     "yuv420p", "-movflags", "+faststart", "-f", "mp4"}
          : std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf",    "24", "-b:v",
                                     "0",    "-pix_fmt",   "yuv420p", "-f", "webm"};
  arguments.insert(arguments.end(), codec.begin(), codec.end());
  arguments.push_back(temporary);
  const int code = runFfmpeg(arguments);
  std::error_code error;
  if (code == 0) fs::rename(temporary, place, error);
  if (code != 0 || error) {
    fs::remove(temporary, error);
    reject("{}: ffmpeg failed (exit code {}); the pictures are kept in {}", video, code, framesFolder(video));
  }
}

}  // namespace rc::tool
