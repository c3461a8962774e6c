// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "commands/show_options.h"

#include <cmath>
#include <map>

namespace rc::tool {
namespace {

const std::map<std::string, Lighting> kLightings{{"auto", Lighting::Automatic},
                                                 {"file", Lighting::File},
                                                 {"studio", Lighting::Studio},
                                                 {"headlight", Lighting::Headlight},
                                                 {"none", Lighting::None}};
const std::map<std::string, GroundKind> kGrounds{{"none", GroundKind::None},
                                                 {"matte", GroundKind::Matte},
                                                 {"mirror", GroundKind::Mirror},
                                                 {"checker", GroundKind::Checker}};

bool readNumbers(const std::string &text, char between, int count, float *values) {
  const char *at = text.c_str();
  for (int i = 0; i < count; ++i) {
    char *end = nullptr;
    values[i] = std::strtof(at, &end);
    const bool last = i + 1 == count;
    if (end == at || !std::isfinite(values[i]) || *end != (last ? '\0' : between)) return false;
    at = end + 1;
  }
  return true;
}

// The word of an option is not what it should be.
[[noreturn]] void refuse(const char *option, const std::string &word, const char *rule) {
  throw CLI::ValidationError(option, "\"" + word + "\" is not " + rule);
}

// "x,y,z"
CLI::callback_t point(const char *option, std::optional<Vec3> &to) {
  return [option, &to](const CLI::results_t &words) {
    Vec3 v;
    if (!readNumbers(words[0], ',', 3, &v.x)) refuse(option, words[0], "three numbers, such as 0,1.5,4");
    to = v;
    return true;
  };
}

CLI::callback_t size(ShowSettings &to) {
  return [&to](const CLI::results_t &words) {
    float v[2];
    const auto fits = [](float side) { return side >= 1 && side <= 16384 && side == std::floor(side); };
    if (!readNumbers(words[0], 'x', 2, v) || !fits(v[0]) || !fits(v[1])) {
      refuse("--size", words[0], "two whole numbers from 1 to 16384, such as 800x480");
    }
    to.width = static_cast<int>(v[0]);
    to.height = static_cast<int>(v[1]);
    return true;
  };
}

CLI::callback_t angle(const char *option, std::optional<Angle> &to) {
  return [option, &to](const CLI::results_t &words) {
    float v[2];
    if (!readNumbers(words[0], ',', 2, v)) refuse(option, words[0], "two numbers of degrees, such as 30,20");
    to = Angle{v[0], v[1]};
    return true;
  };
}

// The words of a table, in braces as completions read them.
template <class Value>
CLI::Validator wordsOf(const std::map<std::string, Value> &table) {
  std::string words;
  for (const auto &[word, value] : table) words += (words.empty() ? "" : ",") + word;
  const auto check = [&table, words](const std::string &word) {
    return table.contains(word) ? std::string() : "\"" + word + "\" is none of " + words;
  };
  return {check, "{" + words + "}"};
}

template <class Value>
CLI::callback_t valueOf(const std::map<std::string, Value> &table, Value &to) {
  return [&table, &to](const CLI::results_t &words) {
    to = table.at(words[0]);
    return true;
  };
}

}  // namespace

CLI::Validator finite() {
  return {[](const std::string &text) {
            return std::isfinite(std::strtod(text.c_str(), nullptr)) ? std::string() : "\"" + text + "\" is not finite";
          },
          ""};
}

void addPictureSize(CLI::App &command, ShowSettings &settings) {
  command.add_option("--size", size(settings), "Pixels, 1 to 16384 each [800x480]")->type_name("WxH")->group("Picture");
  command.add_option("--samples", settings.samples, "Samples a pixel")
      ->check(CLI::Range(1, 64))
      ->group("Picture")
      ->capture_default_str();
  command.add_option("--bounces", settings.bounces, "Reflections and refractions after the first hit")
      ->check(CLI::Range(0, 14))
      ->group("Picture")
      ->capture_default_str();
}

void addShowOptions(CLI::App &command, ShowSettings &settings) {
  const auto add = [&](const char *names, CLI::callback_t callback, const char *type, const char *what) {
    return command.add_option(names, std::move(callback), what)->type_name(type)->group("Picture");
  };
  addPictureSize(command, settings);
  CLI::Option *camera =
      command
          .add_option("--camera", settings.camera, "Camera of the file, number or name; else the whole model is framed")
          ->group("Picture");
  CLI::Option *eye = add("--eye", point("--eye", settings.eye), "X,Y,Z", "Where the viewer is");
  add("--look-at", point("--look-at", settings.lookAt), "X,Y,Z", "What the viewer looks at [the model's middle]")
      ->excludes(camera);
  add("--angle", angle("--angle", settings.angle), "AZ,EL",
      "Degrees round the model and above it, for the framing camera")
      ->excludes(camera)
      ->excludes(eye);
  eye->excludes(camera);
  command.add_option("--fov", settings.fov, "Vertical angle in degrees")
      ->check(CLI::Range(1.0, 170.0) & finite())
      ->excludes(camera)
      ->group("Picture")
      ->capture_default_str();
  command.add_option("--up", settings.up, "Axis that points up: y or z [by format]")
      ->check(CLI::IsMember({"y", "z"}))
      ->group("Picture");
  add("--lights", valueOf(kLightings, settings.lighting), "KIND", "auto, file, studio, headlight or none [auto]")
      ->check(wordsOf(kLightings));
  command
      .add_option("--background", settings.background,
                  "#rrggbb, r,g,b, a name, gradient[:TOP,BOTTOM], or an equirectangular picture")
      ->type_name("FILE")
      ->group("Picture");
  add("--ground", valueOf(kGrounds, settings.ground), "KIND", "none, matte, mirror or checker [none]")
      ->check(wordsOf(kGrounds));
}

}  // namespace rc::tool
