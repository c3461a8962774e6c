// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore view: a window on a model.
#include <memory>

#include "commands/commands.h"
#include "commands/load_options.h"
#include "commands/show_options.h"
#include "output/picture_file.h"
#include "view/viewer.h"

namespace rc::tool {
namespace {

std::string footer() {
  std::string text =
      "Examples:\n  raycore view fox.glb --play\n  raycore view car.glb --background gradient --ground checker\n"
      "While something moves, fewer pixels are traced; at rest the picture is refined. The window follows the file: it "
      "is\nread again when it changes.\nIn the window:\n";
  for (const std::string &line : bindingLines()) text += "  " + line + "\n";
  return text;
}

int view(const ViewSettings &settings) {
  checkPictureName(settings.screenshots);
  return Viewer(settings).run();
}

}  // namespace

Command addView(CLI::App &app) {
  CLI::App *command = app.add_subcommand("view", "Look at a model in a window");
  auto settings = std::make_shared<ViewSettings>();
  command->add_option("model", settings->file, "File of the model; - reads glTF from standard input")->required();
  addShowOptions(*command, settings->show);
  command->get_option("--samples")->description("Samples a pixel at rest [16]")->default_val(16);
  command->add_option("--animation", settings->show.animation, "Animation of the file, number or name [0]")
      ->group("Time");
  command->add_flag("--play", settings->play, "Play the animation at once")->group("Time");
  command->add_flag("--statistics", settings->statistics, "Show statistics at once");
  command->add_option("--screenshots", settings->screenshots, "Names of screenshots; %04d is the number")
      ->type_name("FILE")
      ->capture_default_str();
  addLoadOptions(*command, settings->load);
  command->footer(footer());
  return {command, [settings] {
            settings->samples = settings->show.samples;
            return view(*settings);
          }};
}

}  // namespace rc::tool
