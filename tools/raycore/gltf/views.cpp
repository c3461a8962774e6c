// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// Cameras and lights. [glTF 2.0, 3.10; KHR_lights_punctual]
#include "gltf/parts.h"

namespace rc::tool::gltf {
namespace {

Camera cameraFrom(const Value &about) {
  Camera camera;
  camera.name = about["name"].text();
  camera.orthographic = about["type"].text("perspective") == "orthographic";
  const Value lens = about[camera.orthographic ? "orthographic" : "perspective"];
  camera.yfov = lens["yfov"].number(camera.yfov);
  camera.xmag = lens["xmag"].number(1);
  camera.ymag = lens["ymag"].number(1);
  camera.znear = lens["znear"].number(0.1f);
  const bool usable = camera.yfov > 0 && camera.yfov < 3.14f && camera.xmag != 0 && camera.ymag != 0;
  if (!usable) about.complain("its angle or size shows nothing");
  return camera;
}

Light lightFrom(const Value &about) {
  Light light;
  light.name = about["name"].text();
  const std::string type = about.at("type").text();
  if (type == "directional")
    light.kind = LightKind::Directional;
  else if (type == "spot")
    light.kind = LightKind::Spot;
  else if (type != "point")
    about["type"].complain("\"{}\" is no kind of light", type);
  light.color = about["color"].vec3(Vec3(1));
  light.intensity = about["intensity"].number(1);
  light.range = about["range"].number(0);
  light.innerCone = about["spot"]["innerConeAngle"].number(0);
  light.outerCone = about["spot"]["outerConeAngle"].number(0.785398f);
  return light;
}

}  // namespace

void readCameras(Document &document) {
  const Value cameras = document["cameras"];
  for (size_t i = 0; i < cameras.size(); ++i) document.scene.cameras.push_back(cameraFrom(cameras[i]));
}

void readLights(Document &document) {
  const Value lights = document["extensions"]["KHR_lights_punctual"]["lights"];
  for (size_t i = 0; i < lights.size(); ++i) document.scene.lights.push_back(lightFrom(lights[i]));
}

}  // namespace rc::tool::gltf
