// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// profile.h: the one table of what RAYCORE_PROFILE changes. [spec 8]
#pragma once

#include <string_view>

namespace rc::api {

struct Profile {
  std::string_view name;
  bool colouredReflection;   // RC_REFLECTION and RC_TRANSMITTANCE through fv: three values, else one
  float specularLevel;       // of a new material
  bool perpendicularUp;      // rcuLookAt makes up perpendicular to the view
  bool centredFrustum;       // of the window only its size counts
  bool matricesPersist;      // after rcStaticSceneEnd and after a frame with dynamic geometry
  int depthBounce;           // initially
  bool defaultLightAtEye;    // else at (0, 0, 1)
  int lights;                // RC_MAX_LIGHTS
  bool anyContextAttribute;  // eglCreateContext ignores attributes it does not know
};

inline constexpr Profile kProfiles[] = {
    {"guide", true, 1, true, false, true, 10, true, 8, false},
    {"1000", false, 0, false, true, false, 10, false, 8, true},
    {"mc", false, 0, false, true, false, 1, false, 1024, true},
};

// The first profile for a name that is none; base/settings.cpp reports those.
inline const Profile &profileNamed(std::string_view name) {
  for (const Profile &profile : kProfiles) {
    if (profile.name == name) return profile;
  }
  return kProfiles[0];
}

}  // namespace rc::api
