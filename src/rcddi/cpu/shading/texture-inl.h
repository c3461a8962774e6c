// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The raycore authors
//
// texture-inl.h: units/texture.h for lanes: one texture, a mip level for each lane.
// In: TextureView, texture coordinates, level of detail.  Out: TexelLanes.  Next: footprint-inl.h
#if defined(RAYCORE_SHADING_TEXTURE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCORE_SHADING_TEXTURE_INL
#undef RAYCORE_SHADING_TEXTURE_INL
#else
#define RAYCORE_SHADING_TEXTURE_INL
#endif

#include "rcddi/cpu/shading/surface-inl.h"
#include "rchal/units/texture.h"

HWY_BEFORE_NAMESPACE();
namespace rc::ddi::cpu::HWY_NAMESPACE {

struct TexelLanes {
  V3 rgb;
  F alpha;
};

HWY_INLINE F mix(F a, F b, F share) { return hn::Add(hn::Mul(a, hn::Sub(all(1), share)), hn::Mul(b, share)); }
HWY_INLINE V3 mix(const V3 &a, const V3 &b, F share) {
  return {mix(a.x, b.x, share), mix(a.y, b.y, share), mix(a.z, b.z, share)};
}
HWY_INLINE TexelLanes mix(const TexelLanes &a, const TexelLanes &b, F share) {
  return {mix(a.rgb, b.rgb, share), mix(a.alpha, b.alpha, share)};
}

template <int kShift>
HWY_INLINE F channel(U texels) {
  const U byte = hn::And(hn::ShiftRight<kShift>(texels), hn::Set(UTag(), 255));
  return hn::Mul(hn::ConvertTo(FTag(), hn::BitCast(ITag(), byte)), all(1.0f / 255));
}
RC_STEP V3 unpackColours(U texels) { return {channel<0>(texels), channel<8>(texels), channel<16>(texels)}; }

struct CornerTexels {
  U lowerLeft, lowerRight, upperLeft, upperRight;
  F x, y;  // way from the lower left ones
};
template <class Unpack>
HWY_INLINE auto mixed(const CornerTexels &at, Unpack unpack) {
  const auto lower = mix(unpack(at.lowerLeft), unpack(at.lowerRight), at.x);
  return mix(lower, mix(unpack(at.upperLeft), unpack(at.upperRight), at.x), at.y);
}

// size: powers of two.
RC_STEP I wrapIndex(I i, I size, hal::Wrap wrap) {
  const ITag di;
  const I one = hn::Set(di, 1);
  if (wrap == hal::Wrap::Repeat) return hn::And(i, hn::Sub(size, one));
  if (wrap == hal::Wrap::ClampToEdge) return hn::Min(hn::Max(i, hn::Zero(di)), hn::Sub(size, one));
  const I twice = hn::Add(size, size), inPair = hn::And(i, hn::Sub(twice, one));
  return hn::IfThenElse(hn::Lt(inPair, size), inPair, hn::Sub(hn::Sub(twice, one), inPair));
}

HWY_INLINE F texelPosition(F coordinate, I size) {
  const F position = hn::Sub(hn::Mul(coordinate, hn::ConvertTo(FTag(), size)), all(0.5f));
  return select(hn::Lt(hn::Abs(position), all(1e9f)), position, all(-0.5f));
}

// One level of the texture for all lanes.
RC_STEP TexelLanes sampleBilinear(const hal::TextureView &texture, int level, F s, F t, hal::Wraps wraps) {
  const ITag di;
  const I width = hn::Set(di, std::max(texture.width >> level, 1)), one = hn::Set(di, 1);
  const I height = hn::Set(di, std::max(texture.height >> level, 1));
  const F x = texelPosition(s, width), y = texelPosition(t, height);
  const F x0 = hn::Floor(x), y0 = hn::Floor(y);
  const I column = hn::ConvertTo(di, x0), row = hn::ConvertTo(di, y0);
  const I left = wrapIndex(column, width, wraps.s), right = wrapIndex(hn::Add(column, one), width, wraps.s);
  const I lower = hn::Mul(wrapIndex(row, height, wraps.t), width);
  const I upper = hn::Mul(wrapIndex(hn::Add(row, one), height, wraps.t), width);
  const auto *texels = reinterpret_cast<const int32_t *>(texture.levels[size_t(level)]);
  const auto texel = [&](I inRow, I inColumn) HWY_ATTR {
    return hn::BitCast(UTag(), hn::GatherIndex(di, texels, hn::Add(inRow, inColumn)));
  };
  const CornerTexels corners{texel(lower, left),  texel(lower, right), texel(upper, left),
                             texel(upper, right), hn::Sub(x, x0),      hn::Sub(y, y0)};
  const V3 rgb = mixed(corners, [](U rgba) HWY_ATTR { return unpackColours(rgba); });
  if (!texture.hasAlpha) return {rgb, all(hal::unpackTexel(static_cast<uint32_t>(*texels)).w)};
  return {rgb, mixed(corners, [](U rgba) HWY_ATTR { return channel<24>(rgba); })};
}

// Lanes may read different levels: neighbours rarely need more than two.
RC_STEP TexelLanes sampleLevels(const hal::TextureView &texture, I levels, M valid, F s, F t, hal::Wraps wraps) {
  const ITag di;
  alignas(64) int32_t level[16];
  hn::Store(levels, di, level);
  TexelLanes out{{zero(), zero(), zero()}, zero()};
  for (uint32_t open = bitsOf(FTag(), valid); open;) {
    const int one = level[hwy::Num0BitsBelowLS1Bit_Nonzero32(open)];
    const M these = hn::RebindMask(FTag(), hn::Eq(levels, hn::Set(di, one)));
    open &= ~bitsOf(FTag(), these);
    const TexelLanes texels = sampleBilinear(texture, one, s, t, wraps);
    out = {select(these, texels.rgb, out.rgb), select(these, texels.alpha, out.alpha)};
  }
  return out;
}

RC_STEP TexelLanes sampleTexture(const hal::TextureView &texture, F lod, M valid, F s, F t, hal::Wraps wraps) {
  if (texture.levelCount == 1) return sampleBilinear(texture, 0, s, t, wraps);
  const ITag di;
  const int last = texture.levelCount - 1;
  const F level = onlyWhere(hn::Gt(lod, zero()), hn::Min(lod, all(static_cast<float>(last))));
  if (!texture.trilinear) {
    const I nearest = hn::ConvertTo(di, hn::Floor(hn::Add(level, all(0.5f))));
    return sampleLevels(texture, nearest, valid, s, t, wraps);
  }
  const I fine = hn::ConvertTo(di, level), coarse = hn::Min(hn::Add(fine, hn::Set(di, 1)), hn::Set(di, last));
  const F share = hn::Sub(level, hn::Floor(level));
  return mix(sampleLevels(texture, fine, valid, s, t, wraps), sampleLevels(texture, coarse, valid, s, t, wraps), share);
}

}  // namespace rc::ddi::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
