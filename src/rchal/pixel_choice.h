// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// pixel_choice.h: which pixels of a tile get all their samples: where a single one at each corner of a pixel sees one
// colour, all of the pixel shows it. [RC_RENDERING_HINT]
// In: a tile, what its corners show.  Out: the pixels to be traced; sums of the others.
#pragma once

#include <vector>

#include "rchal/queues.h"
#include "rchal/tile.h"

namespace rc::hal {

class PixelChoice {
 public:
  // To be traced first: where pixels meet, so that each of these rays is for four pixels.
  const TilePixels &cornersOf(const Tile &tile) {
    mCorners.arrange(tile.columns + 1, tile.rows + 1);
    return mCorners;
  }
  // Those whose corners look different. The others get `samples` times what the corners show.
  void chooseByCorners(const TilePixels &pixels, const PixelSums &shown, float samples, const PixelSums &sums) {
    clear();
    for (size_t i = 0; i < pixels.size(); ++i) {
      const int x = pixels.column[i], y = pixels.row[i];
      Rgb least(1), most(0), sum(0);
      for (const auto &[dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        const Rgb colour = glm::clamp(shown[mCorners.placeOf(x + dx, y + dy)], 0.0f, 1.0f);
        least = glm::min(least, colour);
        most = glm::max(most, colour);
        sum += colour;
      }
      if (maxComponent(most - least) > kSameColour) {
        choose(x, y, i);
      } else {
        sums.add(i, sum * (samples / 4));
      }
    }
  }
  void chooseAll(const TilePixels &pixels) {
    clear();
    for (size_t i = 0; i < pixels.size(); ++i) choose(pixels.column[i], pixels.row[i], i);
  }

  const TilePixels &chosen() const { return mChosen; }
  size_t placeOf(size_t i) const { return mPlaces[i]; }  // of a chosen one in the tile

 private:
  // Colours closer than this look the same.
  static constexpr float kSameColour = 3.0f / 256;

  void clear() {
    mChosen.clear();
    mPlaces.clear();
  }
  void choose(int x, int y, size_t place) {
    mChosen.add(x, y);
    mPlaces.push_back(place);
  }

  TilePixels mCorners, mChosen;
  std::vector<size_t> mPlaces;
};

}  // namespace rc::hal
