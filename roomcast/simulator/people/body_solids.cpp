// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/body_solids.h"

#include <algorithm>
#include <cmath>

namespace roomcast::simulator {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

/// Adds bars in bone frames; dimensions are those of a person of 1.80 m and are scaled.
class BodyMesher {
 public:
  BodyMesher(BodyPiece& piece, const Pose& pose, const Measures& measures)
      : piece_(piece), pose_(pose), s_(measures.scale) {}

  void bar(Bone bone, Vector3f from, Vector3f to, Vector2f radii, Vector2f flat = {1.0F, 1.0F},
           float blend_m = 0.03F) {
    piece_.solid.add(pose_.of(bone),
                     {s_ * from, s_ * to, s_ * radii.x(), s_ * radii.y(), flat, s_ * blend_m});
  }
  /// A bar along a limb's bone, between two fractions of the bone's length.
  void sleeve(Bone bone, float length_m, Vector2f shares, Vector2f radii, float blend_m = 0.03F) {
    const Vector3f down(0, -length_m, 0);
    piece_.solid.add(pose_.of(bone), {down * shares.x(),
                                      down * shares.y(),
                                      s_ * radii.x(),
                                      s_ * radii.y(),
                                      {1.0F, 1.0F},
                                      s_ * blend_m});
  }
  /// Cuts the cloth at a point along a bone; keeps the part nearer to the bone's joint.
  void cut_across(Bone bone, float down_m, float reach_m) {
    const Isometry3f& frame = pose_.of(bone);
    piece_.solid.cut(frame * Vector3f(0, -down_m, 0), -frame.linear().col(1), reach_m);
  }

 private:
  BodyPiece& piece_;
  const Pose& pose_;
  float s_;
};

void add_trunk_of_shirt(BodyMesher& t, const Build& build) {
  const float g = build.girth;
  const float belly = 0.143F * (0.55F + 0.45F * g) + 0.03F * (g - 1.0F);
  t.bar(Bone::kPelvis, {0, -build.hem_m - 0.05F, 0}, {0, 0.06F, 0.005F},
        {belly + 0.030F, belly + 0.012F}, {1.10F, 0.84F});
  t.bar(Bone::kChest, {0, -0.03F, 0.006F}, {0, 0.10F, 0.004F}, {belly + 0.006F, belly},
        {1.06F, 0.83F}, 0.06F);
  t.bar(Bone::kChest, {0, 0.10F, 0.002F}, {0, 0.30F, 0.004F}, {belly - 0.004F, 0.152F * g},
        {1.08F, 0.76F}, 0.06F);
  for (const float x : {-1.0F, 1.0F}) {
    t.bar(Bone::kChest, {x * 0.045F, 0.435F, -0.014F}, {x * 0.165F, 0.405F, -0.010F},
          {0.062F, 0.056F}, {1.0F, 1.0F}, 0.05F);
    t.bar(Bone::kChest, {x * 0.075F, 0.28F, 0.035F}, {x * 0.085F, 0.33F, 0.040F}, {0.075F, 0.065F},
          {1.0F, 0.8F}, 0.05F);  // breast
  }
  t.bar(Bone::kChest, {0, 0.42F, -0.014F}, {0, 0.485F, -0.002F}, {0.075F, 0.060F}, {1.05F, 1.0F},
        0.03F);  // collar
}

BodyPiece shirt(const Build& build, const Outfit& outfit, const Pose& pose, const Measures& m) {
  BodyPiece piece;
  piece.surface = outfit.shirt;
  piece.cell_m = 0.033F;
  piece.bones = {Bone::kPelvis, Bone::kChest};
  BodyMesher t(piece, pose, m);
  add_trunk_of_shirt(t, build);
  const float thick = 0.5F + 0.5F * build.girth;
  for (const Side side : kSides) {
    const Bone upper = on_side(Bone::kLeftUpperArm, side);
    const Bone lower = on_side(Bone::kLeftForearm, side);
    piece.bones.insert(piece.bones.end(), {upper, lower});
    t.sleeve(upper, m.upper_arm, {0.0F, 1.0F}, Vector2f(0.057F, 0.050F) * thick, 0.045F);
    if (build.sleeve > 0.0F) {
      t.sleeve(lower, m.forearm, {0.0F, 1.0F}, Vector2f(0.052F, 0.040F) * thick, 0.02F);
      t.cut_across(lower, build.sleeve * m.forearm, 0.2F);
    } else {
      t.cut_across(upper, (1.0F + build.sleeve) * m.upper_arm, 0.25F);
    }
  }
  for (const Side side : kSides) {  // the hem moves with the thighs below it
    const Bone thigh = on_side(Bone::kLeftThigh, side);
    piece.bones.push_back(thigh);
    if (build.hem_m > 0.2F)
      t.sleeve(thigh, m.thigh, {0.0F, 1.1F}, Vector2f(0.125F, 0.120F) * thick, 0.06F);
  }
  t.cut_across(Bone::kPelvis, build.hem_m * m.scale, 0.5F);
  return piece;
}

BodyPiece trousers(const Build& build, const Outfit& outfit, const Pose& pose, const Measures& m) {
  BodyPiece piece;
  piece.surface = outfit.trousers;
  piece.cell_m = 0.033F;
  piece.bones = {Bone::kPelvis};
  BodyMesher t(piece, pose, m);
  const float g = build.girth;
  const float thick = 0.5F + 0.5F * g;
  t.bar(Bone::kPelvis, {0, 0.0F, 0}, {0, 0.09F, 0.004F}, {0.142F * g, 0.134F * g}, {1.12F, 0.80F});
  for (const Side side : kSides) {
    const float x = sign_of(side);
    t.bar(Bone::kPelvis, {x * 0.070F, -0.01F, -0.040F}, {x * 0.075F, -0.06F, -0.042F},
          {0.088F * thick, 0.084F * thick}, {1.0F, 1.0F}, 0.05F);
  }
  for (const Side side : kSides) {
    const Bone thigh = on_side(Bone::kLeftThigh, side);
    const Bone shin = on_side(Bone::kLeftShin, side);
    piece.bones.insert(piece.bones.end(), {thigh, shin});
    t.sleeve(thigh, m.thigh, {0.0F, 1.0F}, Vector2f(0.093F, 0.067F) * thick, 0.035F);
    t.sleeve(shin, m.shin, {0.0F, 0.45F}, Vector2f(0.067F, 0.065F) * thick, 0.025F);
    t.sleeve(shin, m.shin, {0.45F, 1.05F}, Vector2f(0.065F, 0.057F) * thick, 0.025F);
    t.cut_across(shin, 0.96F * m.shin, 0.15F);
  }
  return piece;
}

BodyPiece head(const Outfit& outfit, const Pose& pose, const Measures& m) {
  BodyPiece piece;
  piece.surface = outfit.face;
  piece.cell_m = 0.0155F;
  piece.bones = {Bone::kHead};
  BodyMesher t(piece, pose, m);
  t.bar(Bone::kHead, {0, -0.12F, -0.030F}, {0, 0.06F, -0.010F}, {0.054F, 0.052F});  // neck
  t.bar(Bone::kHead, {0, 0.125F, -0.026F}, {0, 0.135F, 0.016F}, {0.092F, 0.082F}, {0.95F, 1.0F},
        0.02F);  // skull
  t.bar(Bone::kHead, {0, 0.030F, 0.048F}, {0, 0.100F, 0.032F}, {0.038F, 0.070F}, {0.98F, 1.0F},
        0.03F);  // jaw and cheeks
  t.bar(Bone::kHead, {0, 0.058F, 0.094F}, {0, 0.100F, 0.086F}, {0.0135F, 0.0085F}, {1.0F, 1.0F},
        0.012F);  // nose
  t.bar(Bone::kHead, {-0.030F, 0.118F, 0.078F}, {0.030F, 0.118F, 0.078F}, {0.014F, 0.014F},
        {1.0F, 1.0F}, 0.02F);  // brow
  for (const float x : {-1.0F, 1.0F}) {
    t.bar(Bone::kHead, {x * 0.083F, 0.068F, -0.012F}, {x * 0.089F, 0.102F, -0.020F},
          {0.013F, 0.019F}, {0.8F, 1.0F}, 0.008F);  // ear
  }
  return piece;
}

BodyPiece hair(const Build& build, const Outfit& outfit, const Pose& pose, const Measures& m) {
  BodyPiece piece;
  piece.surface = outfit.hair;
  piece.cell_m = 0.021F;
  piece.bones = {Bone::kHead};
  BodyMesher t(piece, pose, m);
  t.bar(Bone::kHead, {0, 0.115F, -0.040F}, {0, 0.150F, 0.000F}, {0.097F, 0.088F}, {0.96F, 1.0F});
  t.bar(Bone::kHead, {-0.035F, 0.185F, 0.058F}, {0.04F, 0.195F, 0.052F}, {0.026F, 0.030F},
        {1.0F, 1.0F}, 0.04F);  // fringe
  switch (build.hair) {
    case HairStyle::kShort:
      t.bar(Bone::kHead, {0, 0.04F, -0.068F}, {0, 0.10F, -0.060F}, {0.052F, 0.070F});
      break;
    case HairStyle::kLong:
      piece.bones.push_back(Bone::kChest);
      for (const float x : {-1.0F, 1.0F}) {
        t.bar(Bone::kHead, {x * 0.075F, -0.10F, -0.030F}, {x * 0.072F, 0.13F, -0.018F},
              {0.026F, 0.036F});
      }
      t.bar(Bone::kHead, {0, -0.15F, -0.088F}, {0, 0.10F, -0.062F}, {0.058F, 0.080F}, {1.2F, 0.8F});
      break;
    case HairStyle::kBun:
      t.bar(Bone::kHead, {0, 0.04F, -0.064F}, {0, 0.10F, -0.058F}, {0.045F, 0.070F});
      t.bar(Bone::kHead, {0, 0.190F, -0.115F}, {0, 0.205F, -0.120F}, {0.045F, 0.042F}, {1.0F, 1.0F},
            0.01F);
      break;
    case HairStyle::kCurly:
      for (int i = 0; i < 9; ++i) {
        const float angle = 0.7F * static_cast<float>(i - 4);
        t.bar(Bone::kHead,
              {0.098F * std::sin(angle), 0.145F - 0.008F * std::abs(angle) * 4.0F,
               -0.030F - 0.085F * std::cos(angle) * (std::abs(angle) < 2.0F ? 1.0F : 0.55F)},
              {0.05F * std::sin(2.0F * angle), 0.225F, -0.03F + 0.05F * std::cos(angle)},
              {0.042F, 0.036F}, {1.0F, 1.0F}, 0.012F);
      }
      break;
  }
  return piece;
}

BodyPiece hand(Side side, const Build& build, const Outfit& outfit, const Pose& pose,
               const Measures& m) {
  BodyPiece piece;
  piece.surface = outfit.skin;
  piece.cell_m = 0.0125F;
  const Bone bone = on_side(Bone::kLeftHand, side);
  piece.bones = {bone};
  BodyMesher t(piece, pose, m);
  const float in = -sign_of(side);  // side of the palm
  t.bar(bone, {0, -0.035F, 0}, {0, -0.080F, 0.002F}, {0.030F, 0.036F}, {0.48F, 1.0F}, 0.012F);
  for (int i = 0; i < 4; ++i) {
    const float z = 0.027F - 0.018F * static_cast<float>(i);
    const float length = i == 3 ? 0.058F : (i == 1 ? 0.082F : 0.075F);
    const float middle = -0.098F - 0.5F * length;
    t.bar(bone, {0, -0.095F, z}, {in * 0.006F, middle, z * 1.1F}, {0.0105F, 0.0095F}, {1.0F, 1.0F},
          0.008F);
    t.bar(bone, {in * 0.006F, middle, z * 1.1F}, {in * 0.022F, -0.098F - length, z * 1.1F},
          {0.0095F, 0.0080F}, {1.0F, 1.0F}, 0.004F);
  }
  t.bar(bone, {in * 0.004F, -0.035F, 0.022F}, {in * 0.014F, -0.075F, 0.055F}, {0.016F, 0.0125F},
        {1.0F, 1.0F}, 0.012F);  // thumb
  t.bar(bone, {in * 0.014F, -0.075F, 0.055F}, {in * 0.020F, -0.105F, 0.058F}, {0.0125F, 0.010F},
        {1.0F, 1.0F}, 0.004F);
  const Bone lower = on_side(Bone::kLeftForearm, side);
  const float bare = std::max(0.0F, build.sleeve) - 0.08F;
  t.sleeve(lower, m.forearm, {std::max(0.0F, bare), 0.97F},
           {0.027F + 0.016F * (1.0F - std::max(0.0F, bare)), 0.026F}, 0.015F);
  piece.bones.push_back(lower);
  if (build.sleeve <= 0.0F) {
    const Bone upper = on_side(Bone::kLeftUpperArm, side);
    t.sleeve(upper, m.upper_arm, {0.4F, 1.0F}, {0.048F, 0.043F}, 0.02F);
    piece.bones.push_back(upper);
    piece.cell_m = 0.014F;
  }
  return piece;
}

BodyPiece shoe(Side side, const Outfit& outfit, const Pose& pose, const Measures& m) {
  BodyPiece piece;
  piece.surface = outfit.shoes;
  piece.cell_m = 0.021F;
  const Bone bone = on_side(Bone::kLeftFoot, side);
  piece.bones = {bone};
  BodyMesher t(piece, pose, m);
  const float x = sign_of(side);
  t.bar(bone, {0, -0.045F, -0.045F}, {x * 0.006F, -0.052F, 0.135F}, {0.043F, 0.046F}, {0.92F, 1.0F},
        0.02F);
  t.bar(bone, {x * 0.004F, -0.055F, 0.12F}, {x * 0.002F, -0.058F, 0.165F}, {0.046F, 0.034F},
        {0.95F, 1.0F}, 0.02F);
  t.bar(bone, {0, -0.01F, -0.012F}, {0, -0.035F, 0.055F}, {0.048F, 0.042F}, {0.9F, 1.0F}, 0.03F);
  t.cut_across(bone, m.ankle, 0.3F);  // a flat sole
  return piece;
}

}  // namespace

std::vector<BodyPiece> body_pieces(const Build& build, const Outfit& outfit, const Pose& cutting,
                                   const Measures& measures) {
  std::vector<BodyPiece> pieces = {
      shirt(build, outfit, cutting, measures), trousers(build, outfit, cutting, measures),
      head(outfit, cutting, measures), hair(build, outfit, cutting, measures)};
  for (const Side side : kSides) {
    pieces.push_back(hand(side, build, outfit, cutting, measures));
    pieces.push_back(shoe(side, outfit, cutting, measures));
  }
  return pieces;
}

}  // namespace roomcast::simulator
