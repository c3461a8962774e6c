// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// pixels-inl.h: framebuffer.h for lanes: sums of the pixels of a tile to bytes, and these to the picture.
#if defined(RAYCORE_SHADING_PIXELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_PIXELS_INL
#undef RAYCORE_SHADING_PIXELS_INL
#else
#define RAYCORE_SHADING_PIXELS_INL
#endif

#include "rcddi/cpu/shading/lanes-inl.h"
#include "rchal/framebuffer.h"
#include "rchal/tile.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

HWY_INLINE U byteOf(F colour) {
  const ITag di;
  const F above = onlyWhere(hn::Gt(colour, zero()), hn::Min(colour, all(1)));
  return hn::BitCast(UTag(), hn::Min(hn::ConvertTo(di, hn::Mul(above, all(256))), hn::Set(di, 255)));
}

// As in rchal/framebuffer.h.
HWY_INLINE U roundTo565(U rgba) {
  const auto bits = [](U value, uint32_t mask) HWY_ATTR { return hn::And(value, hn::Set(UTag(), mask)); };
  const U redAndBlue = bits(hn::ShiftRight<5>(rgba), hal::rgb565::kRedAndBlue);
  const U green = bits(hn::ShiftRight<6>(rgba), hal::rgb565::kGreen);
  return hn::Or(bits(rgba, hal::rgb565::kKept), hn::Or(redAndBlue, green));
}

// The pixels from i on.
HWY_INLINE U bytesOf(const hal::PixelSums &sums, size_t i, float share, bool rgb565) {
  const FTag d;
  const V3 sum{hn::LoadU(d, sums.red + i), hn::LoadU(d, sums.green + i), hn::LoadU(d, sums.blue + i)};
  const V3 colour = all(share) * sum;
  const U low = hn::Or(byteOf(colour.x), hn::ShiftLeft<8>(byteOf(colour.y)));
  const U high = hn::Or(hn::ShiftLeft<16>(byteOf(colour.z)), hn::Set(UTag(), 0xff000000u));
  const U rgba = hn::Or(low, high);
  return rgb565 ? roundTo565(rgba) : rgba;
}

// Stores four lanes at a time. place(i): where lane i and the next three go.
template <class D, class Place>
HWY_INLINE void storeByFour(D d, hn::Vec<D> value, size_t i, Place &&place) {
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(D()) > 4) {
    const hn::Half<D> half;
    storeByFour(half, hn::LowerHalf(half, value), i, place);
    storeByFour(half, hn::UpperHalf(half, value), i + hn::MaxLanes(half), place);
    return;
  }
#endif
  hn::StoreU(value, d, place(i));
}

// Pixels of which some bits are kept, or which do not come in whole blocks.
template <class Place>
HWY_INLINE void storeOneByOne(U rgba, size_t first, size_t count, uint32_t writeMask, Place &&place) {
  alignas(64) uint32_t bytes[kMostLanes];
  hn::Store(rgba, UTag(), bytes);
  for (size_t i = 0; i < count; ++i) hal::store(*place(first + i), bytes[i], writeMask);
}

HWY_INLINE void storePixels(const hal::SceneView &scene, const hal::Target &target, const hal::Tile &tile,
                            const hal::TilePixels &pixels, const hal::PixelSums &sums) {
  const float share = 1 / static_cast<float>(scene.samples);
  uint32_t *const corner = &hal::pixelAt(target, tile.column, tile.row);
  const int32_t *const columns = pixels.column.data(), *const rows = pixels.row.data();
  const auto place = [&](size_t i) HWY_ATTR { return corner + columns[i] - ptrdiff_t(rows[i]) * target.width; };
  const bool whole = scene.writeMask == ~0u && pixels.areWholeBlocks();
  for (size_t i = 0; i < pixels.size(); i += lanes()) {
    const U rgba = bytesOf(sums, i, share, target.rgb565);
    if (whole) {
      storeByFour(UTag(), rgba, i, place);
    } else {
      storeOneByOne(rgba, i, std::min(lanes(), pixels.size() - i), scene.writeMask, place);
    }
  }
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
