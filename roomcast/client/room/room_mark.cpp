// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room/room_mark.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/mark_check.h"

namespace roomcast::client {
namespace {

namespace pb = wire::pb;

bool is_known(pb::MarkKind kind) {
  return kind >= pb::MARK_KIND_NOTE && kind <= pb::MARK_KIND_PLACE;
}

RoomMark mark_from_message(const pb::Mark& message, std::uint64_t own_tag) {
  const std::uint32_t rgb = message.color_rgb();
  RoomMark mark;
  mark.id = message.id();
  mark.kind = static_cast<MarkKind>(message.kind());
  mark.text = message.text();
  mark.author = message.author();
  mark.color = {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U),
                static_cast<std::uint8_t>(rgb)};
  mark.own = own_tag != 0 && message.author_tag() == own_tag;
  for (int i = 0; i + 2 < message.points_size(); i += wire::kNumbersPerPoint)
    mark.points_m.emplace_back(message.points(i), message.points(i + 1), message.points(i + 2));
  return mark;
}

}  // namespace

Result<pb::Mark> message_from_mark(const RoomMark& mark) {
  pb::Mark message;
  message.set_kind(static_cast<pb::MarkKind>(mark.kind));
  message.set_text(mark.text);
  for (const Eigen::Vector3f& point : mark.points_m) {
    for (const float number : point) message.add_points(number);
  }
  if (auto status = wire::check_mark(message); !status) return status.error();
  return message;
}

void RoomMarks::join(std::uint64_t author_tag) {
  author_tag_ = author_tag;
  if (!all_->empty()) all_ = std::make_shared<const List>();
}

void RoomMarks::take(const pb::Marks& message) {
  if (!message.all() && message.marks().empty() && message.removed().empty()) return;
  List marks = message.all() ? List() : *all_;
  const auto remove = [&](std::uint32_t id) {
    std::erase_if(marks, [&](const RoomMark& mark) { return mark.id == id; });
  };
  for (const std::uint32_t id : message.removed()) remove(id);
  for (const pb::Mark& given : message.marks()) {
    remove(given.id());
    if (is_known(given.kind())) marks.push_back(mark_from_message(given, author_tag_));
  }
  std::ranges::sort(marks, {}, &RoomMark::id);
  all_ = std::make_shared<const List>(std::move(marks));
}

}  // namespace roomcast::client
