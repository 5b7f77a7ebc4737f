// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::simulator {

std::optional<CameraModel> camera_model_named(std::string_view name) {
  for (const CameraModel model : {CameraModel::kKinect2, CameraModel::kAzure, CameraModel::kD435}) {
    if (name_of(model) == name) return model;
  }
  return std::nullopt;
}

std::string_view name_of(CameraModel model) {
  switch (model) {
    case CameraModel::kKinect2:
      return "kinect2";
    case CameraModel::kAzure:
      return "azure";
    case CameraModel::kD435:
      return "d435";
    case CameraModel::kKinect1:
      return "kinect1";
  }
  return "";
}

std::optional<Harshness> harshness_named(std::string_view name) {
  for (const Harshness harshness :
       {Harshness::kTimeOfFlight, Harshness::kStructuredLight, Harshness::kMixed}) {
    if (name_of(harshness) == name) return harshness;
  }
  return std::nullopt;
}

std::string_view name_of(Harshness harshness) {
  switch (harshness) {
    case Harshness::kNone:
      break;
    case Harshness::kTimeOfFlight:
      return "tof";
    case Harshness::kStructuredLight:
      return "structured";
    case Harshness::kMixed:
      return "mixed";
  }
  return "";
}

}  // namespace roomcast::simulator
