// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/set_writer.h"

#include <cinttypes>
#include <cstdio>
#include <string>
#include <utility>

#include "roomcast/io/file_bytes.h"
#include "roomcast/io/new_folder.h"
#include "roomcast/recording/export/cloud_files.h"
#include "roomcast/recording/export/folder_writer.h"
#include "roomcast/recording/export/foxglove_writer.h"
#include "roomcast/recording/export/gltf_scene.h"

namespace roomcast::recording {
namespace {

std::string numbered(std::uint64_t set, const char* ending) {
  char name[40];
  std::snprintf(name, sizeof(name), "set_%06" PRIu64 ".%s", set, ending);
  return name;
}

/// Base of the formats with one file per set.
class SetFiles : public SetWriter {
 public:
  SetFiles(std::filesystem::path folder, const char* ending, nanoseconds began_at)
      : folder_(std::move(folder)), ending_(ending), began_at_(began_at) {}

  Status add(const FrameSet& set) final {
    const std::filesystem::path path = folder_ / numbered(set.number, ending_);
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) {
      ++totals_.kept;
      return {};
    }
    bytes_.clear();
    const nanoseconds captured = began_at_.count() > 0 ? began_at_ + set.time : nanoseconds(0);
    if (auto status = append(set, captured, bytes_); !status) return status;
    ++totals_.sets;
    return io::write_file(path, bytes_);
  }
  Status finish() final { return {}; }
  ExportTotals totals() const final { return totals_; }

 protected:
  /// `captured`: since 1970-01-01 UTC; 0: unknown.
  virtual Status append(const FrameSet& set, nanoseconds captured,
                        std::vector<std::uint8_t>& out) = 0;
  ExportTotals totals_;

 private:
  const std::filesystem::path folder_;
  const char* const ending_;
  const nanoseconds began_at_;
  std::vector<std::uint8_t> bytes_;
};

using AppendCloud = void (*)(const PointCloud&, nanoseconds, std::vector<std::uint8_t>&);

class CloudFiles final : public SetFiles {
 public:
  CloudFiles(std::filesystem::path folder, const char* ending, nanoseconds began_at,
             AppendCloud append_cloud, MergedCloud merged)
      : SetFiles(std::move(folder), ending, began_at),
        append_cloud_(append_cloud),
        merged_(std::move(merged)) {}

 private:
  Status append(const FrameSet& set, nanoseconds captured,
                std::vector<std::uint8_t>& out) override {
    merged_.merge(set, cloud_);
    totals_.points += cloud_.size();
    append_cloud_(cloud_, captured, out);
    return {};
  }
  const AppendCloud append_cloud_;
  MergedCloud merged_;
  PointCloud cloud_;
};

class GltfFiles final : public SetFiles {
 public:
  GltfFiles(std::filesystem::path folder, const ExportedRoom& room)
      : SetFiles(std::move(folder), "glb", room.began_at), scene_(room.sensors) {}

 private:
  Status append(const FrameSet& set, nanoseconds captured,
                std::vector<std::uint8_t>& out) override {
    return scene_.append(set, captured, out);
  }
  GltfScene scene_;
};

class FoxgloveFile final : public SetWriter {
 public:
  FoxgloveFile(FoxgloveWriter writer, MergedCloud merged)
      : writer_(std::move(writer)), merged_(std::move(merged)) {}

  Status add(const FrameSet& set) override {
    merged_.merge(set, cloud_);
    totals_.points += cloud_.size();
    ++totals_.sets;
    return writer_.add(set, cloud_);
  }
  Status finish() override { return writer_.finish(); }
  ExportTotals totals() const override { return totals_; }

 private:
  FoxgloveWriter writer_;
  MergedCloud merged_;
  PointCloud cloud_;
  ExportTotals totals_;
};

Result<std::unique_ptr<SetWriter>> make_foxglove_file(const std::filesystem::path& out,
                                                      const ExportedRoom& room,
                                                      const MergedCloudOptions& cloud, UpAxis up) {
  auto writer = FoxgloveWriter::create(out / "room.mcap", room.sensors, room.began_at, up);
  if (!writer) return writer.error();
  return std::unique_ptr<SetWriter>(
      std::make_unique<FoxgloveFile>(std::move(*writer), MergedCloud(room.sensors, cloud)));
}

}  // namespace

std::string_view name_of(ExportFormat format) {
  switch (format) {
    case ExportFormat::kPly:
      return "ply";
    case ExportFormat::kPcd:
      return "pcd";
    case ExportFormat::kGltf:
      return "gltf";
    case ExportFormat::kRig:
      return "rig";
    case ExportFormat::kTum:
      return "tum";
    case ExportFormat::kFoxglove:
      return "foxglove";
  }
  return "";
}

Result<std::unique_ptr<SetWriter>> make_set_writer(ExportFormat format,
                                                   const std::filesystem::path& out,
                                                   const ExportedRoom& room,
                                                   const MergedCloudOptions& cloud, UpAxis up) {
  if (auto status = cloud.check(); !status) return status.error();
  if (auto status = io::make_folder(out); !status) return status.error();
  switch (format) {
    case ExportFormat::kPly:
      return std::unique_ptr<SetWriter>(std::make_unique<CloudFiles>(
          out, "ply", room.began_at, append_ply, MergedCloud(room.sensors, cloud)));
    case ExportFormat::kPcd:
      return std::unique_ptr<SetWriter>(std::make_unique<CloudFiles>(
          out, "pcd", room.began_at, append_pcd, MergedCloud(room.sensors, cloud)));
    case ExportFormat::kGltf:
      return std::unique_ptr<SetWriter>(std::make_unique<GltfFiles>(out, room));
    case ExportFormat::kFoxglove:
      return make_foxglove_file(out, room, cloud, up);
    case ExportFormat::kRig:
    case ExportFormat::kTum:
      break;
  }
  return std::unique_ptr<SetWriter>(
      std::make_unique<FolderWriter>(out, room, format == ExportFormat::kTum));
}

}  // namespace roomcast::recording
