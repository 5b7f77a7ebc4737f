// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/comparison_pictures.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "roomcast/io/file_bytes.h"

namespace roomcast::study {
namespace {

namespace fs = std::filesystem;

std::string lower_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

/// Pictures by their names without ending.
Result<std::map<std::string, fs::path>> pictures_in(const fs::path& folder) {
  std::map<std::string, fs::path> found;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string ending = lower_ending(at->path());
    if (ending == ".png" || ending == ".jpg" || ending == ".jpeg")
      found[at->path().stem().string()] = at->path();
  }
  if (error)
    return Error{ErrorCode::kNotFound,
                 "cannot read the folder " + folder.string() + ": " + error.message()};
  return found;
}

/// By the first bytes: what a file is called says nothing. Empty: neither.
std::string content_type_of(const std::string& bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  return "";
}

}  // namespace

Result<ComparisonPictures> ComparisonPictures::find(const StudyPlan& plan, const fs::path& folder) {
  ComparisonPictures pictures;
  for (const Comparison& comparison : plan.comparisons) {
    const auto real = pictures_in(folder / comparison.real);
    if (!real) return real.error();
    const auto drawn = pictures_in(folder / comparison.drawn);
    if (!drawn) return drawn.error();
    auto& pairs = pictures.pairs_[comparison.name];
    for (const auto& [name, file] : *real) {
      const auto other = drawn->find(name);
      if (other != drawn->end()) pairs.push_back({name, file, other->second});
    }
    if (pairs.empty())
      return Error{ErrorCode::kNotFound,
                   fmt::format("the comparison \"{}\" has no pairs: no PNG or JPEG file of \"{}\" "
                               "has the name of one of \"{}\"",
                               comparison.name, comparison.real, comparison.drawn)};
    if (pairs.size() > kMaxPairs)
      return Error{ErrorCode::kTooLarge,
                   fmt::format("the comparison \"{}\" has {} pairs; {} may be", comparison.name,
                               pairs.size(), kMaxPairs)};
  }
  return pictures;
}

std::vector<std::string> ComparisonPictures::pairs(const std::string& comparison) const {
  std::vector<std::string> names;
  if (const auto found = pairs_.find(comparison); found != pairs_.end())
    for (const Pair& pair : found->second) names.push_back(pair.name);
  return names;
}

Result<ComparisonPictures::Picture> ComparisonPictures::read(const std::string& comparison,
                                                             std::size_t pair, bool is_real) const {
  const auto found = pairs_.find(comparison);
  if (found == pairs_.end() || pair >= found->second.size())
    return Error{ErrorCode::kNotFound, "this study has no such pair of pictures"};
  const Pair& files = found->second[pair];
  std::vector<std::uint8_t> bytes;
  if (auto status = io::read_file(is_real ? files.real : files.drawn, kMaxPictureBytes, bytes);
      !status)
    return status.error();
  Picture picture{.content_type = {}, .bytes = {bytes.begin(), bytes.end()}};
  picture.content_type = content_type_of(picture.bytes);
  if (picture.content_type.empty())
    return Error{ErrorCode::kMalformed,
                 "a picture of the pair \"" + files.name + "\" is neither PNG nor JPEG"};
  return picture;
}

}  // namespace roomcast::study
