// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// surface.h: materials of files -> RayCore's Phong model with reflection and transmittance. docs/raycore/models.md
// says what that keeps and what it cannot.
#pragma once

#include "scene/scene.h"

namespace rc::tool {

// What rcMaterialfv takes, display values.
struct Surface {
  Vec3 ambient{0.8f}, diffuse{0.8f}, specular{0}, emission{0}, reflection{0}, transmittance{0};
  float shininess = 0, refractionIndex = 1;
};

// averages: of textures whose place RayCore has only one value for.
struct Averages {
  Vec3 base{1};  // display values
  float metallic = 1, roughness = 1, transmission = 1;
};

// A black material whose texture glows shows that texture as it is: an unlit one.
Material asDrawn(Material material);

Averages averagesOf(const Scene &scene, const Material &material);
Surface surfaceOf(const Material &material, const Averages &averages);

// What of the material is approximated.
void noteApproximations(const Material &material, Scene &scene);

}  // namespace rc::tool
