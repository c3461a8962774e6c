// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore render: pictures, numbered pictures, films.
#include <csignal>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "commands/commands.h"
#include "commands/load_options.h"
#include "commands/show_options.h"
#include "input/error.h"
#include "output/picture_file.h"
#include "output/progress.h"
#include "output/sequence.h"
#include "output/video.h"

namespace rc::tool {
namespace {

constexpr int kInterrupted = 130;

constexpr const char *kExamples =
    "Examples:\n"
    "  raycore render duck.glb -o duck.png --size 1280x720 --samples 16\n"
    "  raycore render car.gltf -o car.jpg --camera 0 --background sky.jpg --ground mirror\n"
    "  raycore render fox.glb -o walk-%04d.png --animation Walk --frames 0-47 --fps 24\n"
    "  raycore render fox.glb -o walk.mp4 --animation 1\n"
    "Frames that exist and are whole are not made again: an interrupted command goes on where it was.";

struct RenderOptions {
  std::string input, output, frames;
  ShowSettings show;
  double fps = 30, time = 0;
  bool overwrite = false, json = false;
  LoadOptions load;
};

volatile std::sig_atomic_t gInterrupted = 0;

// The first Ctrl-C lets the frame be finished, the second one ends the process.
void finishFrameOnInterrupt() {
  struct sigaction action {};
  action.sa_handler = [](int) { gInterrupted = 1; };
  action.sa_flags = int(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void report(const RenderOptions &options, const Show &show, const std::string &file, int frame) {
  const Statistics &s = show.statistics();
  if (options.json) {
    const nlohmann::ordered_json line{{"frame", frame},
                                      {"file", file},
                                      {"triangles", s.triangles},
                                      {"rays", s.rays},
                                      {"build_s", s.buildSeconds},
                                      {"trace_s", s.traceSeconds}};
    fmt::print("{}\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    std::fflush(stdout);
  } else if (options.load.verbose) {
    fmt::print(stderr, "{}: {} triangles, {} rays, built in {:.3f} s, traced in {:.3f} s\n", file, s.triangles, s.rays,
               s.buildSeconds, s.traceSeconds);
  }
}

// Frames that are there may be of another model or other options: that they are kept is said.
std::vector<int> missingFrames(const RenderOptions &options, const FrameRange &range, const std::string &pattern) {
  std::vector<int> missing;
  for (int frame = range.first; frame <= range.last; ++frame) {
    const std::string file = fileOfFrame(pattern, frame);
    if (options.overwrite || !isWholePicture(file, options.show.width, options.show.height)) missing.push_back(frame);
  }
  const int kept = range.count() - int(missing.size());
  if (kept > 0 && !options.load.quiet) {
    fmt::print(stderr, "raycore: {} of {} frames are there already and are kept (--overwrite makes them again)\n", kept,
               range.count());
  }
  return missing;
}

// Makes what is missing; false after an interruption.
bool makeFrames(const RenderOptions &options, Show &show, const FrameRange &range, const std::string &pattern) {
  const std::vector<int> missing = missingFrames(options, range, pattern);
  Progress progress("frame", int(missing.size()), options.load.quiet);
  long long rays = 0;
  double seconds = 0;
  for (size_t i = 0; i < missing.size(); ++i) {
    const std::string file = fileOfFrame(pattern, missing[i]);
    writePicture(show.picture(float(missing[i] / options.fps)), file);
    rays += show.statistics().rays;
    seconds += show.statistics().traceSeconds;
    report(options, show, file, missing[i]);
    progress.done(int(i) + 1, rays, seconds);
    if (gInterrupted && i + 1 < missing.size()) return false;
  }
  return true;
}

int interrupted(const RenderOptions &options) {
  fmt::print(stderr, "raycore: interrupted; the frames so far are kept, the same command goes on{}\n",
             options.overwrite ? " without --overwrite" : "");
  return kInterrupted;
}

int renderStill(const RenderOptions &options, Show &show) {
  writePicture(show.picture(float(options.time)), options.output);
  report(options, show, options.output, 0);
  return 0;
}

int renderVideo(const RenderOptions &options, Show &show, const FrameRange &range) {
  const std::string folder = framesFolder(options.output), pattern = folder + "/frame-%06d.png";
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (error) reject("{}: cannot be made: {}", folder, error.message());
  if (!makeFrames(options, show, range, pattern)) return interrupted(options);
  makeVideo(pattern, range, options.fps, options.output);
  std::filesystem::remove_all(folder, error);
  return 0;
}

FrameRange wholeAnimation(const Show &show, double fps) {
  if (show.animation() < 0) return {};
  const float end = show.scene().animations[size_t(show.animation())].duration();
  return {0, std::max(0, int(std::ceil(end * fps)) - 1)};
}

void check(const RenderOptions &options) {
  if (isVideo(options.output)) return checkFfmpeg();
  checkPictureName(options.output);
  if (options.output != "-") return;
  if (!options.frames.empty()) refuseOption("numbered pictures need files: -o NAME-%04d.png");
  if (options.json) refuseOption("--json and the picture would both go to standard output: name a file");
}

bool isSequence(const RenderOptions &options) { return !options.frames.empty() || isNumbered(options.output); }

// A film or a sequence plays the first animation unless another is named.
void chooseAnimation(const Scene &scene, RenderOptions &options) {
  const bool moves = isVideo(options.output) || isSequence(options) || options.time != 0;
  if (moves && options.show.animation.empty() && !scene.animations.empty()) options.show.animation = "0";
}

int render(RenderOptions options) {
  check(options);
  const FrameRange asked = options.frames.empty() ? FrameRange{} : rangeFrom(options.frames);
  Scene scene = loadNamed(options.input);
  chooseAnimation(scene, options);
  Show show(std::move(scene), options.show);
  printNotes(options.input, show.scene(), options.load);
  finishFrameOnInterrupt();
  const FrameRange range = options.frames.empty() ? wholeAnimation(show, options.fps) : asked;
  if (isVideo(options.output)) return renderVideo(options, show, range);
  if (!isSequence(options)) return renderStill(options, show);
  return makeFrames(options, show, range, options.output) ? 0 : interrupted(options);
}

}  // namespace

Command addRender(CLI::App &app) {
  CLI::App *command = app.add_subcommand("render", "Render a model to pictures or a film");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("model", options->input, "File of the model; - reads glTF from standard input")->required();
  command
      ->add_option("-o,--output", options->output,
                   "png, jpg, bmp, ppm, exr, mp4 or webm by extension; %04d is the frame; - is standard output")
      ->type_name("FILE")
      ->required();
  addShowOptions(*command, options->show);
  command
      ->add_option("--frames", options->frames,
                   "Numbers of the frames, such as 0-99: numbered pictures [the whole animation]")
      ->type_name("A-B")
      ->group("Time");
  command->add_option("--fps", options->fps, "Frames a second")
      ->check(CLI::Range(0.001, 1000.0) & finite())
      ->group("Time")
      ->capture_default_str();
  command->add_option("--animation", options->show.animation, "Animation of the file, number or name")->group("Time");
  command->add_option("--time", options->time, "Moment of a single picture, in seconds")
      ->check(finite())
      ->group("Time");
  command->add_flag("--overwrite", options->overwrite, "Make frames again that exist")->group("Time");
  command->add_flag("--json", options->json, "A line of JSON on standard output for each picture");
  addLoadOptions(*command, options->load);
  command->footer(kExamples);
  return {command, [options] { return render(*options); }};
}

}  // namespace rc::tool
