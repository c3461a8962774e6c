// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
#include "frames/povray.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <map>

#include "frames/program.h"

namespace rc::bench {
namespace {

struct Vector {
  Vec3 value;
};

std::ostream &operator<<(std::ostream &out, const Vector &v) {
  return out << '<' << v.value.x << ',' << v.value.y << ',' << v.value.z << '>';
}

void writeList(std::ostream &out, const char *name, const std::vector<Vec3> &values) {
  out << name << " { " << values.size();
  for (const Vec3 &value : values) out << ",\n" << Vector{value};
  out << " }\n";
}

// As ours: what a surface reflects and lets through is taken off its own light.
void writeSurface(std::ostream &out, const Surface &surface) {
  const float own = 1 - surface.reflection - surface.transmittance;
  out << "pigment { rgb " << Vector{surface.colour} << " transmit " << surface.transmittance << " }\n"
      << "finish { ambient " << own * kAmbient << " diffuse " << own << " phong " << own * surface.specular
      << " phong_size " << surface.shininess << " reflection " << surface.reflection << " }\n";
  if (surface.transmittance > 0) out << "interior { ior " << surface.refractionIndex << " }\n";
}

// Vertices that are the same are one, as in a mesh of a modelling program.
void writeMesh(std::ostream &out, const Mesh &mesh) {
  std::map<std::array<float, 6>, size_t> places;
  std::vector<Vec3> vertices, normals;
  std::vector<size_t> corners;
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 v = mesh.vertices[i], n = mesh.normals.empty() ? Vec3(0) : mesh.normals[i];
    const auto [place, isNew] = places.try_emplace({v.x, v.y, v.z, n.x, n.y, n.z}, vertices.size());
    if (isNew) vertices.push_back(v), normals.push_back(n);
    corners.push_back(place->second);
  }
  out << "mesh2 {\n";
  writeList(out, "vertex_vectors", vertices);
  if (!mesh.normals.empty()) writeList(out, "normal_vectors", normals);
  out << "face_indices { " << corners.size() / 3;
  for (size_t i = 0; i < corners.size(); i += 3) {
    out << ",\n<" << corners[i] << ',' << corners[i + 1] << ',' << corners[i + 2] << '>';
  }
  out << " }\n";
  writeSurface(out, mesh.surface);
  out << "}\n";
}

void writeCamera(std::ostream &out, const Camera &camera, float aspect) {
  const Vec3 forward = glm::normalize(camera.at - camera.eye);
  const Vec3 right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0))), up = glm::cross(right, forward);
  const float height = 2 * std::tan(glm::radians(camera.degrees) / 2);
  out << "camera { perspective location " << Vector{camera.eye} << " direction " << Vector{forward} << " right "
      << Vector{right * (height * aspect)} << " up " << Vector{up * height} << " }\n";
}

}  // namespace

void writePovRay(const std::string &path, const FrameScene &scene, int width, int height) {
  std::ofstream out(path);
  out.precision(7);
  out << "#version 3.7;\nglobal_settings { max_trace_level " << scene.bounces << " assumed_gamma 1 }\n"
      << "background { rgb " << Vector{kBackground} << " }\n";
  writeCamera(out, scene.camera, float(width) / float(height));
  for (const Vec3 &light : scene.lights) out << "light_source { " << Vector{light} << " rgb 1 }\n";
  for (const Mesh &mesh : scene.meshes) writeMesh(out, mesh);
}

PovRayTimes runPovRay(const std::string &program, const std::string &path, const std::string &picture, int width,
                      int height, int threads) {
  std::string command = "'" + program + "' -D -A +I'" + path + "' +W" + std::to_string(width);
  command.append(" +H").append(std::to_string(height)).append(" +WT").append(std::to_string(threads));
  command.append(picture.empty() ? " -F" : " File_Gamma=1 +FN +O'" + picture + "'");
  PovRayTimes times;
  forEachLineOf(command, [&](const char *line) {
    double seconds = 0;
    const char *format = " Trace Time: %*d hours %*d minutes %*d seconds (%lf seconds";
    if (std::sscanf(line, format, &seconds) == 1) times.milliseconds = 1e3 * seconds;
    std::sscanf(line, "Rays: %lf", &times.rays);
  });
  return times;
}

}  // namespace rc::bench
