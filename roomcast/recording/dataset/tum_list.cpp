// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/dataset/tum_list.h"

#include <algorithm>
#include <charconv>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "roomcast/io/file_bytes.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::recording {
namespace {

constexpr std::size_t kMaxListBytes = 64U << 20U;
constexpr std::int64_t kLargestSeconds = 9'000'000'000;  // as nanoseconds they fit into 63 bits
constexpr std::int64_t kWholeSecond_ns = 1'000'000'000;
constexpr std::size_t kFractionDigits = 9;

bool all_digits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Requires digits only, few enough not to overflow.
std::int64_t number(std::string_view digits) {
  std::int64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

std::vector<std::string_view> words(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r";
  std::vector<std::string_view> found;
  for (std::size_t at = line.find_first_not_of(kSpace); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
    found.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kSpace, end);
  }
  return found;
}

Error bad_line(const std::filesystem::path& path, std::size_t line, const std::string& what) {
  return {ErrorCode::kMalformed, path.string() + " line " + std::to_string(line) + ": " + what};
}

/// Calls `use(words) -> problem` for every line that is neither empty nor a comment.
template <class Use>
Status for_each_line(const std::filesystem::path& path, const Use& use) {
  std::vector<std::uint8_t> bytes;
  if (Status status = io::read_file(path, kMaxListBytes, bytes); !status.ok()) return status;
  std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const auto line_words = words(line);
    if (line_words.empty() || line_words.front().front() == '#') continue;
    const std::string problem = use(line_words);
    if (!problem.empty()) return bad_line(path, line_number, problem);
  }
  return {};
}

constexpr const char* kNotATime = "the timestamp must be a number of seconds";
constexpr const char* kOutside = "the file must be inside the recording's folder";

}  // namespace

bool parse_seconds(std::string_view text, nanoseconds& time) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view whole = text.substr(0, point);
  std::string_view fraction = text.substr(std::min(point + 1, text.size()));
  if (!all_digits(whole) || whole.size() > 10 || number(whole) > kLargestSeconds) return false;
  if (!fraction.empty() && !all_digits(fraction)) return false;
  fraction = fraction.substr(0, kFractionDigits);
  std::int64_t ns = fraction.empty() ? 0 : number(fraction);
  for (std::size_t digits = fraction.size(); digits < kFractionDigits; ++digits) ns *= 10;
  ns += number(whole) * kWholeSecond_ns;
  time = nanoseconds(negative ? -ns : ns);
  return true;
}

Result<std::vector<ListedFile>> read_tum_list(const std::filesystem::path& path) {
  std::vector<ListedFile> files;
  const Status status = for_each_line(path, [&](const std::vector<std::string_view>& line) {
    ListedFile listed;
    if (line.size() < 2) return std::string("expected a timestamp and a file");
    if (!parse_seconds(line[0], listed.timestamp)) return std::string(kNotATime);
    listed.file = line[1];
    if (!stays_inside(listed.file)) return std::string(kOutside);
    if (!files.empty() && listed.timestamp <= files.back().timestamp) {
      return std::string("timestamps must grow from line to line");
    }
    files.push_back(std::move(listed));
    return std::string();
  });
  if (!status.ok()) return status.error();
  return files;
}

Result<std::map<std::string, std::string>> read_associations(
    const std::filesystem::path& path, const std::vector<ListedFile>& depth_files) {
  std::set<std::string_view> depth_names;
  for (const ListedFile& listed : depth_files) depth_names.insert(listed.file);
  std::map<std::string, std::string> color_of_depth;
  const Status status = for_each_line(path, [&](const std::vector<std::string_view>& line) {
    if (line.size() < 4) return std::string("expected two pairs of timestamp and file");
    const bool depth_first = depth_names.count(line[1]) != 0;
    const std::string_view depth = line[depth_first ? 1 : 3];
    const std::string_view color = line[depth_first ? 3 : 1];
    if (depth_names.count(depth) == 0) return std::string("neither file is listed in depth.txt");
    if (!stays_inside(color)) return std::string(kOutside);
    color_of_depth[std::string(depth)] = color;
    return std::string();
  });
  if (!status.ok()) return status.error();
  return color_of_depth;
}

std::vector<std::string> associate_by_time(const std::vector<ListedFile>& depth_files,
                                           const std::vector<ListedFile>& color_files,
                                           nanoseconds tolerance) {
  std::vector<std::string> color_of_depth;
  for (const ListedFile& depth : depth_files) {
    const auto distance = [&](const ListedFile& color) {
      return std::chrono::abs(color.timestamp - depth.timestamp);
    };
    auto nearest = std::lower_bound(
        color_files.begin(), color_files.end(), depth.timestamp,
        [](const ListedFile& color, nanoseconds time) { return color.timestamp < time; });
    if (nearest == color_files.end() ||
        (nearest != color_files.begin() && distance(*(nearest - 1)) < distance(*nearest))) {
      if (nearest != color_files.begin()) --nearest;
    }
    const bool found = nearest != color_files.end() && distance(*nearest) <= tolerance;
    color_of_depth.push_back(found ? nearest->file : std::string());
  }
  return color_of_depth;
}

std::string tum_seconds(nanoseconds time) {
  const std::int64_t ns = time.count();
  const std::int64_t whole = ns / kWholeSecond_ns, rest = std::abs(ns % kWholeSecond_ns);
  char text[40];
  std::snprintf(text, sizeof(text), "%s%" PRId64 ".%09" PRId64, ns < 0 && whole == 0 ? "-" : "",
                whole, rest);
  return text;
}

}  // namespace roomcast::recording
