// SPDX-License-Identifier: Apache-2.0
// What people leave in a Room for the others, and who shows them around.
#include <utility>
#include <vector>

#include "roomcast/hub/access/author_tag.h"
#include "roomcast/hub/room/room.h"
#include "roomcast/wire/mark_check.h"

namespace roomcast::hub {

namespace pb = wire::pb;

namespace {

pb::Control refusal_message(std::string sentence) {
  pb::Control control;
  control.mutable_marks()->set_refusal(std::move(sentence));
  return control;
}

pb::Control guide_message(std::optional<ViewerId> guide) {
  pb::Control control;
  control.mutable_guide()->set_on(guide.has_value());
  if (guide) control.mutable_guide()->set_viewer_id(guide->value);
  return control;
}

}  // namespace

/// The reason why this viewer may not change marks now; empty: it may.
std::string Room::why_not_mark(Viewer& viewer, RoomTime now) {
  if (!viewer.may_mark) return "this room's owner does not let you leave marks";
  if (viewer.marks.take(1, HostTime(now.time_since_epoch()))) return {};
  return "that was too much at once: wait a few seconds";
}

RoomActions Room::take_mark(ConnectionId from, Viewer& viewer, const pb::Mark& given,
                            RoomTime now) {
  const auto refuse_mark = [from](std::string sentence) {
    return RoomActions{SendControl{{from}, refusal_message(std::move(sentence))}};
  };
  if (auto why = why_not_mark(viewer, now); !why.empty()) return refuse_mark(std::move(why));
  pb::Mark mark = given;
  mark.set_author(viewer.name);
  mark.set_color_rgb(viewer.color_rgb);
  mark.set_author_tag(viewer.author_tag);
  if (auto s = wire::check_mark(mark); !s) return refuse_mark(s.error().message);
  auto added = marks_.add(std::move(mark));
  if (!added) return refuse_mark(added.error().message);
  pb::Control news;
  *news.mutable_marks()->add_marks() = *added;
  RoomActions out;
  out.push_back(SaveMarks{.added = {*std::move(added)}});
  out.push_back(SendControl{viewer_connections(), std::move(news)});
  return out;
}

RoomActions Room::remove_marks(ConnectionId from, Viewer& viewer, const pb::RemoveMarks& removal,
                               RoomTime now) {
  RoomActions out;
  auto why = why_not_mark(viewer, now);
  std::vector<std::uint32_t> removed;
  if (why.empty()) {
    const std::vector<std::uint32_t> ids(removal.ids().begin(), removal.ids().end());
    removed =
        marks_.remove(ids, {.author_tag = viewer.author_tag, .may_remove_all = viewer.may_nudge});
    if (removed.empty()) why = "only its author and the room's admins can remove a mark";
  }
  if (!why.empty()) {
    out.push_back(SendControl{{from}, refusal_message(std::move(why))});
    return out;
  }
  pb::Control news;
  news.mutable_marks()->mutable_removed()->Assign(removed.begin(), removed.end());
  out.push_back(SaveMarks{.removed = std::move(removed)});
  out.push_back(SendControl{viewer_connections(), std::move(news)});
  return out;
}

void Room::tell_marks(ConnectionId newcomer, RoomActions& out) const {
  for (pb::Control& message : marks_.messages()) {
    out.push_back(SendControl{{newcomer}, std::move(message)});
  }
  if (guide_) out.push_back(SendControl{{newcomer}, guide_message(guide_)});
}

/// Whoever begins last guides; who has ended, or has left, guides nobody.
RoomActions Room::set_guide(ViewerId viewer, bool guides) {
  if (!guides && guide_ != viewer) return {};
  guide_ = guides ? std::optional(viewer) : std::nullopt;
  RoomActions out;
  if (!viewers_.empty()) out.push_back(SendControl{viewer_connections(), guide_message(guide_)});
  return out;
}

}  // namespace roomcast::hub
