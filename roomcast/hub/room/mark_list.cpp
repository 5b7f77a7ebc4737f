// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/mark_list.h"

#include <algorithm>
#include <string>
#include <utility>

#include "roomcast/wire/limits.h"
#include "roomcast/wire/mark_check.h"

namespace roomcast::hub {

namespace {

namespace pb = wire::pb;

constexpr std::size_t kMaxBytesPerMessage = wire::kMaxControlFromHubBytes / 2;

int points_of(const pb::Mark& mark) {
  return mark.points_size() / wire::kNumbersPerPoint;
}

Error full(std::string sentence) {
  return {ErrorCode::kUnavailable, std::move(sentence)};
}

}  // namespace

void MarkList::remember(std::vector<pb::Mark> marks) {
  for (pb::Mark& mark : marks) {
    next_id_ = std::max(next_id_, mark.id());
    (void)add(std::move(mark));
  }
}

Result<pb::Mark> MarkList::add(pb::Mark mark) {
  if (marks_.size() >= std::size_t{wire::kMaxMarks}) {
    return full("this room has " + std::to_string(wire::kMaxMarks) +
                " marks, as many as it may have: remove some first");
  }
  if (points_ + points_of(mark) > wire::kMaxPointsOfMarks) {
    return full(
        "the sketches of this room have as many points as they may have: remove some first");
  }
  int& of_author = of_author_[mark.author_tag()];
  if (of_author >= wire::kMaxMarksOfAuthor) {
    return full("you have left " + std::to_string(of_author) +
                " marks here, as many as one person may: remove some first");
  }
  ++of_author;
  points_ += points_of(mark);
  mark.set_id(next_id_++);
  return marks_.emplace(mark.id(), std::move(mark)).first->second;
}

std::vector<std::uint32_t> MarkList::remove(std::span<const std::uint32_t> ids, Remover remover) {
  std::vector<std::uint32_t> removed;
  for (const std::uint32_t id : ids) {
    const auto found = marks_.find(id);
    if (found == marks_.end()) continue;
    const pb::Mark& mark = found->second;
    const bool is_own = remover.author_tag != 0 && mark.author_tag() == remover.author_tag;
    if (!is_own && !remover.may_remove_all) continue;
    points_ -= points_of(mark);
    const auto author = of_author_.find(mark.author_tag());
    if (--author->second == 0) of_author_.erase(author);
    marks_.erase(found);
    removed.push_back(id);
  }
  return removed;
}

std::vector<pb::Control> MarkList::messages() const {
  std::vector<pb::Control> messages;
  std::size_t bytes = 0;
  for (const auto& [id, mark] : marks_) {
    if (messages.empty() || bytes + mark.ByteSizeLong() > kMaxBytesPerMessage) {
      messages.emplace_back().mutable_marks()->set_all(messages.size() == 1);
      bytes = 0;
    }
    bytes += mark.ByteSizeLong();
    *messages.back().mutable_marks()->add_marks() = mark;
  }
  return messages;
}

}  // namespace roomcast::hub
