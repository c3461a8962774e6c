// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// raycore info: what is in a model.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "draw/surface.h"
#include "load/named_load.h"
#include "scene/pose.h"

namespace rc::tool {
namespace {

using Json = nlohmann::ordered_json;

size_t trianglesOf(const Mesh &mesh) {
  size_t count = 0;
  for (const Primitive &primitive : mesh.primitives) count += primitive.triangles();
  return count;
}

size_t drawnTriangles(const Scene &scene) {
  size_t count = 0;
  for (const int index : scene.order) {
    const Node &node = scene.nodes[size_t(index)];
    if (node.mesh < 0) continue;
    count += trianglesOf(scene.meshes[size_t(node.mesh)]) * std::max<size_t>(node.instances.size(), 1);
  }
  return count;
}

Json array(const Vec3 &v) { return {v.x, v.y, v.z}; }

Json aboutMeshes(const Scene &scene) {
  Json list = Json::array();
  for (const Mesh &mesh : scene.meshes) {
    size_t vertices = 0, targets = 0;
    for (const Primitive &primitive : mesh.primitives) {
      vertices += primitive.positions.size();
      targets = std::max(targets, primitive.targets.size());
    }
    list.push_back({{"name", mesh.name},
                    {"primitives", mesh.primitives.size()},
                    {"triangles", trianglesOf(mesh)},
                    {"vertices", vertices},
                    {"morph_targets", targets}});
  }
  return list;
}

const char *alphaName(AlphaMode mode) {
  constexpr const char *kNames[] = {"OPAQUE", "MASK", "BLEND"};
  return kNames[int(mode)];
}

// The surface as it is drawn.
Json aboutMaterials(const Scene &scene) {
  Json list = Json::array();
  for (const Material &material : scene.materials) {
    const Surface s = surfaceOf(material, averagesOf(scene, material));
    list.push_back({{"name", material.name},
                    {"model", material.classic ? "Phong"
                              : material.unlit ? "unlit"
                                               : "metallic-roughness"},
                    {"alpha", alphaName(material.alphaMode)},
                    {"double_sided", material.doubleSided},
                    {"textured", material.baseTexture.used()},
                    {"normal_map", material.normalTexture.used()},
                    {"diffuse", array(s.diffuse)},
                    {"specular", array(s.specular)},
                    {"shininess", s.shininess},
                    {"reflection", array(s.reflection)},
                    {"transmittance", array(s.transmittance)},
                    {"refraction_index", s.refractionIndex},
                    {"emission", array(s.emission)}});
  }
  return list;
}

Json aboutImages(const Scene &scene) {
  Json list = Json::array();
  for (const Image &image : scene.images) {
    list.push_back({{"name", image.name}, {"width", image.width}, {"height", image.height}});
  }
  return list;
}

Json aboutAnimations(const Scene &scene) {
  Json list = Json::array();
  for (const Animation &animation : scene.animations) {
    list.push_back(
        {{"name", animation.name}, {"seconds", animation.duration()}, {"channels", animation.channels.size()}});
  }
  return list;
}

template <class Things>
Json names(const Things &things) {
  Json list = Json::array();
  for (const auto &thing : things) list.push_back(thing.name);
  return list;
}

Json about(const std::string &file, const Scene &scene) {
  const Bounds bounds = boundsOf(scene, poseAt(scene, -1, 0));
  size_t triangles = 0;
  for (const Mesh &mesh : scene.meshes) triangles += trianglesOf(mesh);
  Json json{{"file", file},
            {"format", scene.format},
            {"triangles", triangles},
            {"triangles_drawn", drawnTriangles(scene)},
            {"nodes", scene.order.size()},
            {"meshes", aboutMeshes(scene)},
            {"materials", aboutMaterials(scene)},
            {"images", aboutImages(scene)},
            {"animations", aboutAnimations(scene)},
            {"skins", names(scene.skins)},
            {"cameras", names(scene.cameras)},
            {"lights", names(scene.lights)}};
  json["bounds"] = bounds.empty() ? Json() : Json{{"low", array(bounds.low)}, {"high", array(bounds.high)}};
  json["notes"] = scene.notes;
  return json;
}

std::string nameOf(const Json &thing) {
  const std::string name = thing.is_string() ? thing.get<std::string>() : thing["name"].get<std::string>();
  return name.empty() ? "(no name)" : name;
}

void printList(const char *title, const Json &list, const std::function<std::string(const Json &)> &line) {
  constexpr size_t kMost = 12;
  if (list.empty()) return;
  fmt::print("{}: {}\n", title, list.size());
  for (size_t i = 0; i < list.size() && i < kMost; ++i) fmt::print("  {:3} {}\n", i, line(list[i]));
  if (list.size() > kMost) fmt::print("      ... and {} more (--json lists all)\n", list.size() - kMost);
}

void printText(const Json &json) {
  fmt::print("{}: {}\n", json["file"].get<std::string>(), json["format"].get<std::string>());
  fmt::print("triangles: {}, drawn {}\nnodes: {}\n", json["triangles"].dump(), json["triangles_drawn"].dump(),
             json["nodes"].dump());
  if (!json["bounds"].is_null())
    fmt::print("bounds: {} to {}\n", json["bounds"]["low"].dump(), json["bounds"]["high"].dump());
  printList("meshes", json["meshes"], [](const Json &m) {
    return fmt::format("{}: {} triangles, {} vertices", nameOf(m), m["triangles"].dump(), m["vertices"].dump());
  });
  printList("materials", json["materials"], [](const Json &m) {
    return fmt::format("{}: {}, {}{}{}", nameOf(m), m["model"].get<std::string>(), m["alpha"].get<std::string>(),
                       m["textured"].get<bool>() ? ", textured" : "",
                       m["normal_map"].get<bool>() ? ", normal map" : "");
  });
  printList("images", json["images"],
            [](const Json &m) { return fmt::format("{}: {} x {}", nameOf(m), m["width"].dump(), m["height"].dump()); });
  printList("animations", json["animations"], [](const Json &m) {
    return fmt::format("{}: {:.2f} s, {} channels", nameOf(m), m["seconds"].get<double>(), m["channels"].dump());
  });
  for (const char *kind : {"skins", "cameras", "lights"}) printList(kind, json[kind], nameOf);
  for (const Json &note : json["notes"]) fmt::print("note: {}\n", note.get<std::string>());
}

struct InfoOptions {
  std::string input;
  bool json = false;
};

int info(const InfoOptions &options) {
  Scene scene = loadNamed(options.input);
  for (const Material &material : std::vector<Material>(scene.materials)) noteApproximations(material, scene);
  const Json json = about(options.input, scene);
  if (options.json) {
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
  } else {
    printText(json);
  }
  return 0;
}

}  // namespace

Command addInfo(CLI::App &app) {
  CLI::App *command = app.add_subcommand("info", "What is in a model, and what cannot be drawn as it is meant");
  auto options = std::make_shared<InfoOptions>();
  command->add_option("model", options->input, "File of the model; - reads glTF from standard input")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->footer("Examples:\n  raycore info duck.glb\n  raycore info scene.gltf --json | jq .materials");
  return {command, [options] { return info(*options); }};
}

}  // namespace rc::tool
