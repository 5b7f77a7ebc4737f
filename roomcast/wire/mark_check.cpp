// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/mark_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "roomcast/wire/limits.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::wire {
namespace {

Error malformed_mark(std::string sentence) {
  return {ErrorCode::kMalformed, std::move(sentence)};
}

struct MarkShape {
  int min_points, max_points;
  bool has_text;
};

/// The points of a mark, and whether it needs words; nothing for a kind of a later version.
std::optional<MarkShape> shape_of(pb::MarkKind kind) {
  switch (kind) {
    case pb::MARK_KIND_NOTE:
      return MarkShape{1, 1, true};
    case pb::MARK_KIND_SKETCH:
      return MarkShape{2, kMaxMarkPoints, false};
    case pb::MARK_KIND_DISTANCE:
      return MarkShape{2, 2, false};
    case pb::MARK_KIND_PLACE:
      return MarkShape{2, 2, true};
    default:
      return std::nullopt;
  }
}

Status check_points(const pb::Mark& mark) {
  const int numbers = mark.points_size();
  if (numbers > kNumbersPerPoint * kMaxMarkPoints) {
    return Error{ErrorCode::kTooLarge,
                 "this mark has " + std::to_string(numbers / kNumbersPerPoint) +
                     " points, and a mark may have " + std::to_string(kMaxMarkPoints) +
                     ": draw it as several lines"};
  }
  const auto is_near = [](float metres) { return std::abs(metres) <= kMaxPosition_m; };
  if (!std::ranges::all_of(mark.points(), is_near)) return malformed_mark("a mark is out of range");
  return {};
}

Status check_shape(const pb::Mark& mark, const MarkShape& shape) {
  const int numbers = mark.points_size();
  const int points = numbers / kNumbersPerPoint;
  if (numbers % kNumbersPerPoint != 0 || points < shape.min_points || points > shape.max_points) {
    return malformed_mark("this mark has the wrong number of points for its kind");
  }
  if (mark.text().empty() == shape.has_text) {
    return malformed_mark(shape.has_text ? "a note and a place need words"
                                         : "a sketch and a distance have no words");
  }
  if (mark.kind() == pb::MARK_KIND_PLACE) return check_name(mark.text(), "place");
  return {};
}

/// Also of a kind of a later version, which a viewer need not show.
Status check_any_mark(const pb::Mark& mark) {
  if (auto s = check_points(mark); !s) return s;
  if (auto s = check_name(mark.author(), "author"); !s) return s;
  if (auto s = check_text(mark.text(), kMaxMarkTextBytes, "a note"); !s) return s;
  const auto shape = shape_of(mark.kind());
  return shape ? check_shape(mark, *shape) : Status();
}

}  // namespace

Status check_mark(const pb::Mark& mark) {
  if (!shape_of(mark.kind()))
    return malformed_mark("a mark is a note, a sketch, a distance or a place");
  return check_any_mark(mark);
}

Status check_marks(const pb::Marks& message) {
  if (message.marks_size() > kMaxMarks || message.removed_size() > kMaxMarks) {
    return Error{ErrorCode::kTooLarge, "there are more marks than a room may have"};
  }
  for (const pb::Mark& mark : message.marks()) {
    if (auto s = check_any_mark(mark); !s) return s;
  }
  return {};
}

Status check_remove_marks(const pb::RemoveMarks& message) {
  if (message.ids_size() > kMaxMarks) {
    return Error{ErrorCode::kTooLarge, "there are more marks to remove than a room may have"};
  }
  return {};
}

}  // namespace roomcast::wire
